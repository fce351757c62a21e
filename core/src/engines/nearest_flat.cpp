// SPDX-License-Identifier: MIT
#include "engines/nearest_flat.hpp"

#include <algorithm>
#include <cmath>

#include "engines/anderson_mixing.hpp"
#include "engines/constraint_correction.hpp"

namespace planish {
namespace {

constexpr double kFlat = 1e-5;        ///< residual that finish() takes to rounding, mean edges
constexpr double kContraction = 0.9;  ///< of one step's length to the last one's

/// State of the iteration and its line search.
class NearestFlat {
 public:
  NearestFlat(const Patch& patch, Eigen::Matrix3Xd& displacement)
      : patch_(patch), t_(displacement) {}

  [[nodiscard]] bool attach() { return linear_.attach(patch_); }
  void start() { residuals_at(patch_, t_, residuals_); }
  [[nodiscard]] double violation() const { return residuals_.cwiseAbs().maxCoeff(); }
  [[nodiscard]] double move() const { return move_; }
  [[nodiscard]] double objective() const { return 0.5 * t_.squaredNorm(); }
  [[nodiscard]] int factorizations() const { return linear_.factorizations(); }

  /// False when no step helps any more.
  [[nodiscard]] bool step() {
    if (!linear_.factorize(t_, regularization_)) {
      regularization_ *= 100.0;
      return regularization_ < 1.0;
    }
    linear_.apply_jacobian(t_, linearised_);
    linearised_ = residuals_ - linearised_;
    linear_.step(linearised_, delta_);  // −Jᵀ(JJᵀ)⁻¹(c − J t) = t⁺
    merit_weight_ = std::max(0.5 * merit_weight_, 2.0 * linear_.largest_multiplier());
    // What supports hold is no unknown: t is that and the rest, which lies along the tracks.
    for (const Slide& slide : patch_.slides) delta_.col(slide.vertex) += across(slide.track);
    delta_ -= t_;
    // Steps that keep shrinking follow a fixed-point law, and need no merit (Deuflhard's natural
    // monotonicity test).
    const double length = delta_.norm();
    contracting_ = length < kContraction * last_length_;
    last_length_ = length;
    if (!contracting_) mixing_.restart();
    mixing_.accelerate(t_, delta_);
    return search_line();
  }

  /// Onto the constraints, along the last linearisation while that helps.
  void finish() {
    constexpr int kMostCorrections = 8;
    constexpr double kRounding = 1e-13;
    for (int pass = 0; pass < kMostCorrections && violation() > kRounding; ++pass) {
      linear_.step(residuals_, delta_);
      trial_ = t_ + delta_;
      residuals_at(patch_, trial_, trial_residuals_);
      if (!(trial_residuals_.norm() < 0.1 * residuals_.norm())) return;
      t_.swap(trial_);
      residuals_.swap(trial_residuals_);
    }
  }

 private:
  /// The part of a track's offset that is not along it.
  [[nodiscard]] static Eigen::Vector3d across(const SlideTrack& track) {
    return track.offset - track.along * track.offset;
  }

  [[nodiscard]] bool search_line() {
    constexpr int kMostHalvings = 12;
    constexpr double kHalved = 0.5;
    const double start = objective() + merit_weight_ * residuals_.cwiseAbs().sum();
    const double before = residuals_.cwiseAbs().sum();
    double share = 1.0;
    for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
      trial_ = t_ + share * delta_;
      residuals_at(patch_, trial_, trial_residuals_);
      const double sum = trial_residuals_.cwiseAbs().sum();
      const double merit = 0.5 * trial_.squaredNorm() + merit_weight_ * sum;
      // A step that halves the violation is progress whatever the merit says: ‖c‖₁ charges a full
      // step along curved constraints for what the next one removes (the Maratos effect).
      if (contracting_ || merit < start || sum < kHalved * before) {
        move_ = share * delta_.norm() / std::max(trial_.norm(), 1e-300);
        t_.swap(trial_);
        residuals_.swap(trial_residuals_);
        if (share < 1.0) mixing_.restart();
        if (share < 0.25) regularization_ = std::min(1e-2, 10.0 * regularization_);
        if (share == 1.0) regularization_ = std::max(1e-10, 0.1 * regularization_);
        return true;
      }
    }
    regularization_ *= 100.0;
    return regularization_ < 1.0;
  }

  const Patch& patch_;
  Eigen::Matrix3Xd& t_;
  ConstraintCorrection linear_;
  Eigen::VectorXd residuals_, linearised_, trial_residuals_;
  Eigen::Matrix3Xd delta_, trial_;
  double regularization_ = 1e-10;
  double merit_weight_ = 0.0;
  double move_ = 1.0;
  double last_length_ = 0.0;  ///< of the step before
  bool contracting_ = false;
  AndersonMixing mixing_;
};

}  // namespace

EngineOutcome find_nearest_flat(const Patch& patch, const NearestFlatOptions& options,
                                const Progress& progress, Eigen::Matrix3Xd& displacement) {
  EngineOutcome outcome;
  if (patch.equations.empty()) {
    outcome.status = SolveStatus::kConverged;
    return outcome;
  }
  NearestFlat solver(patch, displacement);
  if (!solver.attach()) {
    // A vertex with very many equations: correct along the primal form instead.
    (void)correct_constraints(patch, options.max_steps, displacement, outcome.cost.factorizations);
    outcome.status = SolveStatus::kConverged;
    return outcome;
  }
  solver.start();
  for (; outcome.cost.steps < options.max_steps; ++outcome.cost.steps) {
    if (solver.violation() <= kFlat && solver.move() <= options.settled) {
      outcome.status = SolveStatus::kConverged;
      break;
    }
    if (!solver.step()) break;
    outcome.records.push_back({.objective = solver.objective(),
                               .primal_residual = solver.violation(),
                               .step = solver.move()});
    if (progress && progress(outcome.records.back()) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      break;
    }
  }
  // A last step that rounding refused is the end of the road, not a failure.
  if (outcome.status == SolveStatus::kIterationLimit && solver.violation() <= kFlat &&
      solver.move() <= 10.0 * options.settled) {
    outcome.status = SolveStatus::kConverged;
  }
  if (solver.factorizations() > 0) solver.finish();
  outcome.cost.factorizations = solver.factorizations();
  return outcome;
}

}  // namespace planish
