// SPDX-License-Identifier: MIT
/// From a nearly exact state to a design: exact panels on the support, nothing moved elsewhere.
#pragma once

#include <span>
#include <vector>

#include "planish/engines/displacement_field.hpp"
#include "planish/engines/working_set.hpp"
#include "planish/problem.hpp"

namespace planish {

/// A finished state of the mesh: the moved vertices only.
struct ExactDesign {
  std::vector<int> vertices;  ///< ascending; all others have displacement exactly 0
  Positions displacement;     ///< 3 × |vertices|, solver units
  Positions positions;        ///< 3 × |vertices|, model units, as they will be written
  std::vector<int> faces;     ///< ascending: faces with a moved vertex
  double worst_mm_per_m = 0;  ///< over `faces`, measured on `positions` [MET-1]
  double worst_excess = 0;    ///< the same for FacePlanarity::excess: what a tolerance bounds
  int factorizations = 0;
};

class ExactFinish {
 public:
  explicit ExactFinish(const MeshModel& model);

  /// Corrects `field` on `support` with the handles held, then free, then on a wider support, until
  /// the excess of every touched panel is within `tolerance` (mm/m); the best attempt is returned
  /// in any case.
  [[nodiscard]] ExactDesign finish(const EditProblem& problem, std::span<const int> support,
                                   const DisplacementField& field, double tolerance);

 private:
  ExactDesign attempt(const EditProblem& problem, std::span<const int> support,
                      const DisplacementField& field, bool hold_handles);
  void measure(ExactDesign& design);

  const MeshModel& model_;
  PatchCutter cutter_;
  WorkingSetGrower grower_;
  Patch patch_;
  std::vector<int> local_of_;  ///< mesh vertex → column of the design being measured, or −1
  std::vector<int> face_mark_;
  int stamp_ = 0;
};

/// [PB-1] of a design: everything it leaves unmoved contributes nothing.
[[nodiscard]] ObjectiveTerms design_objective(const EditProblem& problem, const ExactDesign& design,
                                              PatchCutter& cutter);

}  // namespace planish
