// SPDX-License-Identifier: MIT
#include "engines/tangent_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/constraint_correction.hpp"
#include "engines/largest.hpp"
#include "engines/patch_lagrangian.hpp"

namespace planish {
namespace {

constexpr double kNoNorms = std::numeric_limits<double>::infinity();
constexpr double kRegularization = 1e-10;  ///< ρ of JJᵀ + ρI

/// Figures of the iteration.
struct TangentTuning {
  static constexpr double kNear = 1e-3;        ///< max |c| from which steps follow the constraints
  static constexpr double kExact = 1e-12;      ///< max |c| of a state on them, mean edges
  static constexpr double kContraction = 0.7;  ///< that a chord step must reach
  static constexpr int kChords = 12;
  static constexpr int kConjugateSteps = 200;
  static constexpr double kLoosest = 0.3;      ///< residual of the conjugate gradients, first steps
  static constexpr double kDifference = 1e-6;  ///< step of the Hessian's differences, mean edges
};

double inner(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  return a.cwiseProduct(b).sum();
}

/// State of the iteration.
class TangentNewton {
 public:
  TangentNewton(const Patch& patch, Eigen::Matrix3Xd& displacement) : displacement_(displacement) {
    lagrangian_.attach(patch);
    state_.norm_dual.setZero(3, patch.free_count);
    state_.multipliers.setZero(static_cast<Eigen::Index>(patch.equations.size()));
  }

  [[nodiscard]] bool attach(const Patch& patch) { return projection_.attach(patch); }
  void start() {
    lagrangian_.residuals(displacement_, residuals_);
    energy_ = lagrangian_.energy(displacement_, 0.0);
  }

  /// True once a state on the constraints is reached.
  [[nodiscard]] bool land();
  /// False when neither the constraints come nearer nor the objective may be left.
  [[nodiscard]] bool approach();
  /// Projects the gradient at the state; false if the factorization failed.
  [[nodiscard]] bool look();
  /// Tries one step of the trust region, taken or not; false when the region has vanished.
  [[nodiscard]] bool descend();

  [[nodiscard]] double violation() const { return residuals_.cwiseAbs().maxCoeff(); }
  [[nodiscard]] double pull() const { return longest_column(slope_); }
  [[nodiscard]] double energy() const { return energy_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] int factorizations() const { return projection_.factorizations(); }

 private:
  enum class End { kSolved, kAtTheRim, kBentDown };

  void curve(const Eigen::Matrix3Xd& direction, Eigen::Matrix3Xd& out);
  End conjugate_gradients(double accuracy, double radius);
  [[nodiscard]] double share_to_rim(double radius) const;
  [[nodiscard]] bool retract(Eigen::Matrix3Xd& at, Eigen::VectorXd& residuals);
  void accept(double energy);

  Eigen::Matrix3Xd& displacement_;
  PatchLagrangian lagrangian_;
  ConstraintCorrection projection_;
  PatchState state_;           ///< where the Hessian's differences are taken
  Eigen::Matrix3Xd gradient_;  ///< ∇F + Jᵀλ there, the differences' origin
  Eigen::VectorXd residuals_, trial_residuals_;
  Eigen::Matrix3Xd slope_;        ///< P ∇F
  Eigen::Matrix3Xd step_;         ///< of the conjugate gradients
  Eigen::Matrix3Xd curved_step_;  ///< H step_
  Eigen::Matrix3Xd left_, direction_, curved_, trial_, delta_;
  double energy_ = 0.0;
  double radius_ = 0.0;  ///< ‖step‖ at most; 0: not yet known
  double length_ = 0.0;
};

/// H x by a difference of gradients, multipliers held.
void TangentNewton::curve(const Eigen::Matrix3Xd& direction, Eigen::Matrix3Xd& out) {
  const double share = TangentTuning::kDifference / std::max(longest_column(direction), 1e-300);
  state_.displacement = displacement_ + share * direction;
  lagrangian_.gradient_at(state_, kNoNorms, out);
  out = (out - gradient_) / share;
}

/// τ ≥ 0 with ‖step + τ direction‖ = radius.
double TangentNewton::share_to_rim(double radius) const {
  const double dd = direction_.squaredNorm();
  const double sd = inner(step_, direction_);
  const double room = std::max(0.0, radius * radius - step_.squaredNorm());
  return (-sd + std::sqrt(sd * sd + dd * room)) / dd;
}

/// Minimises ⟨slope, s⟩ + ½⟨s, H s⟩ along the constraints, Steihaug's way; the result is step_.
TangentNewton::End TangentNewton::conjugate_gradients(double accuracy, double radius) {
  step_.setZero(3, slope_.cols());
  curved_step_.setZero(3, slope_.cols());
  left_ = slope_;
  direction_ = -slope_;
  double squares = left_.squaredNorm();
  const double enough = accuracy * accuracy * squares;
  for (int k = 0; k < TangentTuning::kConjugateSteps && squares > enough; ++k) {
    curve(direction_, curved_);
    const double bend = inner(direction_, curved_);
    const double share = squares / bend;
    const bool down = !(bend > 0.0);
    if (down || (step_ + share * direction_).norm() >= radius) {
      const double rim = share_to_rim(radius);
      step_ += rim * direction_;
      curved_step_ += rim * curved_;
      return down ? End::kBentDown : End::kAtTheRim;
    }
    step_ += share * direction_;
    curved_step_ += share * curved_;
    left_ += share * curved_;
    projection_.project(left_);
    const double next = left_.squaredNorm();
    direction_ = -left_ + (next / squares) * direction_;
    squares = next;
  }
  return End::kSolved;
}

/// Chord steps onto the constraints with the last factor.
bool TangentNewton::retract(Eigen::Matrix3Xd& at, Eigen::VectorXd& residuals) {
  lagrangian_.residuals(at, residuals);
  double worst = residuals.cwiseAbs().maxCoeff();
  for (int k = 0; k < TangentTuning::kChords && worst > TangentTuning::kExact; ++k) {
    projection_.step(residuals, delta_);
    at += delta_;
    lagrangian_.residuals(at, residuals);
    const double next = residuals.cwiseAbs().maxCoeff();
    if (!(next <= TangentTuning::kContraction * worst)) return false;
    worst = next;
  }
  return worst <= TangentTuning::kExact;
}

void TangentNewton::accept(double energy) {
  length_ = longest_column(trial_ - displacement_);
  displacement_.swap(trial_);
  residuals_.swap(trial_residuals_);
  energy_ = energy;
}

bool TangentNewton::land() {
  if (violation() > TangentTuning::kNear) return false;
  if (!projection_.factorize(displacement_, kRegularization)) return false;
  trial_ = displacement_;
  if (!retract(trial_, trial_residuals_)) return false;
  const double energy = lagrangian_.energy(trial_, 0.0);
  if (!std::isfinite(energy)) return false;
  accept(energy);
  return true;
}

bool TangentNewton::approach() {
  constexpr double kAccuracy = 0.1;
  constexpr int kMostHalvings = 10;
  if (!projection_.factorize(displacement_, kRegularization)) return false;
  state_.displacement = displacement_;
  state_.multipliers.setZero();  // far from the constraints the multipliers mean nothing
  lagrangian_.gradient_at(state_, kNoNorms, gradient_);
  projection_.step(residuals_, delta_);
  const Eigen::Matrix3Xd onto = delta_;
  curve(onto, slope_);
  slope_ += gradient_;
  projection_.project(slope_);
  conjugate_gradients(kAccuracy, std::numeric_limits<double>::max());
  const double before = residuals_.norm();
  double share = 1.0;
  for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
    trial_ = displacement_ + share * (onto + step_);
    const double energy = lagrangian_.energy(trial_, 0.0);
    if (!std::isfinite(energy)) continue;
    lagrangian_.residuals(trial_, trial_residuals_);
    if (trial_residuals_.norm() > (1.0 - 0.1 * share) * before) continue;
    accept(energy);
    return true;
  }
  return false;
}

bool TangentNewton::look() {
  if (!projection_.factorize(displacement_, kRegularization)) return false;
  state_.displacement = displacement_;
  state_.multipliers.setZero();
  lagrangian_.gradient_at(state_, kNoNorms, slope_);
  projection_.project(slope_);
  state_.multipliers = projection_.multipliers();
  gradient_ = slope_;
  return true;
}

bool TangentNewton::descend() {
  constexpr double kPoor = 0.25, kGood = 0.75, kWorthTaking = 1e-4;
  constexpr double kRounding = 1e-13;
  if (radius_ == 0.0) radius_ = 0.5 * displacement_.norm();
  const double accuracy = std::min(
      TangentTuning::kLoosest, std::sqrt(pull() / std::max(longest_column(displacement_), 1e-300)));
  const End end = conjugate_gradients(accuracy, radius_);
  const double predicted = -(inner(slope_, step_) + 0.5 * inner(step_, curved_step_));
  const double size = step_.norm();
  trial_ = displacement_ + step_;
  const bool on = retract(trial_, trial_residuals_);
  const double energy = on ? lagrangian_.energy(trial_, 0.0) : kNoNorms;
  const double slack = kRounding * std::abs(energy_);
  const double ratio = (energy_ - energy + slack) / (predicted + slack);
  if (!(ratio >= kPoor)) radius_ = 0.25 * std::min(radius_, size);
  if (ratio > kGood && end != End::kSolved) radius_ *= 2.5;
  if (ratio > kWorthTaking) accept(energy);
  return radius_ > 1e-9 * (1.0 + displacement_.norm());
}

}  // namespace

EngineOutcome descend_along_flat(const Patch& patch, const TangentNewtonOptions& options,
                                 const Progress& progress, Eigen::Matrix3Xd& displacement) {
  EngineOutcome outcome;
  TangentNewton newton(patch, displacement);
  if (patch.equations.empty() || !newton.attach(patch)) {
    outcome.status = SolveStatus::kSingularSystem;
    return outcome;
  }
  newton.start();
  bool on_the_constraints = false;
  while (outcome.cost.steps < options.max_steps) {
    ++outcome.cost.steps;
    if (!on_the_constraints) {
      on_the_constraints = newton.land();
      if (!on_the_constraints && !newton.approach()) break;
    } else {
      if (!newton.look()) break;
      if (newton.pull() <= options.settled) {
        outcome.status = SolveStatus::kConverged;
        break;
      }
      if (!newton.descend()) break;
    }
    outcome.records.push_back({.objective = newton.energy(),
                               .primal_residual = newton.violation(),
                               .step = newton.length()});
    if (progress && progress(outcome.records.back()) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      break;
    }
  }
  outcome.objective = newton.energy();
  outcome.cost.factorizations = newton.factorizations();
  return outcome;
}

}  // namespace planish
