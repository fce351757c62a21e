// SPDX-License-Identifier: MIT
/// (8) on one mesh by one engine.
#pragma once

#include <optional>
#include <vector>

#include "engines/displacement_field.hpp"
#include "engines/exact_finish.hpp"
#include "engines/nearest_weighted.hpp"
#include "planish/problem/problem.hpp"
#include "planish/projection/projection.hpp"
#include "problem/shape_slides.hpp"

namespace planish {

/// One projection: the problem, the engine that suits it, and the result.
class Projector {
 public:
  Projector(const Mesh& mesh, const ProjectionOptions& options, const std::vector<int>& pins);

  /// α_d ‖t̃‖², every vertex free. [PRO-2]
  void penalise_squares();
  /// α_d Σ w_i ‖t̃_i‖ with w_i = s / (s + ‖p̃_i − p⁰_i‖): 1 where nothing moved yet. [PRO-3]
  /// @param reference p⁰, 3 × n
  void penalise_unmoved(const Positions& reference);
  /// Points keep to options.supports, which are about `base`. [SUP-6]
  void stand_on(const Mesh& base);
  /// Lets no panel lose its shape. [SHP-3]
  void keep_shape() { problem_.shape_weight = kShapeWeight; }
  /// Holds all vertices but those within `rings` face rings of the failing faces.
  void confine(const std::vector<int>& failing, int rings);

  /// Once. The result's moves are those of the engine; planarity is the caller's to measure.
  [[nodiscard]] ProjectionResult run(const std::vector<int>& failing, const Progress& progress);

 private:
  void solve(const std::vector<int>& failing, const Progress& progress);
  [[nodiscard]] ExactDesign solve_on_tracks(const std::vector<int>& failing,
                                            const Progress& progress);
  void solve_nearest(const Progress& progress);
  [[nodiscard]] EngineOutcome nearest_of_small(const Patch& patch, const Progress& progress,
                                               Eigen::Matrix3Xd& displacement) const;
  [[nodiscard]] EngineOutcome nearest_of_large(const Patch& patch, const Progress& progress,
                                               Eigen::Matrix3Xd& displacement) const;
  void solve_newton(const std::vector<int>& failing, const Progress& progress);
  void solve_weighted(const std::vector<int>& failing, const Progress& progress);
  void solve_augmented_lagrangian(const Progress& progress);
  void certify(const ExactDesign& design, PatchCutter& cutter);
  [[nodiscard]] std::vector<int> everything() const;

  ProjectionOptions options_;
  KeptKinds kept_;
  MeshModel model_;
  EditProblem problem_;
  DisplacementField field_;
  std::optional<ShapeSlides> slides_;        ///< none: no supports
  std::optional<NearestWeighted> weighted_;  ///< once it has run
  std::vector<int> free_;                    ///< empty: every vertex
  std::vector<int> support_;
  SolveReport report_;
};

}  // namespace planish
