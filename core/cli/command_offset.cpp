// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <variant>

#include "commands.hpp"
#include "design_input.hpp"
#include "files.hpp"
#include "planish/metrics.hpp"
#include "planish/offset/mesh_offset.hpp"
#include "report.hpp"

namespace planish::cli {
namespace {

OffsetOptions offset_options(const Arguments& arguments) {
  OffsetOptions options;
  const auto distance = arguments.value("--distance");
  if (!distance) throw CommandError(kWrongUsage, "--distance D is missing");
  options.distance = parse_finite(*distance, "--distance");
  if (const auto word = arguments.value("--kind")) {
    options.kind = offset_kind(*word);
    if (!options.kind) throw CommandError(kWrongUsage, "--kind must be face, vertex or parallel");
  }
  if (const auto problem = find_problem(options)) throw CommandError(kWrongUsage, *problem);
  return options;
}

Json spread_json(const Spread& spread) {
  return {{"min", spread.min}, {"mean", spread.mean}, {"max", spread.max}};
}

Json offset_json(const Mesh& mesh, const MeshOffset& offset, double distance) {
  const OffsetReport& report = offset.report;
  Json json = {{"status", "done"}, {"kind", kind_name(report.kind)}, {"distance", distance}};
  json["deviation"] = report.kind == OffsetKind::kParallel ? Json() : Json(report.deviation);
  json["panels"] = spread_json(report.panels);
  json["heights"] = spread_json(report.heights);
  json["nodes"] = spread_json(report.nodes);
  json["edge_residual"] = report.edge_residual;
  json["largest_lean"] = report.largest_lean;
  json["turned_edges"] = report.turned_edges;
  json["mesh"] = mesh_json(mesh);
  json["planarity_mm_per_m"] = planarity_json(mesh, mesh.positions, offset.positions);
  json["spoilt_faces"] = damage_json(mesh, mesh.positions, offset.positions);
  return json;
}

void print_turned(int edges) {
  if (edges == 0) return;
  print_message((edges == 1 ? "1 edge runs" : std::to_string(edges) + " edges run") +
                " the other way: the distance is too large for them");
}

/// Where the axes cannot follow the normals, an offset goes through the mesh.
void print_crossing(const Spread& nodes) {
  if (nodes.min < 0.0 && nodes.max > 0.0) {
    print_message("the offset lies on both sides of the mesh, which has no better parallel one");
  }
}

ExitCode run_offset(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const OffsetOptions options = offset_options(arguments);
  const std::string path = arguments.only_positional("MESH");
  const Mesh mesh = load_mesh(path).mesh;
  auto result = offset_mesh(mesh, options);
  if (const auto* why = std::get_if<std::string>(&result)) refuse_file(path, *why);
  const auto& offset = std::get<MeshOffset>(result);
  Mesh moved = mesh;
  moved.positions = offset.positions;
  if (output) save_mesh(*output, moved);
  const Json json = offset_json(mesh, offset, options.distance);
  print_crossing(offset.report.nodes);
  print_turned(offset.report.turned_edges);
  print_damage(json["spoilt_faces"]);
  save_report(arguments, json);
  if (planarity_summary(moved).max_excess <= PlanarPolygon::kTolerance) return kDone;
  print_message("not flat: the edges are not quite parallel, and a panel is out of its plane");
  return kToleranceNotMet;
}

}  // namespace

Command offset_command() {
  return {"offset",
          "MESH --distance D [--kind KIND] [-o OUT] [--report R.json]",
          "the mesh at a distance, every edge parallel to its own",
          {{"--distance", "D", "model units; positive is outside"},
           {"--kind", "KIND",
            "face (the planes at the distance), vertex (the points) or parallel\n"
            "(the edges, axes nearest to the normals); default the first there is"},
           kOutputRow,
           kReportRow},
          run_offset};
}

}  // namespace planish::cli
