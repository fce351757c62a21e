// SPDX-License-Identifier: MIT
#include "offset_run.hpp"

#include <string>

#include "lengths.hpp"
#include "planish/measures/metrics.hpp"

namespace planish::workflow {

std::vector<OptionRow> offset_option_rows() {
  return {{"--distance", "D", "model units; positive is outside"},
          kModelUnitRow,
          {"--kind", "KIND",
           "face (the planes at the distance), vertex (the points) or parallel\n"
           "(the edges, axes nearest to the normals); default the first there is"}};
}

OffsetOptions offset_options(const Request& request) {
  OffsetOptions options;
  if (!request.has("--distance")) throw UsageError("--distance D is missing");
  read_length(request, "--distance", model_unit(request), options.distance);
  if (const auto word = request.value("--kind")) {
    options.kind = offset_kind(*word);
    if (!options.kind) throw UsageError("--kind must be face, vertex or parallel");
  }
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  return options;
}

namespace {

Json spread_json(const Spread& spread) {
  return {{"min", spread.min}, {"mean", spread.mean}, {"max", spread.max}};
}

}  // namespace

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

bool is_flat(const Mesh& mesh, const MeshOffset& offset) {
  return planarity_summary(mesh, offset.positions).max_excess <= PlanarPolygon::kTolerance;
}

std::vector<std::string> offset_sentences(const Mesh& mesh, const MeshOffset& offset) {
  std::vector<std::string> sentences;
  // Where the axes cannot follow the normals, an offset goes through the mesh.
  if (offset.report.nodes.min < 0.0 && offset.report.nodes.max > 0.0) {
    sentences.emplace_back(
        "the offset lies on both sides of the mesh, which has no better parallel one");
  }
  if (const int edges = offset.report.turned_edges; edges > 0) {
    sentences.push_back((edges == 1 ? "1 edge runs" : std::to_string(edges) + " edges run") +
                        " the other way: the distance is too large for them");
  }
  if (const auto damage = damage_sentence(damage_json(mesh, mesh.positions, offset.positions))) {
    sentences.push_back(*damage);
  }
  if (!is_flat(mesh, offset)) {
    sentences.emplace_back(
        "not flat: the edges are not quite parallel, and a panel is out of its plane");
  }
  return sentences;
}

}  // namespace planish::workflow
