// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "edit_options.hpp"
#include "files.hpp"
#include "planish/metrics.hpp"
#include "planish/planarising.hpp"
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
  if (const auto text = arguments.value("--smooth")) {
    options.fairness_weight = parse_finite(*text, "--smooth");
  } else if (!arguments.has("--reference")) {
    options.fairness_weight = Planarising{}.fairness_weight;
  }
  const Bounds bounds = parse_bounds(arguments);
  if (!bounds.limits.empty()) {
    throw CommandError(kWrongUsage,
                       "--bound: project keeps the panels' shape; limits are for edit");
  }
  options.keep_shape = bounds.keep_shape;
  options.constraints = parse_constraints(arguments, options.tolerance);
  if (const auto problem = find_problem(options)) throw CommandError(kWrongUsage, *problem);
  return options;
}

ProjectionResult solve(const Mesh& mesh, const Arguments& arguments,
                       const ProjectionOptions& options) {
  std::vector<int> pins = parse_pins(arguments, mesh);
  if (arguments.has("--keep-boundary")) {
    const std::vector<int> boundary = boundary_vertices(mesh);
    pins.insert(pins.end(), boundary.begin(), boundary.end());
  }
  const auto reference = arguments.value("--reference");
  if (!reference) return project_to_planar(mesh, options, pins, progress_line());
  const Mesh base = load_mesh(*reference).mesh;
  if (base.vertex_count() != mesh.vertex_count() || base.face_offsets != mesh.face_offsets ||
      base.face_vertices != mesh.face_vertices) {
    throw CommandError(kInvalidMesh, *reference + ": the reference must have the faces of MESH");
  }
  return project_to_planar(mesh, base.positions, options, pins, progress_line());
}

/// What to do where shape and flatness cannot both be had.
void print_not_flat(const ProjectionResult& result, const ProjectionOptions& options) {
  if (result.report.status != SolveStatus::kToleranceNotMet || !options.keep_shape) return;
  print_message(std::to_string(result.failing_faces.size()) +
                " panels cannot become flat and keep their shape; --bound shape=off gives up the "
                "shape, a higher --smooth goes farther away");
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
  json["remake"] = remake_json(mesh, flat.positions);
  json["smooth"] = result.fairness_weight;
  print_damage(json["spoilt_faces"]);
  print_not_flat(result, options);
  save_report(arguments, json);
  return exit_code(result.report);
}

}  // namespace

Command project_command() {
  return {"project",
          "MESH [--reference BASE] [options] [-o OUT] [--report R.json]",
          "make every panel flat, close by and fair",
          {{"--smooth", "A",
            "weight α_f, 0 … 10000, default 10, with --reference 0: higher is\n"
            "fairer and farther away, 0 the nearest flat mesh"},
           {"--bound", "NAME=VALUE",
            "shape=on|off, default on: no panel becomes concave, crossing,\n"
            "turned over or collapsed that was not"},
           {"--reference", "BASE", "vertices that sit where BASE has them prefer to stay"},
           {"--pin", "V,V,...", "vertices that stay where they are"},
           {"--keep-boundary", "", "boundary points stay"},
           {"--fairness", "KIND", "laplacian, second or third; default second"},
           kConstraintRow,
           {"--solver", "NAME", "newton or alm; default newton"},
           {"--tolerance", "MM_PER_M", "flatness of the result, default 1e-6"},
           kOutputRow,
           kReportRow},
          run_project};
}

}  // namespace planish::cli
