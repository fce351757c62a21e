// SPDX-License-Identifier: MIT
#include "engines/limit_correction.hpp"

#include "engines/patch_system.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr int kMostLimitPasses = 6;
constexpr double kStiffEquations = 1e8;  ///< of the equations
constexpr double kStiffLimits = 1e8;     ///< of the limits that were broken
constexpr double kBroken = 0.5 * kLimitMargin;

/// The patch with nothing to want but to stay where it is, and its limits.
Patch at_rest(const Patch& patch) {
  Patch unit = patch;
  for (VertexTerm& term : unit.terms) term = {.square_weight = 1.0};
  unit.fairness_weight = 0.0;
  unit.fairness_vertices = {};
  unit.fairness_vertices.offsets.assign(1, 0);
  unit.inequalities.of<ShapeBound>().clear();
  unit.inequalities.of<KeepOutPlane>().clear();
  return unit;
}

}  // namespace

bool breaks_limits(const Patch& patch, const Eigen::Matrix3Xd& displacement) {
  PatchLagrangian lagrangian;
  lagrangian.attach(patch);
  Eigen::VectorXd shares;
  lagrangian.shares(displacement, shares);
  return shares.size() > 0 && shares.minCoeff() < -kBroken;
}

void correct_limits(const Patch& patch, Eigen::Matrix3Xd& displacement, int& factorizations) {
  const Patch unit = at_rest(patch);
  PatchSystem system;
  system.attach(unit);
  PatchState state;
  state.norm_dual.setZero(3, patch.free_count);
  state.multipliers.setZero(static_cast<Eigen::Index>(patch.equations.size()));
  state.limit_multipliers.setZero(static_cast<Eigen::Index>(unit.inequalities.size()));
  std::vector<char> held(unit.inequalities.size(), 0);
  Eigen::VectorXd shares, residuals, pulls;
  Eigen::Matrix3Xd gradient, delta;
  for (int pass = 0; pass < kMostLimitPasses; ++pass) {
    system.lagrangian().shares(displacement, shares);
    if (shares.minCoeff() >= -kBroken) break;
    pulls.setZero(shares.size());
    for (Eigen::Index i = 0; i < shares.size(); ++i) {
      char& is_held = held[static_cast<std::size_t>(i)];
      if (shares[i] < -kBroken) is_held = 1;
      if (is_held != 0) pulls[i] = kStiffLimits * shares[i];
    }
    state.displacement = displacement;
    system.evaluate_limits(displacement);
    system.activate(held, kStiffLimits);
    ++factorizations;
    if (!system.factorize(state, 1.0, kStiffEquations, 0.0)) break;
    gradient.setZero(3, patch.free_count);
    system.limit_jacobian().add_transposed(pulls, gradient);
    system.lagrangian().residuals(displacement, residuals);
    system.step(gradient, residuals, delta);
    displacement += delta;
  }
}

}  // namespace planish
