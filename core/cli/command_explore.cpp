// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "commands.hpp"
#include "design_output.hpp"
#include "edit_options.hpp"
#include "files.hpp"
#include "planish/metrics.hpp"
#include "planish/projection.hpp"
#include "planish/slider_stops.hpp"
#include "planish/subspace.hpp"

namespace planish::cli {
namespace {

SubspaceOptions subspace_options(const Arguments& arguments, const HandleEditOptions& edit) {
  SubspaceOptions options;
  const auto dimension = arguments.value("--dimension");
  if (!dimension) throw CommandError(kWrongUsage, "--dimension is missing");
  options.dimension = parse_whole(*dimension, "--dimension");
  options.eigenbasis = arguments.has("--eigen");
  options.fairness = edit.fairness;
  options.engine = edit.engine;
  if (const auto problem = find_problem(options)) throw CommandError(kWrongUsage, *problem);
  return options;
}

/// Slider values, all 0 without --coefficients.
Eigen::VectorXd coefficients(const Arguments& arguments, int dimension) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(dimension);
  const auto text = arguments.value("--coefficients");
  if (!text) return values;
  const auto words = split_at_commas(*text);
  if (words.size() != static_cast<std::size_t>(dimension)) {
    throw CommandError(kWrongUsage, "--coefficients needs " + std::to_string(dimension) +
                                        " values, here are " + std::to_string(words.size()));
  }
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    values[k] = parse_finite(words[static_cast<std::size_t>(k)], "--coefficients");
  }
  return values;
}

/// The edited mesh with the sliders at `values`.
Positions with_sliders(const Positions& edited, const Subspace& subspace,
                       const Eigen::VectorXd& values) {
  Positions support_positions(3, static_cast<Eigen::Index>(subspace.support.size()));
  // The solver may find fewer vectors than asked for; the sliders of the others do nothing.
  evaluate(subspace, values.head(subspace.dimension()), support_positions);
  Positions result = edited;
  for (std::size_t k = 0; k < subspace.support.size(); ++k) {
    result.col(subspace.support[k]) = support_positions.col(static_cast<Eigen::Index>(k));
  }
  return result;
}

/// The exact mesh next to `explored`, unmoved vertices of the base staying where they are.
ProjectionResult make_exact(const EditRun& run, const Positions& explored,
                            const HandleEditOptions& edit, const std::vector<int>& held) {
  Mesh mesh = run.base.mesh;
  mesh.positions = explored;
  ProjectionResult result =
      project_to_planar(mesh, run.base.mesh.positions, exact_options(edit), held, progress_line());
  clear_progress_line();
  return result;
}

std::vector<int> handle_vertices(const EditTargets& targets) {
  std::vector<int> vertices;
  for (const Handle& handle : targets.handles) vertices.push_back(handle.vertex);
  return vertices;
}

/// A slider follows the flat meshes to first order only.
void print_not_exact(const Mesh& base, const Positions& positions, double tolerance) {
  const PlanaritySummary flatness = planarity_summary(base, positions);
  if (flatness.max_excess <= tolerance) return;
  std::array<char, 32> worst{};
  std::snprintf(worst.data(), worst.size(), "%.3g", flatness.max_excess);
  print_message(std::string("panels are up to ") + worst.data() +
                " mm/m out of flat, as the sliders show them; --exact makes them flat");
}

Json stop_json(const SliderStop& stop) {
  if (stop.face < 0) return nullptr;
  return {{"value", stop.value}, {"face", stop.face}};
}

/// Of each slider: how far it goes either way, the others where they are, and what stops it there.
Json stops_json(const std::vector<SliderRange>& ranges) {
  Json json = Json::array();
  for (const SliderRange& range : ranges) {
    json.push_back({{"lower", stop_json(range.lower)}, {"upper", stop_json(range.upper)}});
  }
  return json;
}

/// The report's figures become those of the variation; the edit before it keeps its own.
void add_variation(Json& json, const EditRun& run, const Positions& after) {
  for (const char* key : {"objective", "moved_vertices", "max_displacement", "handle_error"}) {
    json["edit"][key] = json[key];
  }
  json.erase("objective");  // only the edit has one
  const Positions moves = after - run.base.mesh.positions;
  double handle_error = 0.0;
  for (const Handle& handle : run.targets.handles) {
    handle_error = std::max(handle_error, (after.col(handle.vertex) - handle.target).norm());
  }
  json["moved_vertices"] = (moves.array() != 0.0).colwise().any().count();
  json["max_displacement"] = moves.colwise().norm().maxCoeff();
  json["handle_error"] = handle_error;
}

ExitCode run_explore(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const HandleEditOptions options = edit_options(arguments);
  if (!options.bounds.empty()) {
    throw CommandError(kWrongUsage,
                       "--bound: variations keep no stated limits; limits are for edit");
  }
  if (!options.constraints.empty()) {
    throw CommandError(kWrongUsage, "--constraint: variations keep panels flat and nothing else");
  }
  const SubspaceOptions basis_options = subspace_options(arguments, options);
  const Eigen::VectorXd values = coefficients(arguments, basis_options.dimension);
  const EditRun run = run_edit_solver(arguments, options);
  const std::vector<int> held = held_vertices(run.base.mesh, run.targets, options);
  const Subspace subspace =
      compute_subspace(run.base.mesh, run.edited, handle_vertices(run.targets), basis_options, held,
                       progress_line());
  clear_progress_line();
  Mesh result = run.base.mesh;
  result.positions = with_sliders(run.edited, subspace, values);
  ExitCode code = exit_code(run.report);
  Json exact;
  if (arguments.has("--exact")) {
    const ProjectionResult projection = make_exact(run, result.positions, options, held);
    for (std::size_t k = 0; k < projection.moved.size(); ++k) {
      result.positions.col(projection.moved[k]) =
          projection.moved_positions.col(static_cast<Eigen::Index>(k));
    }
    exact = {{"status", status_name(projection.report.status)},
             {"rms_move", projection.rms_move},
             {"max_move", projection.max_move}};
    if (code == kDone) code = exit_code(projection.report);
  }
  const DesignVariation variation{
      basis_options, {values.begin(), values.end()}, arguments.has("--exact")};
  const Design design = make_design(run, options, {variation}, result.positions);
  save_design(arguments, design);
  if (output) {
    GlbContent content;
    content.base = run.base.mesh.positions;
    content.design = design_for_glb(design);
    content.variations = variations_of(subspace);
    save_mesh(*output, result, content);
  }
  Json json = edit_json(run, result.positions, options.engine);
  print_damage(json["spoilt_faces"]);
  print_outcome(run.report);
  if (exact.is_null()) print_not_exact(run.base.mesh, result.positions, options.tolerance);
  add_variation(json, run, result.positions);
  json["subspace"] = subspace_json(subspace.report, subspace.dimension());
  json["subspace"]["stops"] = stops_json(
      slider_ranges(run.base.mesh, run.edited, subspace, values.head(subspace.dimension())));
  if (!exact.is_null()) json["exact"] = exact;
  save_report(arguments, json);
  return code;
}

}  // namespace

Command explore_command() {
  std::vector<OptionRow> rows = edit_option_rows();
  rows.insert(rows.end(), {{"--dimension", "S", "number of variations, 1 … 24"},
                           {"--coefficients", "x1,...,xS", "slider values, default all 0"},
                           {"--exact", "", "make every panel flat again before writing"},
                           {"--eigen", "", "order the variations from smooth to stiff"},
                           kOutputRow,
                           kReportRow,
                           kDesignRow});
  return {"explore",
          "MESH <edit options> --dimension S [options] [-o OUT] [--report R.json]\n"
          "      [--design D.json]",
          "an edit with a family of local variations around it", rows, run_explore};
}

}  // namespace planish::cli
