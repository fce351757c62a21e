// SPDX-License-Identifier: MIT
#include "projection/sound_projection.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "engines/active_set.hpp"
#include "engines/exact_finish.hpp"
#include "engines/fair_flat.hpp"
#include "engines/optimality.hpp"
#include "engines/tangent_newton.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "problem/shape_slides.hpp"

namespace planish {
namespace {

constexpr double kAtOnce = 1e6;     ///< first penalty: no stages
constexpr double kGradually = 1e2;  ///< first penalty: three stages
constexpr double kHeldBack = 1.0;   ///< mm/m: a panel above it is held back by its bound

/// The problem on one mesh, for one α_f after the other.
class SoundProjector {
 public:
  SoundProjector(const Mesh& mesh, const Mesh& base, const ProjectionOptions& options,
                 const std::vector<int>& free, const std::vector<int>& pins)
      : options_(options),
        base_(base),
        free_(free),
        pins_(pins),
        kept_(kept_kinds(options.tolerance, options.constraints)),
        model_(mesh, options.fairness, kept_),
        finish_(model_),
        cutter_(model_) {
    problem_.model = &model_;
    problem_.seeks_support = false;
    problem_.shape_weight = kShapeWeight;
    problem_.terms.resize(at(model_.vertex_count()));
    release();
  }

  [[nodiscard]] SoundProjection attempt(double fairness_weight, double first_penalty,
                                        const Progress& progress);

 private:
  [[nodiscard]] EngineOutcome solve(const Patch& patch, double first_penalty,
                                    const Progress& progress, Eigen::Matrix3Xd& displacement) const;
  void release();
  void open_tracks();
  [[nodiscard]] ExactDesign solve_on_tracks(double first_penalty, const Progress& progress,
                                            Patch& patch, DisplacementField& field,
                                            SolveReport& report);
  void hold(const std::vector<int>& vertices, const DisplacementField& field);
  [[nodiscard]] Positions shape_of(const DisplacementField& field) const;
  [[nodiscard]] Positions positions_of(const ExactDesign& design, SolveReport& report) const;
  [[nodiscard]] bool none_is_worse(const Mesh& after, const std::vector<int>& failing) const;
  void judge(Positions positions, SoundProjection& best) const;

  ProjectionOptions options_;
  const Mesh& base_;
  const std::vector<int>& free_;
  const std::vector<int>& pins_;
  KeptKinds kept_;
  MeshModel model_;
  ExactFinish finish_;
  PatchCutter cutter_;
  EditProblem problem_;
  std::optional<ShapeSlides> slides_;  ///< of one attempt; none: no supports
};

/// Supports where they begin: an attempt knows nothing of where the last one turned.
void SoundProjector::open_tracks() {
  if (!hold_points(options_.supports)) return;
  slides_.emplace(base_, model_.mesh.positions, options_.supports, model_.unit());
  slides_->hold(problem_);
}

void SoundProjector::release() {
  for (VertexTerm& term : problem_.terms) {
    term = {};
    term.square_weight = 2.0 * options_.distance_weight;
  }
  for (const int v : pins_) problem_.terms[at(v)].fixed = true;
}

/// Keeps vertices where the field has them.
void SoundProjector::hold(const std::vector<int>& vertices, const DisplacementField& field) {
  for (const int v : vertices) {
    problem_.terms[at(v)].fixed = true;
    problem_.terms[at(v)].target = field.displacement(v);
  }
}

Positions SoundProjector::shape_of(const DisplacementField& field) const {
  Positions positions = model_.mesh.positions;
  for (const int v : field.touched_vertices()) {
    positions.col(v) += model_.unit() * field.displacement(v);
  }
  return positions;
}

Positions SoundProjector::positions_of(const ExactDesign& design, SolveReport& report) const {
  report.cost += design.cost;
  Positions positions = model_.mesh.positions;
  positions(Eigen::all, design.vertices) = design.positions;
  return positions;
}

/// A panel that does not become flat must not become worse either.
bool SoundProjector::none_is_worse(const Mesh& after, const std::vector<int>& failing) const {
  return std::all_of(failing.begin(), failing.end(), [&](int f) {
    const auto face = model_.face(f);
    return face_planarity(after.positions, face).mm_per_m <=
           face_planarity(model_.mesh.positions, face).mm_per_m;
  });
}

/// Takes `positions` where they are sound and leave fewer panels above the tolerance.
void SoundProjector::judge(Positions positions, SoundProjection& best) const {
  if (!positions.allFinite()) return;
  Mesh mesh = model_.mesh;
  mesh.positions = std::move(positions);
  std::vector<int> failing = measure_standing(mesh, model_.adjacency, kept_).failing;
  const bool better = !best.found() || failing.size() < best.failing.size();
  if (!better || !none_is_worse(mesh, failing)) return;
  if (!spoilt_faces(mesh, base_.positions, mesh.positions).empty()) return;
  if (!tipped_faces(mesh, model_.mesh.positions, mesh.positions).empty()) return;
  best.squared_move = (mesh.positions - model_.mesh.positions).squaredNorm();
  best.positions = std::move(mesh.positions);
  best.failing = std::move(failing);
}

/// "Converged" means certified on the finished mesh.
void certify(const ExactDesign& design, const Patch& patch, SolveReport& report) {
  report.optimality = fitted_optimality(patch, displacement_on(patch, design));
  const bool met = report.optimality && report.optimality->met();
  if (report.status == SolveStatus::kConverged && !met) {
    report.status = SolveStatus::kIterationLimit;
  }
}

/// Large meshes along the flat meshes, others by the factor of their Hessian.
EngineOutcome SoundProjector::solve(const Patch& patch, double first_penalty,
                                    const Progress& progress,
                                    Eigen::Matrix3Xd& displacement) const {
  if (first_penalty == kAtOnce && patch.free_count > kMostFactored) {
    TangentNewtonOptions tangent;
    if (options_.max_iterations > 0) tangent.max_steps = options_.max_iterations;
    return descend_along_flat(patch, tangent, progress, displacement);
  }
  FairFlatOptions newton{.first_penalty = first_penalty};
  if (options_.max_iterations > 0) newton.max_steps = options_.max_iterations;
  return find_fair_flat(patch, newton, progress, displacement);
}

/// Solved again for as long as points take other sides of their outlines, or other places on
/// surfaces.
/// @param patch the last one solved on @param field what the engine left
ExactDesign SoundProjector::solve_on_tracks(double first_penalty, const Progress& progress,
                                            Patch& patch, DisplacementField& field,
                                            SolveReport& report) {
  open_tracks();
  const auto solve_once = [&] {
    cutter_.cut(problem_, free_, patch);
    Eigen::Matrix3Xd displacement = on_tracks(patch);
    EngineOutcome outcome = solve(patch, first_penalty, progress, displacement);
    field.clear();
    for (int k = 0; k < patch.free_count; ++k) {
      field.set_displacement(patch.vertices[at(k)], displacement.col(k));
    }
    report.status = outcome.status;
    report.cost += outcome.cost;
    report.records = std::move(outcome.records);
    return finish_.finish(problem_, free_, field, kept_);
  };
  ExactDesign design = solve_once();
  solve_until_steady(design, kMostOutlineTurns - 1, solve_once, [&](const ExactDesign& last) {
    return report.status != SolveStatus::kCancelled && slides_ &&
           slides_->follow(last.vertices, last.displacement);
  });
  return design;
}

SoundProjection SoundProjector::attempt(double fairness_weight, double first_penalty,
                                        const Progress& progress) {
  release();
  problem_.fairness_weight = 2.0 * fairness_weight;
  Patch patch;
  DisplacementField field(model_.vertex_count(), static_cast<int>(model_.equations.size()));
  SoundProjection result;
  result.fairness_weight = fairness_weight;
  const ExactDesign design = solve_on_tracks(first_penalty, progress, patch, field, result.report);
  judge(positions_of(design, result.report), result);
  if (result.is_flat()) {
    certify(design, patch, result.report);
    if (slides_ && !slides_->holds(design.vertices, design.displacement)) {
      result.report.status = SolveStatus::kIterationLimit;
    }
    return result;
  }
  Mesh rough = model_.mesh;
  rough.positions = shape_of(field);
  hold(vertices_of(rough, measure_standing(rough, model_.adjacency, KeptKinds(kHeldBack)).failing),
       field);
  judge(positions_of(finish_.finish(problem_, free_, field, kept_), result.report), result);
  judge(std::move(rough.positions), result);
  return result;
}

/// Whether no corner moves: then nothing can be spoilt, and most of a large mesh is not measured.
bool is_unmoved(std::span<const int> face, const Positions& before, const Positions& after) {
  return std::all_of(face.begin(), face.end(),
                     [&](int v) { return before.col(v) == after.col(v); });
}

}  // namespace

bool SoundProjection::ends_search(int vertex_count) const {
  return vertex_count > kMostFactored ? is_flat() : is_final();
}

bool SoundProjection::is_better_than(const SoundProjection& other) const {
  if (!found() || !other.found()) return found();
  if (failing.size() != other.failing.size()) return failing.size() < other.failing.size();
  if (!is_flat()) return false;
  if (is_final() != other.is_final()) return is_final();
  return squared_move < other.squared_move;
}

std::vector<int> tipped_faces(const Mesh& mesh, const Positions& before, const Positions& after) {
  constexpr double kTurn = 0.5;   // cos 60°
  constexpr double kSeen = 0.25;  // of the area
  std::vector<int> tipped;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (is_unmoved(face, before, after)) continue;
    const Eigen::Vector3d was = area_vector(before, face), is = area_vector(after, face);
    const double seen = was.dot(is);
    if (seen < kSeen * was.squaredNorm() && seen < kTurn * was.norm() * is.norm()) {
      tipped.push_back(f);
    }
  }
  return tipped;
}

std::vector<int> spoilt_faces(const Mesh& mesh, const Positions& before, const Positions& after) {
  std::vector<int> spoilt;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (is_unmoved(mesh.face(f), before, after)) continue;
    if (panel_damage(before, after, mesh.face(f)) != PanelDamage::kNone) spoilt.push_back(f);
  }
  return spoilt;
}

SoundProjection project_soundly(const Mesh& mesh, const Mesh& base,
                                const ProjectionOptions& options, const std::vector<int>& free,
                                const std::vector<int>& pins, std::span<const Rung> ladder,
                                const Progress& progress) {
  const Stopwatch watch;
  SoundProjector projector(mesh, base, options, free, pins);
  const double asked = options.fairness_weight > 0.0 ? options.fairness_weight : 1.0;
  SoundProjection best;
  SolveCost cost;
  for (const Rung& rung : ladder) {
    SoundProjection next =
        projector.attempt(rung.share * asked, rung.gradual ? kGradually : kAtOnce, progress);
    cost += next.report.cost;
    const bool cancelled = next.report.status == SolveStatus::kCancelled;
    if (next.is_better_than(best)) best = std::move(next);
    if (cancelled || best.ends_search(mesh.vertex_count())) break;
  }
  best.report.cost = cost;
  best.report.solve_seconds = watch.seconds();
  return best;
}

}  // namespace planish
