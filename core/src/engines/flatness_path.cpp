// SPDX-License-Identifier: MIT
#include "engines/flatness_path.hpp"

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Figures of the iteration.
struct FlatnessPathTuning {
  static constexpr int kMostSteps = 40;     ///< for one μ
  static constexpr double kSettled = 1e-5;  ///< step that ends it, mean edges
};

}  // namespace

FlatnessPath::FlatnessPath(const Patch& patch)
    : solver_(PatchNewton::Factors::kChords, RowRule::kSprings) {
  attach(patch);
  outcome_.status = SolveStatus::kConverged;
}

void FlatnessPath::attach(const Patch& patch) {
  const PatchState rest{Eigen::Matrix3Xd::Zero(3, patch.free_count),
                        Eigen::Matrix3Xd::Zero(3, patch.free_count),
                        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(patch.equations.size()))};
  solver_.attach(patch, rest);
}

Eigen::Matrix3Xd FlatnessPath::settle(double penalty, const Eigen::Matrix3Xd& from,
                                      const Progress& progress) {
  solver_.set_penalty(penalty);
  PatchState start = solver_.state();
  start.displacement = from;
  solver_.set_state(std::move(start));
  for (int k = 0; k < FlatnessPathTuning::kMostSteps && solver_.step(); ++k) {
    ++outcome_.cost.steps;
    outcome_.records.push_back({.objective = solver_.objective(),
                                .primal_residual = solver_.violation(),
                                .step = solver_.length()});
    if (progress && progress(outcome_.records.back()) == Flow::kStop) {
      outcome_.status = SolveStatus::kCancelled;
      break;
    }
    if (solver_.length() <= FlatnessPathTuning::kSettled) break;
  }
  outcome_.cost.factorizations = solver_.factorizations();
  return solver_.state().displacement;
}

}  // namespace planish
