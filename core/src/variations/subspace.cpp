// SPDX-License-Identifier: MIT
#include "planish/variations/subspace.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "engines/augmented_lagrangian.hpp"
#include "engines/subspace_splitting.hpp"
#include "engines/subspace_vector.hpp"
#include "engines/working_set.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/problem/problem.hpp"
#include "variations/allowed_motions.hpp"

namespace planish {
namespace {

constexpr double kSparsifyShare = 1e-4;  ///< rows below this share of the largest become zero

Eigen::Map<const Eigen::VectorXd> flat(const Eigen::Matrix3Xd& t) { return {t.data(), t.size()}; }

/// ‖E t‖² on a patch, per unit of its fairness weight.
double fairness_of(const Patch& patch, const Eigen::Matrix3Xd& t) {
  double sum = 0.0;
  patch.for_each_fairness_row([&](const FairnessRow& row) {
    const auto free_part = [&](int v) -> Eigen::Vector3d {
      if (v >= patch.free_count) return Eigen::Vector3d::Zero();
      return t.col(v);
    };
    sum += row.sum(free_part).squaredNorm();
  });
  return sum;
}

/// A vector on its way into the basis.
struct Candidate {
  double objective = 0.0;
  bool overlaps = false;  ///< enough of it lies where the edit is
  Eigen::Matrix3Xd vector;
};

/// Builds the basis vector by vector on one patch around the edit.
class SubspaceBuilder {
 public:
  SubspaceBuilder(const Mesh& base, const Positions& edited, const std::vector<int>& close,
                  const KeptByVariations& keeps, const SubspaceOptions& options,
                  Executor* executor);

  Subspace build(const Progress& progress);

 private:
  void cut_patch(const std::vector<int>& close, const std::vector<int>& held);
  void set_weights();
  [[nodiscard]] std::vector<Eigen::Matrix3Xd> starts() const;
  void rank(std::list<Candidate>& candidates) const;
  [[nodiscard]] bool add_newton_vector(SubspaceVectorSolver& solver);
  [[nodiscard]] bool add_alm_vector(SubspaceVectorSolver& solver);
  void accept(const Eigen::Matrix3Xd& t);
  void rotate_to_eigenbasis();
  void fill_result(const SubspaceVectorSolver& solver, Subspace& result) const;

  SubspaceOptions options_;
  Executor* executor_;
  Mesh mesh_;  ///< faces of the base, positions p⁺
  MeshModel model_;
  Eigen::Matrix3Xd edit_;  ///< d, all vertices, solver units
  AllowedMotions allowed_;
  EditProblem problem_;
  Patch patch_;
  Eigen::Matrix3Xd direction_;   ///< d̄ on the patch, unit
  Eigen::VectorXd correlation_;  ///< ‖d̄_i‖ + Σ_j ‖t^j_i‖ on the patch
  Eigen::MatrixXd basis_;        ///< 3·free × k
  std::vector<Optimality> certificates_;
  bool all_converged_ = true;
  int steps_ = 0;
};

Mesh with_positions(const Mesh& base, const Positions& positions) {
  Mesh mesh = base;
  mesh.positions = positions;
  return mesh;
}

SubspaceBuilder::SubspaceBuilder(const Mesh& base, const Positions& edited,
                                 const std::vector<int>& close, const KeptByVariations& keeps,
                                 const SubspaceOptions& options, Executor* executor)
    : options_(options),
      executor_(executor),
      mesh_(with_positions(base, edited)),
      model_(mesh_, options.fairness, keeps.kinds),
      edit_((edited - base.positions) / model_.unit()),
      allowed_(base, mesh_.positions, keeps, model_.unit()) {
  allowed_.hold(problem_);
  cut_patch(close, keeps.held);
}

void SubspaceBuilder::cut_patch(const std::vector<int>& close, const std::vector<int>& held) {
  problem_.model = &model_;
  problem_.fairness_weight = options_.fairness_weight;
  problem_.terms.resize(at(model_.vertex_count()));
  for (const int v : close) {
    allowed_.for_each_image(
        v, [&](int image) { problem_.terms[at(image)].square_weight = options_.closeness_weight; });
  }
  std::vector<int> moved;
  for (int v = 0; v < model_.vertex_count(); ++v) {
    if (!edit_.col(v).isZero(0.0)) moved.push_back(v);
  }
  WorkingSetGrower grower(model_);
  std::vector<int> reach = grower.grow(moved, moved.empty() ? 0 : options_.reach);
  allowed_.leave_out_held(held, reach);
  PatchCutter cutter(model_);
  cutter.cut(problem_, reach, patch_);
  direction_.resize(3, patch_.free_count);
  for (int k = 0; k < patch_.free_count; ++k) {
    direction_.col(k) = edit_.col(patch_.vertices[at(k)]);
  }
  if (patch_.free_count > 0) direction_ /= direction_.norm();
  correlation_ = direction_.colwise().norm().transpose();
  basis_.resize(3 * patch_.free_count, 0);
}

/// C^i = β_s − β_c(‖d̄_i‖ + Σ_j ‖t^j_i‖), kept ≥ 0 by the choice of β_c. [SUB-3]
void SubspaceBuilder::set_weights() {
  const double largest = correlation_.maxCoeff();
  const double coupling =
      largest > 0.0 ? options_.correlation * options_.sparsity_weight / largest : 0.0;
  for (int k = 0; k < patch_.free_count; ++k) {
    patch_.terms[at(k)].norm_weight =
        std::max(0.0, options_.sparsity_weight - coupling * correlation_[k]);
  }
}

/// Start vectors: the edit itself, and its footprint moved and tilted as a whole along each axis.
std::vector<Eigen::Matrix3Xd> SubspaceBuilder::starts() const {
  std::vector<Eigen::Matrix3Xd> result{direction_};
  const Eigen::RowVectorXd footprint =
      allowed_.first_image(patch_, model_.points, direction_, correlation_.transpose());
  const Eigen::Vector3d centre =
      (patch_.points.leftCols(patch_.free_count).array().rowwise() * footprint.array())
          .rowwise()
          .sum() /
      footprint.sum();
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Matrix3Xd moved = Eigen::Matrix3Xd::Zero(3, patch_.free_count);
    moved.row(axis) = footprint;
    result.push_back(moved);
    for (int along = 0; along < 3; ++along) {
      Eigen::Matrix3Xd tilted = Eigen::Matrix3Xd::Zero(3, patch_.free_count);
      tilted.row(axis) =
          footprint.array() *
          (patch_.points.leftCols(patch_.free_count).row(along).array() - centre[along]);
      result.push_back(tilted);
    }
  }
  return result;
}

/// Lowest objective first, those that overlap the edit before those that do not: a lower objective
/// elsewhere on the patch is a good local edit, but not a variation of this one.
void SubspaceBuilder::rank(std::list<Candidate>& candidates) const {
  constexpr double kOverlap = 0.25;
  const Eigen::RowVectorXd footprint = direction_.colwise().norm();
  for (Candidate& candidate : candidates) {
    candidate.overlaps = candidate.vector.colwise().norm().dot(footprint) >= kOverlap;
  }
  candidates.sort([](const auto& a, const auto& b) {
    return a.overlaps != b.overlaps ? a.overlaps : a.objective < b.objective;
  });
}

/// Every start is measured, a few get a few steps, two are finished, one is taken.
bool SubspaceBuilder::add_newton_vector(SubspaceVectorSolver& solver) {
  constexpr std::size_t kTried = 5;
  constexpr std::size_t kFinished = 2;
  constexpr int kTrialSteps = 3;
  std::list<Candidate> candidates;
  for (Eigen::Matrix3Xd& start : starts()) {
    put_along_tracks(patch_, start);
    if (!solver.make_admissible(basis_, start)) continue;
    candidates.push_back({solver.objective(start), false, std::move(start)});
  }
  SubspaceVectorOptions options;
  options.max_steps = kTrialSteps;
  for (const std::size_t count : {kTried, kFinished}) {
    rank(candidates);
    candidates.resize(std::min(candidates.size(), count));
    for (Candidate& candidate : candidates) {
      candidate.objective = solver.improve(basis_, options, candidate.vector);
    }
    std::erase_if(candidates, [](const auto& c) { return !std::isfinite(c.objective); });
    options = {};
  }
  if (candidates.empty()) return false;
  rank(candidates);
  certificates_.push_back(solver.settle(basis_, candidates.front().vector));
  const bool even = allowed_.even_out_found(patch_, candidates.front().vector);
  all_converged_ = all_converged_ && certificates_.back().met() && even;
  accept(candidates.front().vector);
  return true;
}

bool SubspaceBuilder::add_alm_vector(SubspaceVectorSolver& solver) {
  for (Eigen::Matrix3Xd& start : starts()) {
    put_along_tracks(patch_, start);
    if (!solver.make_admissible(basis_, start)) continue;
    SubspaceSplitting splitting(patch_, basis_, start, executor_);
    AlmOptions options;
    options.max_outer = 300;
    const EngineOutcome outcome = run_alm(splitting, options, {});
    steps_ += outcome.cost.steps;
    Eigen::Matrix3Xd t = splitting.vector();
    if (!t.allFinite() || !solver.make_admissible(basis_, t)) continue;
    solver.sparsify(basis_, kSparsifyShare, t);
    all_converged_ = all_converged_ && outcome.status == SolveStatus::kConverged;
    accept(t);
    return true;
  }
  return false;
}

void SubspaceBuilder::accept(const Eigen::Matrix3Xd& t) {
  basis_.conservativeResize(Eigen::NoChange, basis_.cols() + 1);
  basis_.rightCols<1>() = flat(t);
  correlation_ += t.colwise().norm().transpose();
}

/// Eigenvectors of BᵀHB, H the Hessian of Q, smallest first [YYPM11]. [SUB-5]
void SubspaceBuilder::rotate_to_eigenbasis() {
  const Eigen::Index s = basis_.cols();
  Eigen::MatrixXd reduced(s, s);
  const auto quality = [&](const Eigen::VectorXd& x) {
    const Eigen::Matrix3Xd t = Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, patch_.free_count);
    double value = 0.5 * options_.fairness_weight * fairness_of(patch_, t);
    for (int k = 0; k < patch_.free_count; ++k) {
      value += 0.5 * patch_.terms[at(k)].square_weight * t.col(k).squaredNorm();
    }
    return value;
  };
  for (Eigen::Index i = 0; i < s; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {  // polarisation: Q is quadratic
      reduced(i, j) = reduced(j, i) =
          0.5 * (quality(basis_.col(i) + basis_.col(j)) - quality(basis_.col(i) - basis_.col(j)));
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(reduced);
  basis_ = (basis_ * solver.eigenvectors().leftCols(std::min<Eigen::Index>(s, options_.dimension)))
               .eval();
}

void SubspaceBuilder::fill_result(const SubspaceVectorSolver& solver, Subspace& result) const {
  // Rows that no vector uses are dropped: evaluating touches the support only.
  std::vector<int> kept;
  for (int k = 0; k < patch_.free_count; ++k) {
    if (!basis_.middleRows<3>(3 * k).isZero(0.0)) kept.push_back(k);
  }
  std::sort(kept.begin(), kept.end(),
            [&](int a, int b) { return patch_.vertices[at(a)] < patch_.vertices[at(b)]; });
  const auto rows = static_cast<Eigen::Index>(kept.size());
  const Eigen::Index s = basis_.cols();
  result.basis.resize(3 * rows, s);
  result.origin.resize(3, rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const int k = kept[static_cast<std::size_t>(r)];
    const int v = patch_.vertices[at(k)];
    result.support.push_back(v);
    result.origin.col(r) = mesh_.positions.col(v);
    result.basis.middleRows<3>(3 * r) = basis_.middleRows<3>(3 * k);
  }
  SubspaceReport& report = result.report;
  const double largest_move = edit_.colwise().norm().maxCoeff() * model_.unit();
  result.scale.resize(s);
  for (Eigen::Index j = 0; j < s; ++j) {
    const Eigen::Matrix3Xd t =
        Eigen::Map<const Eigen::Matrix3Xd>(basis_.col(j).data(), 3, patch_.free_count);
    const Eigen::RowVectorXd lengths = t.colwise().norm();
    result.scale[j] = largest_move / lengths.maxCoeff();
    report.tangency_error = std::max(report.tangency_error, solver.tangency_error(t));
    report.correlation.push_back(correlation(t, direction_));
    report.fairness.push_back(fairness_of(patch_, t));
    report.support_sizes.push_back(static_cast<int>((lengths.array() > 0.0).count()));
  }
  report.edit_fairness = fairness_of(patch_, direction_);
  if (s > 0) {
    report.orthonormality_error =
        (basis_.transpose() * basis_ - Eigen::MatrixXd::Identity(s, s)).cwiseAbs().maxCoeff();
  }
  report.certificates = certificates_;
  report.iterations = steps_ + solver.steps();
}

Subspace SubspaceBuilder::build(const Progress& progress) {
  Subspace result;
  result.origin.resize(3, 0);
  result.scale.resize(0);
  if (patch_.free_count == 0) {
    result.report.status = SolveStatus::kSingularSystem;
    return result;
  }
  SubspaceVectorSolver::EvenPart even;
  if (allowed_.are_symmetric()) even = [&](Eigen::Matrix3Xd& t) { allowed_.even_out(patch_, t); };
  SubspaceVectorSolver solver(patch_, std::move(even));
  result.report.status = SolveStatus::kConverged;
  const int family = std::max(options_.dimension, options_.family);
  for (int k = 0; k < family; ++k) {
    set_weights();
    const bool added =
        options_.engine == Engine::kNewton ? add_newton_vector(solver) : add_alm_vector(solver);
    if (!added) {  // the tangent space of this support is exhausted
      result.report.status = SolveStatus::kIterationLimit;
      break;
    }
    if (progress && progress({static_cast<double>(k + 1), 0.0, 0.0, 0.0}) == Flow::kStop) {
      result.report.status = SolveStatus::kCancelled;
      break;
    }
  }
  if (!all_converged_ && result.report.status == SolveStatus::kConverged) {
    result.report.status = SolveStatus::kIterationLimit;
  }
  if (options_.eigenbasis && basis_.cols() > 1) rotate_to_eigenbasis();
  fill_result(solver, result);
  return result;
}

}  // namespace

double correlation(const Eigen::Matrix3Xd& u, const Eigen::Matrix3Xd& v) {
  return u.colwise().norm().dot(v.colwise().norm());
}

Subspace compute_subspace(const Mesh& base, const Positions& edited, const std::vector<int>& close,
                          const SubspaceOptions& options, const KeptByVariations& keeps,
                          const Progress& progress, Executor* executor) {
  const Stopwatch watch;
  Subspace result = SubspaceBuilder(base, edited, close, keeps, options, executor).build(progress);
  result.report.solve_seconds = watch.seconds();
  return result;
}

std::vector<int> handle_vertices(const EditTargets& targets) {
  std::vector<int> vertices;
  for (const Handle& handle : targets.handles) vertices.push_back(handle.vertex);
  return vertices;
}

void evaluate(const Subspace& subspace, const Eigen::Ref<const Eigen::VectorXd>& coefficients,
              Positions& out) {
  out = subspace.origin;
  Eigen::Map<Eigen::VectorXd> rows(out.data(), out.size());
  for (Eigen::Index j = 0; j < subspace.basis.cols(); ++j) {
    rows += (subspace.scale[j] * coefficients[j]) * subspace.basis.col(j);
  }
  // −0 + 0 is 0: what did not move keeps its bits.
  out = (out.array() == subspace.origin.array()).select(subspace.origin, out);
}

}  // namespace planish
