// SPDX-License-Identifier: MIT
#include "projection_run.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <string>

#include "edit_options.hpp"
#include "lengths.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/projection/planarising.hpp"
#include "planish/text/number.hpp"
#include "projected_mesh.hpp"
#include "repetition_run.hpp"
#include "thread_pool.hpp"

namespace planish::workflow {

std::vector<OptionRow> projection_option_rows() {
  std::vector<OptionRow> rows = {
      {"--smooth", "A",
       "weight α_f, 0 … 10000, default 10, with --reference 0: higher is\n"
       "fairer and farther away, 0 the nearest flat mesh"},
      {"--bound", "NAME=VALUE",
       "shape=on|off, default on: no panel becomes concave, crossing,\n"
       "turned over or collapsed that was not; flat=MM_PER_M: panels may\n"
       "stay that far out of flat, and change as little as that needs"},
      {"--within", "D",
       "no vertex moves farther (units of the mesh); where the flat mesh\n"
       "does, the result is as flat as that allows; with --move see there"},
      kModelUnitRow,
      {"--reference", "BASE", "vertices that sit where BASE has them prefer to stay"},
      {"--pin", "V,V,...", "vertices that stay where they are"},
      {"--keep-boundary", "", "boundary points stay"},
      {"--fairness", "KIND", "laplacian, second or third; default second"},
      kConstraintRow,
      support_row(),
      hybrid_option_row(),
      {"--solver", "NAME", "newton or alm; default newton"},
      kThreadsRow,
      {"--tolerance", "MM_PER_M", "flatness of the result, default 1e-6"}};
  const std::vector<OptionRow> repetition = repetition_option_rows();
  rows.insert(rows.end(), repetition.begin(), repetition.end());
  return rows;
}

ProjectionOptions projection_options(const Request& request) {
  ProjectionOptions options;
  read_word(request, "--fairness", options.fairness);
  read_word(request, "--solver", options.engine);
  options.executor = stated_executor(request, options.engine);
  request.read("--tolerance", options.tolerance);
  if (!request.has("--reference")) options.fairness_weight = Planarising{}.fairness_weight;
  request.read("--smooth", options.fairness_weight);
  if (request.has("--within") && !asks_for_fewer_types(request)) {
    const auto* const within = request.last("--within")->get_ptr<const std::string*>();
    if (within != nullptr && within->ends_with('%')) {
      throw UsageError("--within: a share of the mean edge is for --move; else it is a length");
    }
    read_length(request, "--within", model_unit(request), options.within);
    if (options.within <= 0.0) throw UsageError("--within must be greater than 0");
  }
  const Bounds bounds = parse_bounds(request);
  if (!bounds.limits.empty() && !asks_for_fewer_types(request)) {
    throw UsageError("--bound: project keeps the panels' shape; limits are for edit");
  }
  options.keep_shape = bounds.keep_shape;
  if (bounds.flat) {
    if (request.has("--reference") || request.has("--tolerance")) {
      throw UsageError("--bound: flat=MM_PER_M takes no --reference or --tolerance");
    }
    options.tolerance = *bounds.flat;
    options.no_flatter = true;
  }
  options.constraints = parse_constraints(request, options.tolerance);
  options.supports = parse_supports(request);
  if (std::any_of(options.supports.begin(), options.supports.end(), is_spring)) {
    throw UsageError("--support: springs are for edits; project has --reference");
  }
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  return options;
}

namespace {

void check_supports(const ProjectionOptions& options, const Mesh& base) {
  const auto problem = find_problem(options.supports, base);
  if (problem) throw UsageError(*problem);
}

}  // namespace

std::vector<int> projection_pins(const Mesh& mesh, const Request& request,
                                 const ProjectionOptions& options) {
  std::vector<int> pins = parse_vertices(request, "--pin");
  check_vertices(pins, "--pin", mesh);
  if (request.has("--keep-boundary")) {
    const std::vector<int> boundary = boundary_vertices(mesh);
    pins.insert(pins.end(), boundary.begin(), boundary.end());
  }
  if (!request.has("--reference")) check_supports(options, mesh);
  return pins;
}

ProjectionResult run_projection(const Mesh& mesh, const Request& request,
                                const ProjectionOptions& options, const Mesh* reference,
                                const Progress& progress) {
  const std::vector<int> pins = projection_pins(mesh, request, options);
  if (!reference) return project_to_planar(mesh, options, pins, progress);
  if (reference->vertex_count() != mesh.vertex_count() ||
      reference->face_offsets != mesh.face_offsets ||
      reference->face_vertices != mesh.face_vertices) {
    throw MeshError(request.value("--reference").value_or("--reference") +
                    ": the reference must have the faces of MESH");
  }
  check_supports(options, *reference);
  return project_to_planar(mesh, reference->positions, options, pins, progress);
}

Positions projected(const Mesh& mesh, const ProjectionResult& result) {
  Positions positions = mesh.positions;
  positions(Eigen::all, result.moved) = result.moved_positions;
  return positions;
}

Json projection_json(const Mesh& mesh, const Mesh& base, const ProjectionResult& result,
                     const ProjectionOptions& options) {
  const Positions flat = projected(mesh, result);
  Json json = Json::object();
  add_solve(json, result.report, options.engine);
  json["mesh"] = mesh_json(mesh);
  json["planarity_mm_per_m"] = planarity_json(mesh, mesh.positions, flat);
  json["rms_move"] = result.rms_move;
  json["max_move"] = result.max_move;
  json["failing_faces"] = result.failing_faces;
  json["spoilt_faces"] = damage_json(mesh, mesh.positions, flat);
  json["remake"] = remake_json(mesh, flat);
  json["smooth"] = result.fairness_weight;
  add_supports(json, options.supports, base, flat);
  if (result.confined_because != ConfinedBecause::kNothing) {
    json["because"] = reason(result.confined_because);
  }
  return json;
}

std::optional<std::string> confined_sentence(const ProjectionResult& result) {
  if (result.report.status != SolveStatus::kNearestConfined) return std::nullopt;
  return "the nearest flat mesh of the surroundings took the place of the weighted one; " +
         std::string(reason(result.confined_because));
}

namespace {

/// What may make a mesh flat that is not so as it was asked for.
std::string ways_to_flat(const ProjectionOptions& options, const Request& request) {
  const std::string freer =
      request.has("--keep-boundary") ? " (best without --keep-boundary), " : ", ";
  const std::string last = "--bound shape=off gives up the shape";
  if (request.has("--split")) return "a higher --split parts more of them" + freer + last;
  const bool splits = !request.has("--reference") && !find_problem(options.engine, Beyond::kSplits);
  return (splits ? "--split 10% parts a few of them" + freer : "") + last;
}

}  // namespace

std::optional<std::string> not_flat_sentence(const ProjectionResult& result,
                                             const ProjectionOptions& options,
                                             const Request& request) {
  if (result.report.status != SolveStatus::kToleranceNotMet || !options.keep_shape) {
    return std::nullopt;
  }
  if (options.within > 0.0 || options.no_flatter) {
    return std::to_string(result.failing_faces.size()) + " panels stay less flat, the worst " +
           three_digits(result.report.planarity_after) + " mm/m: panels keep their shape" +
           (options.within > 0.0 ? ", and no vertex moves farther than --within" : "");
  }
  const std::size_t count = result.failing_faces.size();
  return std::to_string(count) + (count == 1 ? " panel" : " panels") +
         " cannot become flat and keep their shape; " + ways_to_flat(options, request);
}

std::optional<std::string> lost_height_sentence(const Mesh& mesh, const ProjectionResult& result) {
  constexpr double kMostLost = 0.5;
  const Positions& before = mesh.positions;
  if (before.cols() == 0) return std::nullopt;
  const Eigen::Matrix3Xd off = before.colwise() - before.rowwise().mean();
  // Across the mesh: where it extends least.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(off * off.transpose());
  const Eigen::RowVector3d across = axes.eigenvectors().col(0).transpose();
  const auto height = [&](const Positions& positions) {
    const Eigen::RowVectorXd along = across * positions;
    return along.maxCoeff() - along.minCoeff();
  };
  const double was = height(before), is = height(projected(mesh, result));
  if (!(is < (1.0 - kMostLost) * was)) return std::nullopt;
  // What single panels are out of flat is theirs to lose.
  if (was <= 2.0 * planarity_summary(mesh).max_gap) return std::nullopt;
  return "flat panels take the shape with them: the height goes from " + three_digits(was) +
         " to " + three_digits(is) + ", points move by up to " + three_digits(result.max_move) +
         "; --within D stays nearer and less flat, --bound shape=off lets panels be concave";
}

std::optional<std::string> moved_far_sentence(const Mesh& mesh, const ProjectionResult& result,
                                              const Request& request) {
  constexpr double kFar = 0.01;  // of the diagonal of the mesh's box
  const Positions& p = mesh.positions;
  if (p.cols() == 0) return std::nullopt;
  const double size = (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
  if (!(result.max_move > kFar * size)) return std::nullopt;
  return "points move by up to " + three_digits(result.max_move) + " (units of the mesh), " +
         three_digits(100.0 * result.max_move / size) + " % of its size; " +
         (asks_for_fewer_types(request) ? "a smaller --move stays nearer"
                                        : "--within D stays nearer and less flat");
}

}  // namespace planish::workflow
