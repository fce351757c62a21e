// SPDX-License-Identifier: MIT
#include "planish/variations/exact_variation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "planish/problem/problem.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "problem/shape_slides.hpp"
#include "projection/projection_task.hpp"
#include "projection/sound_projection.hpp"

namespace planish {
namespace {

/// Halvings of the way: the last is finer than a slider's step of a hundredth.
constexpr int kBisections = 6;

/// The bound on every panel's shape, among the stated limits of a report.
constexpr std::string_view kShapeBound = "shape";

/// Judges shapes by the edit's limits.
class LimitJudge {
 public:
  LimitJudge(const Mesh& base, const HandleEditOptions& options)
      : model_(base, options.fairness),
        limits_(LimitBase{model_.mesh, model_.adjacency, model_.points, model_.unit()},
                options.bounds) {
    if (options.keep_outs.empty()) return;
    limits_.keep_out({model_.mesh, model_.adjacency, model_.points, model_.unit()},
                     options.keep_outs, options.clearance);
  }

  [[nodiscard]] bool accepts(const Positions& shape) const {
    const std::vector<LimitStanding> standing = standing_of(shape);
    return std::all_of(standing.begin(), standing.end(),
                       [](const LimitStanding& one) { return one.least_share >= 0.0; });
  }

  /// The panels of `shape` that each limit holds back.
  [[nodiscard]] std::vector<BoundStanding> holding(const Positions& shape) const {
    std::vector<BoundStanding> bounds;
    for (LimitStanding& one : standing_of(shape)) {
      bounds.push_back({one.name, std::move(one.binding)});
    }
    return bounds;
  }

 private:
  [[nodiscard]] std::vector<LimitStanding> standing_of(const Positions& shape) const {
    const Positions& base = model_.mesh.positions;
    const auto place = [&](int v) -> Eigen::Vector3d {
      return model_.points.col(v) + (shape.col(v) - base.col(v)) / model_.unit();
    };
    const std::vector<int> faces = faces_of(model_.adjacency, moved_vertices(base, shape));
    // The planes follow the shape that is judged.
    if (MeshKeepOuts* const keep_outs = limits_.keep_outs()) {
      (void)keep_outs->part_panels(faces, place);
      (void)keep_outs->choose_planes(faces, place);
    }
    return limit_standing(limits_, faces, place);
  }

  MeshModel model_;
  MeshLimits limits_;
};

/// Judges shapes by all that the edit keeps beside its constraints.
class Judge {
 public:
  Judge(const ShownVariation& variation, const HandleEditOptions& options)
      : variation_(variation), keep_shape_(options.keep_shape) {
    if (!options.bounds.empty() || !options.keep_outs.empty())
      limits_.emplace(variation.base, options);
  }

  /// What `shape` exceeds; kNothing where it keeps everything.
  [[nodiscard]] ConfinedBecause objection(const Positions& shape) const {
    if (limits_ && !limits_->accepts(shape)) return ConfinedBecause::kStatedLimits;
    if (keep_shape_ && !newly_spoilt(shape).empty()) return ConfinedBecause::kSpoiltByVariation;
    return ConfinedBecause::kNothing;
  }

  /// The panels of `shape` that each limit holds back, and those that are spoilt.
  [[nodiscard]] std::vector<BoundStanding> holding(const Positions& shape) const {
    std::vector<BoundStanding> bounds;
    if (limits_) bounds = limits_->holding(shape);
    std::vector<int> faces = newly_spoilt(shape);
    if (keep_shape_ && !faces.empty()) bounds.push_back({kShapeBound, std::move(faces)});
    return bounds;
  }

 private:
  /// Panels that the variation spoilt; the edit had none of them.
  [[nodiscard]] std::vector<int> newly_spoilt(const Positions& shape) const {
    const Mesh& base = variation_.base;
    std::vector<int> faces = spoilt_faces(base, base.positions, shape);
    std::erase_if(faces, [&](int f) {
      return panel_damage(base.positions, variation_.edited, base.face(f)) != PanelDamage::kNone;
    });
    return faces;
  }

  const ShownVariation& variation_;
  bool keep_shape_;
  std::optional<LimitJudge> limits_;
};

ProjectionOptions exact_options(const HandleEditOptions& edit, double fairness_weight,
                                const std::vector<PointSupport>& supports) {
  ProjectionOptions options;
  options.fairness_weight = fairness_weight;
  options.fairness = edit.fairness;
  options.engine = edit.engine;
  options.executor = edit.executor;
  options.tolerance = edit.tolerance;
  options.keep_shape = edit.keep_shape;
  options.constraints = edit.constraints;
  options.supports = supports;
  return options;
}

/// What is shown, its points where they stand: vectors go along outlines' sides and surfaces to
/// first order only. Levels, planes and lines have them there already.
Positions on_supports(const ShownVariation& variation, const std::vector<PointSupport>& supports) {
  if (!hold_points(supports)) return variation.shown;
  const ShapeSlides slides(variation.base, variation.shown, supports,
                           mean_edge_length(variation.base));
  return slides.slides().has_turning_tracks() ? slides.shape_on_supports() : variation.shown;
}

/// `share` of the way from the edit; what the sliders do not move keeps its bits.
Positions part_of_the_way(const ShownVariation& variation, double share) {
  Positions part = variation.edited;
  for (Eigen::Index v = 0; v < part.cols(); ++v) {
    const Eigen::Vector3d way = variation.shown.col(v) - variation.edited.col(v);
    if (!way.isZero(0.0)) part.col(v) += share * way;
  }
  return part;
}

Positions after(Positions shape, const ProjectionResult& result) {
  shape(Eigen::all, result.moved) = result.moved_positions;
  return shape;
}

/// Puts every point and its images at their mean, and makes that flat again: what it takes from
/// flatness is of the second order, so a few rounds make both. Where they do not, kToleranceNotMet.
/// [SYM-3]
void make_even(const ShownVariation& variation, const ProjectionOptions& exact,
               const KeptByVariations& keeps, const Positions& from, const Progress& progress,
               ProjectionResult& result) {
  constexpr int kMostRounds = 4;
  constexpr double kRounding = 1e-9;  // mean edges: a certificate is as good here as it was there
  if (!result.report.usable()) return;
  const KeptKinds kept = kept_kinds(exact.tolerance, exact.constraints);
  Mesh mesh = variation.base;
  mesh.positions = after(from, result);
  const Positions found = mesh.positions;
  const Adjacency adjacency = build_adjacency(mesh);
  for (int round = 0;; ++round) {
    even_out(*keeps.symmetry,
             images_of(*keeps.symmetry, moved_vertices(variation.base.positions, mesh.positions)),
             mesh.positions);
    result.failing_faces = measure_standing(mesh, adjacency, kept).failing;
    if (result.failing_faces.empty() || round == kMostRounds) break;
    const ProjectionResult again =
        project_to_planar(mesh, variation.base.positions, exact, keeps.held, progress);
    if (again.report.status == SolveStatus::kCancelled) {
      result.report.status = SolveStatus::kCancelled;
      return;
    }
    mesh.positions(Eigen::all, again.moved) = again.moved_positions;
  }
  const double evened = (mesh.positions - found).colwise().norm().maxCoeff();
  if (evened > kRounding * mean_edge_length(variation.base)) {
    result.report.optimality.reset();
    if (result.report.status == SolveStatus::kConverged)
      result.report.status = SolveStatus::kIterationLimit;
  }
  if (!result.failing_faces.empty()) result.report.status = SolveStatus::kToleranceNotMet;
  record_moves(from, mesh.positions, result);
}

}  // namespace

ProjectionResult make_exact(const ShownVariation& variation, const HandleEditOptions& options,
                            double fairness_weight, const KeptByVariations& keeps,
                            const Progress& progress) {
  const ProjectionOptions exact = exact_options(options, fairness_weight, keeps.supports);
  const auto project = [&](const Positions& shape) {
    Mesh mesh = variation.base;
    mesh.positions = shape;
    ProjectionResult flat =
        project_to_planar(mesh, variation.base.positions, exact, keeps.held, progress);
    if (keeps.symmetry != nullptr) make_even(variation, exact, keeps, shape, progress, flat);
    return flat;
  };
  const Positions start = on_supports(variation, keeps.supports);
  ProjectionResult result = project(start);
  if (!result.report.usable()) return result;
  const Judge judge(variation, options);
  const Positions wanted = after(start, result);
  const ConfinedBecause objection = judge.objection(wanted);
  if (objection == ConfinedBecause::kNothing) {
    if (start != variation.shown) record_moves(variation.shown, wanted, result);
    return result;
  }
  Positions shape = variation.edited;
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < kBisections && result.report.status != SolveStatus::kCancelled; ++k) {
    const double share = 0.5 * (low + high);
    const Positions part = part_of_the_way(variation, share);
    ProjectionResult next = project(part);
    Positions projected = after(part, next);
    const bool cancelled = next.report.status == SolveStatus::kCancelled;
    const bool holds =
        next.report.usable() && judge.objection(projected) == ConfinedBecause::kNothing;
    (holds ? low : high) = share;
    if (holds) shape = std::move(projected);
    if (holds || cancelled) result = std::move(next);
  }
  if (result.report.status == SolveStatus::kCancelled) return result;
  if (low == 0.0) result = project(variation.edited);
  if (result.report.status == SolveStatus::kCancelled) return result;
  record_moves(variation.shown, shape, result);
  result.failing_faces.clear();
  result.report.optimality.reset();
  result.report.bounds = judge.holding(wanted);
  result.report.status = SolveStatus::kNearestConfined;
  result.confined_because = objection;
  return result;
}

}  // namespace planish
