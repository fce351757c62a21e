// SPDX-License-Identifier: MIT
/// (8) with its weighted distance Σ w_i ‖t_i‖, to a first-order point with its support. [PRO-3]
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engines/displacement_field.hpp"
#include "engines/engine_outcome.hpp"
#include "engines/patch_newton.hpp"
#include "engines/working_set.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

struct NearestWeightedOptions {
  int max_steps = 500;  ///< > 0
};

/// Newton's method on the rows of the surroundings of what fails, everything that they touch free:
/// a relaxation as in [OPT-2]. Smoothed by as much as panels are off, the problem is nearly the
/// nearest flat mesh's; ε then falls to nothing, and what moves at the rim joins.
class NearestWeighted {
 public:
  explicit NearestWeighted(const MeshModel& model);

  /// Runs from t = 0. kConverged: flat, and followed down to the last ε; optimality() tells how
  /// well.
  /// @param problem norm weights on all free vertices
  /// @param seeds vertices of the failing elements
  EngineOutcome run(const EditProblem& problem, std::span<const int> seeds,
                    const NearestWeightedOptions& options, const Progress& progress);

  /// What moves, ascending, and where to.
  [[nodiscard]] const std::vector<int>& support() const { return support_; }
  [[nodiscard]] const DisplacementField& field() const { return field_; }

  /// The conditions at a design near the state that run() left, with its multipliers.
  /// @param vertices ascending; @param displacement 3 × |vertices|, all other vertices at rest
  [[nodiscard]] Optimality optimality(std::span<const int> vertices,
                                      const Eigen::Matrix3Xd& displacement) const;

 private:
  void open_patch(const EditProblem& problem);
  [[nodiscard]] bool solve_at(double smoothing, double stationary, int most_steps,
                              const Progress& progress, EngineOutcome& outcome);
  [[nodiscard]] bool follow(const EditProblem& problem, int most_steps, const Progress& progress,
                            double& smoothing, EngineOutcome& outcome);
  [[nodiscard]] bool add_movers(const EditProblem& problem, double smoothing);
  [[nodiscard]] std::vector<int> movers_at_rim(double smoothing) const;
  void scale_what_rests(double smoothing, double factor);
  void keep_support(double smoothing);

  PatchCutter cutter_;
  WorkingSetGrower grower_;
  DisplacementField field_;
  Patch patch_;
  PatchNewton newton_;
  std::vector<int> working_, support_;
  double scale_ = 0.0;  ///< by how much rows fail at t = 0, mean edges
};

}  // namespace planish
