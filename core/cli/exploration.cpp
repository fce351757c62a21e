// SPDX-License-Identifier: MIT
#include "exploration.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "design_output.hpp"
#include "planish/adjacency.hpp"
#include "planish/mesh_standing.hpp"
#include "planish/slider_stops.hpp"

namespace planish::cli {
namespace {

Violations violations_of(const EditRun& run, const Positions& positions, const KeptKinds& kept) {
  Mesh mesh = run.base.mesh;
  mesh.positions = positions;
  return measure_standing(mesh, build_adjacency(mesh), kept).worst;
}

}  // namespace

std::vector<OptionRow> family_option_rows() {
  return {{"--dimension", "S", "number of variations, 1 … 24"},
          {"--coefficients", "x1,...,xS", "slider values, default all 0"},
          {"--exact", "", "make every panel flat again before writing"},
          {"--eigen", "", "order the variations from smooth to stiff"}};
}

SubspaceOptions subspace_options(const Arguments& arguments, const HandleEditOptions& edit) {
  if (!edit.bounds.empty()) {
    throw CommandError(kWrongUsage,
                       "--bound: variations keep no stated limits; limits are for edit");
  }
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

namespace {

std::vector<int> handle_vertices(const EditTargets& targets) {
  std::vector<int> vertices;
  for (const Handle& handle : targets.handles) vertices.push_back(handle.vertex);
  return vertices;
}

}  // namespace

Family find_family(const EditRun& run, const HandleEditOptions& edit,
                   const SubspaceOptions& options, const Progress& progress) {
  Family family{edit, options, held_in_variations(run.base.mesh, run.targets, edit), {}};
  family.subspace =
      compute_subspace(run.base.mesh, run.edited, handle_vertices(run.targets), options,
                       family.held, kept_kinds(edit.tolerance, edit.constraints), progress);
  return family;
}

Variation with_sliders(const EditRun& run, const Family& family, const Eigen::VectorXd& values) {
  const Subspace& subspace = family.subspace;
  Positions support_positions(3, static_cast<Eigen::Index>(subspace.support.size()));
  // The solver may find fewer vectors than asked for; the sliders of the others do nothing.
  evaluate(subspace, values.head(subspace.dimension()), support_positions);
  Variation variation{values, run.edited, std::nullopt};
  for (std::size_t k = 0; k < subspace.support.size(); ++k) {
    variation.positions.col(subspace.support[k]) =
        support_positions.col(static_cast<Eigen::Index>(k));
  }
  return variation;
}

Variation make_exact(const EditRun& run, const Family& family, Variation shown,
                     const Progress& progress) {
  Mesh mesh = run.base.mesh;
  mesh.positions = shown.positions;
  shown.exact = project_to_planar(mesh, run.base.mesh.positions, exact_options(family.edit),
                                  family.held, progress);
  for (std::size_t k = 0; k < shown.exact->moved.size(); ++k) {
    shown.positions.col(shown.exact->moved[k]) =
        shown.exact->moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return shown;
}

Design variation_design(const EditRun& run, const Family& family, const Variation& variation) {
  const DesignVariation recipe{family.options,
                               {variation.values.begin(), variation.values.end()},
                               variation.exact.has_value()};
  return make_design(run, family.edit, {recipe}, variation.positions);
}

std::optional<std::string> not_exact_sentence(const EditRun& run, const Family& family,
                                              const Variation& variation) {
  if (variation.exact) return std::nullopt;
  const KeptKinds kept = kept_kinds(family.edit.tolerance, family.edit.constraints);
  const Violations worst = violations_of(run, variation.positions, kept);
  if (is_within(worst, kept)) return std::nullopt;
  std::string sentence;
  for (const KindViolation& one : kind_violations(kept, worst, worst)) {
    sentence += sentence.empty() ? "panels are up to " : " and ";
    sentence += three_digits(one.after_max) + " " + std::string(one.unit) + " out of ";
    sentence += one.kind == PlanarPolygon::kName ? "flat" : one.kind;
  }
  return sentence + ", as the sliders show them; --exact makes them so";
}

namespace {

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
void add_variation(Json& json, const EditRun& run, const HandleEditOptions& edit,
                   const Positions& after) {
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
  if (json.contains("violations")) {
    const KeptKinds kept = kept_kinds(edit.tolerance, edit.constraints);
    const Violations worst = violations_of(run, after, kept);
    std::vector<KindViolation> kinds = kind_violations(kept, worst, worst);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      kinds[k].before_max = run.report.violations[k].before_max;  // the edit measured the base
    }
    json["violations"] = violations_json(kinds);
  }
  json["handle_error"] = handle_error;
}

}  // namespace

Json exploration_json(const EditRun& run, const Family& family, const Variation& variation) {
  const Subspace& subspace = family.subspace;
  Json json = edit_json(run, variation.positions, family.edit.engine);
  add_variation(json, run, family.edit, variation.positions);
  json["subspace"] = subspace_json(subspace.report, subspace.dimension());
  json["subspace"]["stops"] = stops_json(slider_ranges(
      run.base.mesh, run.edited, subspace, variation.values.head(subspace.dimension())));
  if (variation.exact) {
    json["exact"] = {{"status", status_name(variation.exact->report.status)},
                     {"rms_move", variation.exact->rms_move},
                     {"max_move", variation.exact->max_move}};
  }
  return json;
}

}  // namespace planish::cli
