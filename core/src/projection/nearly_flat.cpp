// SPDX-License-Identifier: MIT
#include "projection/nearly_flat.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "engines/active_set.hpp"
#include "engines/flatness_path.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "problem/shape_slides.hpp"
#include "projection/sound_projection.hpp"

namespace planish {
namespace {

constexpr double kFirstPenalty = 0.1, kLastPenalty = 1e7;  ///< μ
constexpr double kStride = 10.0;                           ///< from one μ to the next
constexpr int kHalvings = 4;                               ///< of the last stride's logarithm
/// Of the file's worst panel: on the way to a flatter mesh single panels bend a little more.
constexpr double kMostBent = 1.1;

/// One mesh of the path.
struct Station {
  double penalty = 0.0;           ///< μ
  Eigen::Matrix3Xd displacement;  ///< 3 × free, solver units
  Positions positions;            ///< 3 × n, model units
  double worst = 0.0;             ///< mm/m
  bool allowed = true;            ///< sound, and neither moved too far nor bent too much
  bool reached = false;           ///< every kept kind is within its tolerance
};

class PathWalker {
 public:
  PathWalker(const Mesh& mesh, const ProjectionOptions& options, double within,
             const std::vector<int>& free)
      : kept_(kept_kinds(options.tolerance, options.constraints)),
        model_(mesh, options.fairness, kept_),
        within_(within),
        cutter_(model_) {
    problem_.model = &model_;
    problem_.seeks_support = false;
    if (options.keep_shape) problem_.shape_weight = kShapeWeight;
    problem_.fairness_weight = 2.0 * options.fairness_weight;
    problem_.terms.resize(at(model_.vertex_count()));
    for (VertexTerm& term : problem_.terms) term.square_weight = 2.0 * options.distance_weight;
    keeps_shape_ = options.keep_shape;
    if (hold_points(options.supports)) {
      slides_.emplace(mesh, mesh.positions, options.supports, model_.unit());
      slides_->hold(problem_);
    }
    free_ = free;
    cutter_.cut(problem_, free_, patch_);
    path_.emplace(patch_);
    worst_ = planarity_summary(mesh).max;
  }

  [[nodiscard]] NearlyFlat walk(const Progress& progress);

 private:
  [[nodiscard]] Station rest() const;
  [[nodiscard]] Station settle(double penalty, const Station& from, const Progress& progress);
  [[nodiscard]] Eigen::Matrix3Xd settle_on_tracks(double penalty, Eigen::Matrix3Xd from,
                                                  const Progress& progress);
  [[nodiscard]] bool cancelled() const {
    return path_->outcome().status == SolveStatus::kCancelled;
  }

  KeptKinds kept_;
  MeshModel model_;
  double within_;
  bool keeps_shape_ = true;
  double worst_ = 0.0;  ///< mm/m, of the mesh as given
  PatchCutter cutter_;
  EditProblem problem_;
  std::vector<int> free_;
  std::optional<ShapeSlides> slides_;  ///< none: no supports
  Patch patch_;
  std::optional<FlatnessPath> path_;
};

Station PathWalker::rest() const {
  Station here;
  here.penalty = kFirstPenalty / kStride;
  here.displacement = Eigen::Matrix3Xd::Zero(3, patch_.free_count);
  here.positions = model_.mesh.positions;
  here.worst = worst_;
  return here;
}

/// Settles again for as long as points take other sides of their outlines.
Eigen::Matrix3Xd PathWalker::settle_on_tracks(double penalty, Eigen::Matrix3Xd from,
                                              const Progress& progress) {
  put_on_tracks(patch_, from);  // of a mesh whose points were on other sides
  Eigen::Matrix3Xd displacement = path_->settle(penalty, from, progress);
  const auto settle_again = [&] {
    cutter_.cut(problem_, free_, patch_);
    path_->attach(patch_);
    put_on_tracks(patch_, displacement);
    return path_->settle(penalty, displacement, progress);
  };
  solve_until_steady(displacement, kMostOutlineTurns - 1, settle_again,
                     [&](const Eigen::Matrix3Xd& last) {
                       const std::span moving(patch_.vertices.data(), at(patch_.free_count));
                       return slides_ && !cancelled() && slides_->follow(moving, last);
                     });
  return displacement;
}

Station PathWalker::settle(double penalty, const Station& from, const Progress& progress) {
  Station here;
  here.penalty = penalty;
  here.displacement = settle_on_tracks(penalty, from.displacement, progress);
  here.positions = model_.mesh.positions;
  for (int k = 0; k < patch_.free_count; ++k) {
    const Eigen::Vector3d move = model_.unit() * here.displacement.col(k);
    here.allowed = here.allowed && move.norm() <= within_;
    here.positions.col(patch_.vertices[at(k)]) += move;
  }
  here.allowed = here.allowed && here.positions.allFinite();
  if (!here.allowed) return here;
  Mesh mesh = model_.mesh;
  mesh.positions = here.positions;
  if (keeps_shape_)
    here.allowed = spoilt_faces(mesh, model_.mesh.positions, mesh.positions).empty();
  const MeshStanding standing = measure_standing(mesh, model_.adjacency, kept_);
  here.reached = standing.failing.empty();
  here.worst = standing.worst.front().measure;
  here.allowed = here.allowed && here.worst <= kMostBent * worst_;
  return here;
}

NearlyFlat PathWalker::walk(const Progress& progress) {
  const Stopwatch watch;
  Station before = rest();
  Station after;
  Station best = before;
  const auto ends = [&](const Station& s) {
    const bool better = s.reached ? !best.reached || s.penalty < best.penalty
                                  : !best.reached && s.worst < best.worst;
    if (s.allowed && better) best = s;
    return !s.allowed || s.reached;
  };
  bool ended = false;
  for (double penalty = kFirstPenalty; penalty <= kLastPenalty; penalty *= kStride) {
    Station next = settle(penalty, before, progress);
    if (cancelled()) break;
    ended = ends(next);
    (ended ? after : before) = std::move(next);
    if (ended) break;
  }
  for (int k = 0; k < kHalvings && ended && !cancelled(); ++k) {
    const double middle = std::sqrt(before.penalty * after.penalty);
    Station next = settle(middle, before, progress);
    (ends(next) ? after : before) = std::move(next);
  }
  NearlyFlat result;
  result.positions = std::move(best.positions);
  const EngineOutcome& outcome = path_->outcome();
  result.report.status = outcome.status;
  result.report.cost = outcome.cost;
  result.report.records = outcome.records;
  result.report.solve_seconds = watch.seconds();
  return result;
}

}  // namespace

NearlyFlat find_nearly_flat(const Mesh& mesh, const ProjectionOptions& options, double within,
                            const std::vector<int>& free, const Progress& progress) {
  PathWalker walker(mesh, options, within, free);
  return walker.walk(progress);
}

}  // namespace planish
