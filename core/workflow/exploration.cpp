// SPDX-License-Identifier: MIT
#include "exploration.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "design_output.hpp"
#include "edit_options.hpp"
#include "edit_sentences.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "planish/text/number.hpp"
#include "planish/variations/slider_stops.hpp"
#include "projection_run.hpp"

namespace planish::workflow {
namespace {

Violations violations_of(const EditRun& run, const Positions& positions, const KeptKinds& kept) {
  Mesh mesh = run.base.mesh;
  mesh.positions = positions;
  return measure_standing(mesh, build_adjacency(mesh), kept).worst;
}

}  // namespace

std::vector<OptionRow> family_option_rows() {
  return {
      {"--dimension", "S", "number of variations, 1 … 24"},
      {"--coefficients", "x1,...,xS", "slider values, default all 0"},
      {"--exact", "", "make every panel flat again before writing"},
      {"--eigen", "", "order the variations from smooth to stiff"},
      {"--family", "N", "with --eigen: the smoothest S of a family of N variations, S … 24"},
      {"--fair-weight", "B", "weight β_f, default 3: higher is smoother and wider"},
      {"--sparse-weight", "B", "weight β_s, default 1: higher moves fewer vertices"},
      {"--close-weight", "B", "weight β_h, default 0: higher keeps the points of --close still"},
      {"--close", "V,V,...", "points that --close-weight keeps still, default the handles"},
      {"--correlation", "S",
       "0 … below 1, default 0.95, share of the largest β_c: higher stays\n"
       "nearer to the edit"},
      {"--spread", "R", "face rings around the edit that variations may move, default 2"},
      {"--smooth", "A", "weight α_f of --exact, default 0: higher is fairer and moves more"}};
}

FamilyRequest family_request(const Request& request, const HandleEditOptions& edit) {
  if (const auto problem = find_variation_problem(edit)) throw UsageError(*problem);
  FamilyRequest asked;
  SubspaceOptions& options = asked.options;
  if (!request.has("--dimension")) throw UsageError("--dimension is missing");
  request.read("--dimension", options.dimension);
  options.eigenbasis = request.has("--eigen");
  request.read("--family", options.family);
  request.read("--spread", options.reach);
  request.read("--fair-weight", options.fairness_weight);
  request.read("--sparse-weight", options.sparsity_weight);
  request.read("--close-weight", options.closeness_weight);
  request.read("--correlation", options.correlation);
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  asked.close = parse_vertices(request, "--close");
  request.read("--smooth", asked.exact_fairness);
  if (asked.exact_fairness < 0.0) throw UsageError("--smooth must be at least 0");
  return asked;
}

Eigen::VectorXd coefficients(const Request& request, int dimension) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(dimension);
  const Json* stated = request.last("--coefficients");
  if (stated == nullptr) return values;
  const std::vector<Json> numbers = entries_of(*stated);
  if (numbers.size() != static_cast<std::size_t>(dimension)) {
    throw UsageError("--coefficients needs " + std::to_string(dimension) + " values, here are " +
                     std::to_string(numbers.size()));
  }
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    values[k] = parse_finite(numbers[static_cast<std::size_t>(k)], "--coefficients");
  }
  return values;
}

Family find_family(const EditRun& run, FamilyRequest asked, const Progress& progress) {
  check_vertices(asked.close, "--close", run.base.mesh);
  VariationFamily found = steps_of(run).explore(run.edited, asked.options, asked.close, progress);
  return {std::move(asked), std::move(found)};
}

Variation make_exact(const EditRun& run, const Family& family, Variation shown,
                     const Progress& progress) {
  shown.exact = steps_of(run).make_exact(&family.found, shown.positions,
                                         family.asked.exact_fairness, progress);
  shown.positions(Eigen::all, shown.exact->moved) = shown.exact->moved_positions;
  return shown;
}

Design variation_design(const EditRun& run, const Family& family, const Variation& variation) {
  const DesignVariation recipe{family.asked.options,
                               {variation.values.begin(), variation.values.end()},
                               variation.exact.has_value(),
                               family.asked.exact_fairness,
                               family.asked.close};
  return make_design(run, {recipe}, variation.positions);
}

namespace {

/// The sentence where making it exact has no certificate.
std::optional<std::string> exact_outcome_sentence(const Variation& variation) {
  if (!variation.exact) return std::nullopt;
  const auto sentence = outcome_sentence(variation.exact->report);
  return sentence ? std::optional("made exact: " + *sentence) : std::nullopt;
}

/// The sentence how much a variation that was not made exact is out of flat.
std::optional<std::string> not_exact_sentence(const EditRun& run, const Variation& variation) {
  if (variation.exact) return std::nullopt;
  const KeptKinds kept = kept_kinds(run.asked.options);
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

Json stop_json(const SliderStop& stop) {
  if (stop.face < 0) return nullptr;
  return {{"value", stop.value}, {"face", stop.face}};
}

/// The stops of each slider: how far it goes either way, the others where they are, and what stops
/// it there.
Json stops_json(const std::vector<SliderRange>& ranges) {
  Json json = Json::array();
  for (const SliderRange& range : ranges) {
    json.push_back({{"lower", stop_json(range.lower)}, {"upper", stop_json(range.upper)}});
  }
  return json;
}

Json exact_json(const ProjectionResult& exact) {
  Json json = {{"status", status_name(exact.report.status)},
               {"rms_move", exact.rms_move},
               {"max_move", exact.max_move},
               {"objective", exact.report.objective.total()}};
  if (exact.report.optimality) json["optimality"] = optimality_json(*exact.report.optimality);
  if (exact.confined_because != ConfinedBecause::kNothing) {
    json["because"] = reason(exact.confined_because);
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
  json["moved_vertices"] = (moves.array() != 0.0).colwise().any().count();
  json["max_displacement"] = moves.colwise().norm().maxCoeff();
  if (json.contains("violations")) {
    const KeptKinds kept = kept_kinds(run.asked.options);
    const Violations worst = violations_of(run, after, kept);
    std::vector<KindViolation> kinds = kind_violations(kept, worst, worst);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      kinds[k].before_max = run.report.violations[k].before_max;  // the edit measured the base
    }
    json["violations"] = violations_json(kinds);
  }
  json["handle_error"] = farthest_handle(run.targets.handles, after);
}

}  // namespace

Json exploration_json(const EditRun& run, const Family& family, const Variation& variation) {
  const Subspace& subspace = family.found.subspace;
  Json json = edit_json(run, variation.positions);
  add_variation(json, run, variation.positions);
  json["subspace"] = subspace_json(subspace.report, subspace.dimension());
  json["subspace"]["stops"] = stops_json(
      slider_ranges(run.base.mesh, run.edited, subspace, family.found.sliders(variation.values)));
  if (variation.exact) json["exact"] = exact_json(*variation.exact);
  return json;
}

std::vector<std::string> exploration_messages(const EditRun& run, const Variation& variation,
                                              const Json& report) {
  return edit_messages(run, report,
                       said({not_exact_sentence(run, variation),
                             variation.exact ? confined_sentence(*variation.exact) : std::nullopt,
                             exact_outcome_sentence(variation)}));
}

}  // namespace planish::workflow
