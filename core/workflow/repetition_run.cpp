// SPDX-License-Identifier: MIT
#include "repetition_run.hpp"

#include <algorithm>
#include <utility>

#include "edit_options.hpp"
#include "lengths.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/text/number.hpp"
#include "report.hpp"

namespace planish::workflow {
namespace {

constexpr std::string_view kTypes = "--types";
constexpr std::string_view kMove = "--move";

void check_company(const Request& request) {
  for (const std::string_view other :
       {"--reference", "--smooth", "--fairness", "--constraint", "--split", "--solver"}) {
    if (request.has(other)) throw UsageError("--move: fewer types know no " + std::string(other));
  }
}

std::vector<StatedLimit> limits_of(const Request& request) {
  Bounds bounds = parse_bounds(request);
  if (bounds.flat || !bounds.keep_shape) {
    throw UsageError("--move: fewer types stay flat and keep their shape, whatever --bound says");
  }
  return bounds_of_fewer_types(std::move(bounds.limits));
}

FewerTypesOptions fewer_types_options(const Mesh& mesh, const Request& request,
                                      const ProjectionOptions& projection) {
  check_company(request);
  const double mean_edge = mean_edge_length(mesh);
  const Json* move = request.last(kMove);
  const Json* within = request.last("--within");
  if (move == nullptr)
    throw UsageError("fewer types need --move MAX: how far points may move for them");
  if (request.has(kTypes) == (within != nullptr)) {
    throw UsageError("--move: give either --types K or --within D");
  }
  FewerTypesOptions options;
  const std::string unit = model_unit(request);
  options.move = parse_length(*move, kMove, unit, mean_edge);
  options.mirrored = request.has("--mirrored");
  options.tolerance = projection.tolerance;
  options.supports = projection.supports;
  options.bounds = limits_of(request);
  if (within != nullptr) {
    options.within = parse_length(*within, "--within", unit, mean_edge);
  } else {
    request.read(kTypes, options.most_types);
    if (options.most_types < 1) throw UsageError("--types must be at least 1");
  }
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  return options;
}

}  // namespace

std::vector<OptionRow> repetition_option_rows() {
  return {{kMove, "MAX|P%",
           "of a flat mesh: make more panels alike, moving no point farther\n"
           "(units of the mesh, or a share of the mean edge); --within D|P% is\n"
           "then how far a corner may be from its template's; folds grow by at\n"
           "most 5 degrees, or as --bound fold=MAX or +MAX says"},
          {kTypes, "K", "with --move: the closest fit tried that K types reach, for --within"},
          {"--mirrored", "", "with --move: a panel may be its template turned over"}};
}

bool asks_for_fewer_types(const Request& request) {
  return request.has(kMove) || request.has(kTypes) || request.has("--mirrored");
}

FewerTypes run_fewer_types(const Mesh& mesh, const Request& request,
                           const ProjectionOptions& options, const std::vector<int>& pins,
                           const Progress& progress) {
  const FewerTypesOptions fewer = fewer_types_options(mesh, request, options);
  if (const auto problem = find_problem(fewer, mesh)) throw MeshError(*problem);
  return find_fewer_types(mesh, fewer, pins, progress);
}

ProjectionResult projection_of(const Mesh& mesh, const FewerTypes& fewer) {
  ProjectionResult result;
  result.moved = moved_vertices(mesh.positions, fewer.positions);
  result.moved_positions = fewer.positions(Eigen::all, result.moved);
  result.rms_move = fewer.rms_move;
  result.max_move = fewer.max_move;
  result.report.status = fewer.cancelled ? SolveStatus::kCancelled : SolveStatus::kConverged;
  result.report.planarity_before = planarity_summary(mesh).max;
  result.report.planarity_after = planarity_summary(mesh, fewer.positions).max;
  result.report.moved_vertices = static_cast<int>(result.moved.size());
  result.report.max_displacement = fewer.max_move;
  result.report.cost = fewer.cost;
  result.report.solve_seconds = fewer.seconds;
  return result;
}

namespace {

Json templates_json(const Families& types) {
  Json json = Json::array();
  for (const auto& type : types.families) {
    json.push_back(
        {{"count", type.members.size()},
         {"worst_fit", type.worst},
         {"outline", std::vector<double>(type.shape.data(), type.shape.data() + type.shape.size())},
         {"panels", type.members}});
  }
  return json;
}

}  // namespace

Json fewer_types_json(const Mesh& mesh, const FewerTypes& fewer) {
  double worst = 0.0;
  for (const auto& type : fewer.types.families) worst = std::max(worst, type.worst);
  return {{"panels", mesh.face_count()},
          {"before", fewer.before},
          {"after", fewer.types.families.size()},
          {"within", fewer.within},
          {"within_mean_edges", fewer.within / mean_edge_length(mesh)},
          {"mirrored", fewer.mirrored},
          {"worst_fit", worst},
          {"sizes", fewer.types.sizes()},
          {"templates", templates_json(fewer.types)},
          {"max_move", fewer.max_move},
          {"sharpest_fold", fold_json(mesh, fewer.positions)},
          {"descents", fewer.descents},
          {"merging", fewer.merging}};
}

std::string fewer_types_sentence(const Mesh& mesh, const FewerTypes& fewer) {
  const double mean_edge = mean_edge_length(mesh);
  const auto after = static_cast<int>(fewer.types.families.size());
  if (after == fewer.before) {
    return "--move: no fewer than " + std::to_string(after) + " types were found, within " +
           three_digits(fewer.within) + "; the mesh is as it was";
  }
  return "--move: " + std::to_string(mesh.face_count()) + " panels are of " +
         std::to_string(after) + " types, " + std::to_string(fewer.before) + " before, within " +
         three_digits(fewer.within) + " (" + three_digits(100.0 * fewer.within / mean_edge) +
         "% of the mean edge); points move by up to " + three_digits(fewer.max_move) + " (" +
         three_digits(100.0 * fewer.max_move / mean_edge) + "%), folds are at most " +
         three_digits(fold_json(mesh, fewer.positions)["growth"].get<double>()) + "° sharper";
}

}  // namespace planish::workflow
