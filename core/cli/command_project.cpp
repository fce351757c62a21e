// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "edit_options.hpp"
#include "files.hpp"
#include "planish/metrics.hpp"
#include "planish/projection.hpp"

namespace planish::cli {
namespace {

ProjectionOptions projection_options(const Arguments& arguments) {
  ProjectionOptions options;
  if (const auto text = arguments.value("--fairness")) options.fairness = parse_fairness(*text);
  if (const auto text = arguments.value("--solver")) options.engine = parse_engine(*text);
  if (const auto text = arguments.value("--tolerance")) {
    options.tolerance = parse_finite(*text, "--tolerance");
  }
  if (const auto problem = find_problem(options)) throw CommandError(kWrongUsage, *problem);
  return options;
}

ProjectionResult solve(const Mesh& mesh, const Arguments& arguments,
                       const ProjectionOptions& options) {
  const std::vector<int> pins = parse_pins(arguments, mesh);
  const auto reference = arguments.value("--reference");
  if (!reference) return project_to_planar(mesh, options, pins, progress_line());
  const Mesh base = load_mesh(*reference).mesh;
  if (base.vertex_count() != mesh.vertex_count() || base.face_offsets != mesh.face_offsets ||
      base.face_vertices != mesh.face_vertices) {
    throw CommandError(kInvalidMesh, *reference + ": the reference must have the faces of MESH");
  }
  return project_to_planar(mesh, base.positions, options, pins, progress_line());
}

ExitCode run_project(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const ProjectionOptions options = projection_options(arguments);
  const Mesh mesh = load_mesh(arguments.only_positional("MESH")).mesh;
  const ProjectionResult result = solve(mesh, arguments, options);
  clear_progress_line();
  Mesh flat = mesh;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    flat.positions.col(result.moved[k]) = result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  if (output) {
    GlbContent content;
    content.base = mesh.positions;
    save_mesh(*output, flat, content);
  }
  Json json = Json::object();
  add_solve(json, result.report, options.engine);
  json["mesh"] = mesh_json(mesh);
  json["planarity_mm_per_m"] = planarity_json(mesh, mesh.positions, flat.positions);
  json["rms_move"] = result.rms_move;
  json["max_move"] = result.max_move;
  json["failing_faces"] = result.failing_faces;
  json["spoilt_faces"] = damage_json(mesh, mesh.positions, flat.positions);
  print_damage(json["spoilt_faces"]);
  save_report(arguments, json);
  return exit_code(result.report);
}

}  // namespace

Command project_command() {
  return {"project",
          "MESH [--reference BASE] [options] [-o OUT] [--report R.json]",
          "make every panel flat, moving as little as possible",
          {{"--reference", "BASE", "vertices that sit where BASE has them prefer to stay"},
           {"--pin", "V,V,...", "vertices that stay where they are"},
           {"--fairness", "KIND", "laplacian, second or third; default second"},
           {"--solver", "NAME", "newton or alm; default newton"},
           {"--tolerance", "MM_PER_M", "flatness of the result, default 1e-6"},
           kOutputRow,
           kReportRow},
          run_project};
}

}  // namespace planish::cli
