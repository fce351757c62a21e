// SPDX-License-Identifier: MIT
/// From a nearly exact state to a design: exact panels on the support, nothing moved elsewhere.
#pragma once

#include <span>
#include <vector>

#include "engines/displacement_field.hpp"
#include "engines/working_set.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// A finished state of the mesh: the moved vertices only.
struct ExactDesign {
  std::vector<int> vertices;  ///< ascending; all others have displacement exactly 0
  Positions displacement;     ///< 3 × |vertices|, solver units
  Positions positions;        ///< 3 × |vertices|, model units, as they will be written
  std::vector<int> faces;     ///< ascending: faces with a moved vertex
  std::vector<int> stars;     ///< ascending: inner vertices that moved or have a moved neighbour,
                              ///< where a kept kind hangs on vertices
  Violations worst;           ///< over `faces` and `stars`, measured on `positions`

  /// The elements of a sort that the design touches.
  [[nodiscard]] const std::vector<int>& touched(Element element) const {
    return element == Element::kFace ? faces : stars;
  }
  SolveCost cost;  ///< of making it exact
};

class ExactFinish {
 public:
  explicit ExactFinish(const MeshModel& model);

  /// Corrects `field` on `support` with the handles held, then free, then on a wider support, until
  /// every touched panel is within the tolerances of `kept`; the best attempt is returned in any
  /// case. Moves that are no more than rounding are none, unless the kinds need them.
  [[nodiscard]] ExactDesign finish(const EditProblem& problem, std::span<const int> support,
                                   const DisplacementField& field, const KeptKinds& kept);

  /// The design whose vertices are where they are told to be. @param vertices ascending
  /// @param positions 3 × |vertices|, model units
  [[nodiscard]] ExactDesign measured(std::vector<int> vertices, Positions positions);

 private:
  ExactDesign attempt(const EditProblem& problem, std::span<const int> support,
                      const DisplacementField& field, bool hold_handles);
  [[nodiscard]] ExactDesign without_rounding(ExactDesign design, const EditProblem& problem,
                                             const KeptKinds& kept);
  void measure(ExactDesign& design);
  void find_stars(ExactDesign& design);
  void measure_element(Element element, int index, std::span<const int> vertices,
                       ExactDesign& design);

  const MeshModel& model_;
  PatchCutter cutter_;
  WorkingSetGrower grower_;
  Patch patch_;
  double rounding_;            ///< mean edges: up to there a move is none
  std::vector<int> local_of_;  ///< mesh vertex → column of the design being measured, or −1
  std::vector<int> face_mark_;
  int stamp_ = 0;
  Positions corners_;       ///< of the element being measured
  std::vector<int> order_;  ///< 0, 1, 2 …
};

/// A design's displacement of a patch's free vertices, 3 × free.
[[nodiscard]] Eigen::Matrix3Xd displacement_on(const Patch& patch, const ExactDesign& design);

/// [PB-1] of a design: everything it leaves unmoved contributes nothing.
[[nodiscard]] ObjectiveTerms design_objective(const EditProblem& problem, const ExactDesign& design,
                                              PatchCutter& cutter);

}  // namespace planish
