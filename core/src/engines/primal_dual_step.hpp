// SPDX-License-Identifier: MIT
/// One step of Newton's method on a patch, judged by a merit that stays one function: the
/// primal-dual augmented Lagrangian of Gill and Robinson, its multiplier estimate held. [WSN-6]
#pragma once

#include <Eigen/Core>

#include "engines/limit_active_set.hpp"
#include "engines/patch_system.hpp"

namespace planish {

/// What the rows do: hold at zero, or pull there with μ c alone, so that the state settles where
/// F + μ/2 ‖c‖² is least: the estimate stays zero. [PRO-7]
enum class RowRule { kEquations, kSprings };

/// Lengths in mean edges.
struct StepOptions {
  /// μ > 0 of [WSN-2]; 1/μ regularises nearly dependent constraints. Small: cuts corners through
  /// states that are not flat, and may not return; large: short steps along curved constraints.
  double penalty = 1e6;
  /// μ > 0 of the inequalities, whose shares are no lengths. Small: their multipliers come slowly;
  /// large: a step that meets many new ones is cut short.
  double limit_penalty = 20.0;
  /// Limits that press no more stay for a step whose model has no minimum without them; otherwise
  /// the shift grows until it has one. Cheaper on the way, but at a minimum none may stay.
  bool limits_may_stay = true;
  /// Largest movement of a vertex in one step, > 0. Large: leaps to other minima.
  double trust = 0.5;
  /// A step that the merit cuts to less than this share raises the shift, as Levenberg and
  /// Marquardt do; 0: no step does.
  double poor_share = 0.0;
  RowRule rows = RowRule::kEquations;
};

/// Steps of one patch at a time; what they need between them is kept here.
class PrimalDualStep {
 public:
  enum class Result { kAccepted, kRejected, kBroken };

  /// Takes another patch, on which steps follow.
  void attach(PatchSystem& system, int free_count);

  /// Forgets the merit of earlier steps, before steps on another function of the same patch: other
  /// weights, smoothing or penalty. Values of one function say nothing about another's.
  void restart() { fresh_ = true; }

  void forget_shift() { shift_ = 0.0; }

  /// Leaves `state` as it is unless the step is accepted. A start that has no merit is kBroken: any
  /// step would pass for a better one.
  /// @param smoothing ε > 0 of √(‖d‖² + ε²)
  [[nodiscard]] Result take(const StepOptions& options, double smoothing, PatchState& state);

  // Of the last step:
  [[nodiscard]] double largest_move() const { return largest_move_; }
  [[nodiscard]] bool is_plain() const { return length_ == 1.0 && shift_ == 0.0; }
  /// c of the state that it left, where it was accepted.
  [[nodiscard]] const Eigen::VectorXd& residuals() const { return trial_residuals_; }
  /// Largest |c| that it left.
  [[nodiscard]] double violation() const;
  /// The merit before and after it, by one estimate.
  [[nodiscard]] double merit_before() const { return merit_before_; }
  [[nodiscard]] double merit_after() const { return merit_after_; }
  /// Whether it was judged by another estimate than the step before.
  [[nodiscard]] bool has_new_estimate() const { return has_new_estimate_; }

 private:
  /// A displacement, its rows, its multipliers and what its limits add to its merit.
  struct Point {
    const Eigen::Matrix3Xd& displacement;
    const Eigen::VectorXd& residuals;
    const Eigen::VectorXd& multipliers;
    double limits = 0.0;
  };
  [[nodiscard]] double merit(const Point& point) const;
  void hold_estimate(const PatchState& state);
  [[nodiscard]] bool factorize(const PatchState& state);
  [[nodiscard]] bool find_step(const PatchState& state);
  void find_direction(const PatchState& state);
  [[nodiscard]] bool search_line(const PatchState& state);
  void correct(double share);
  void adapt_shift();

  PatchSystem* system_ = nullptr;
  StepOptions options_;
  double smoothing_ = 1.0;

  Eigen::VectorXd estimate_;      ///< λₑ
  double feasible_record_ = 0.0;  ///< of |c|, by which a new estimate is earned
  double optimal_record_ = 0.0;   ///< of |∇L|
  double merit_tolerance_ = 0.0;  ///< of the merit's decrease: below it a minimum of it is near
  LimitActiveSet limits_;
  bool fresh_ = true;
  bool wants_estimate_ = false;  ///< the next step does

  double shift_ = 0.0;  ///< ν
  double length_ = 1.0;
  double cut_ = 1.0;       ///< what the merit left of the length
  double decrease_ = 0.0;  ///< −∇M·(δ, λ⁺ − λ, z⁺ − z)
  double largest_move_ = 0.0;
  double merit_before_ = 0.0, merit_after_ = 0.0;
  bool has_new_estimate_ = false;

  // Work space, kept so that a step does not allocate.
  Eigen::Matrix3Xd gradient_, pulls_, delta_, trial_, correction_;
  Eigen::VectorXd residuals_, trial_residuals_, linear_, remainder_, new_multipliers_,
      trial_multipliers_;
};

}  // namespace planish
