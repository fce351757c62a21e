// SPDX-License-Identifier: MIT
/// What a finished design is judged by: its constraints, its panels' shapes, its stated limits.
#pragma once

#include <functional>
#include <vector>

#include "edit/base_violations.hpp"
#include "engines/exact_finish.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/problem/problem.hpp"
#include "planish/problem/solve_report.hpp"

namespace planish {

/// What is asked of a design beside its constraints.
struct EditBounds {
  bool keep_shape = true;
  const MeshLimits* limits = nullptr;    ///< null: none are stated
  const VertexSlides* slides = nullptr;  ///< null: no supports
};

/// Judges designs of one mesh. Keeps references to model and base.
class EditVerdict {
 public:
  EditVerdict(const MeshModel& model, const BaseViolations& base, const KeptKinds& kept,
              const EditBounds& bounds)
      : model_(model), base_(base), kept_(kept), bounds_(bounds) {}

  /// Exact, no panel lost the shape it had, every stated limit holds, every point is on its
  /// support.
  [[nodiscard]] bool is_acceptable(const ExactDesign& design) const;

  /// Where a vertex of the design is, in solver units. The design outlives it.
  [[nodiscard]] std::function<Eigen::Vector3d(int)> places(const ExactDesign& design) const;

  /// `status`, or kToleranceNotMet: a design of a base that broke a constraint itself is no exact
  /// one, however it ended.
  [[nodiscard]] SolveStatus downgrade_if_base_violates(SolveStatus status,
                                                       const ExactDesign& design) const;

  /// Every kept kind and every stated limit.
  void add_to(SolveReport& report, const ExactDesign& design) const;

 private:
  [[nodiscard]] bool is_exact(const ExactDesign& design) const;
  [[nodiscard]] bool keeps_shape(const ExactDesign& design) const;
  [[nodiscard]] bool keeps_limits(const ExactDesign& design) const;
  [[nodiscard]] bool keeps_supports(const ExactDesign& design) const;
  [[nodiscard]] Violations violations_with(const ExactDesign& design) const;

  const MeshModel& model_;
  const BaseViolations& base_;
  KeptKinds kept_;
  EditBounds bounds_;
};

}  // namespace planish
