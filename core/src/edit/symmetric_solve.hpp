// SPDX-License-Identifier: MIT
/// A solve under a symmetry: one handle and copies of it where its images are far away, all of them
/// together where they are near; evened out, and judged as every edit is. [SYM-2]
#pragma once

#include <optional>
#include <vector>

#include "edit/edit_search.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {

class SymmetricSolve {
 public:
  SymmetricSolve(EditModel& model, EditSearch& search, const MeshSymmetry& symmetry)
      : model_(model), search_(search), symmetry_(symmetry) {}

  /// An acceptable symmetric design, at the worst the base itself. `targets` are those that are set
  /// afterwards.
  [[nodiscard]] ExactDesign find(const EditTargets& targets, const Progress& progress,
                                 SolveReport& report);

 private:
  [[nodiscard]] std::optional<ExactDesign> solve_by_copies(const EditTargets& targets,
                                                           const Progress& progress,
                                                           SolveReport& report);
  [[nodiscard]] ExactDesign solve_together(const Progress& progress, SolveReport& report);
  [[nodiscard]] bool are_far_apart(const EditTargets& targets, const std::vector<int>& vertices);
  [[nodiscard]] ExactDesign copied(const ExactDesign& one, const std::vector<std::size_t>& copies);
  [[nodiscard]] ExactDesign evened(const ExactDesign& design, const MeshSymmetry& symmetry,
                                   double share);
  [[nodiscard]] std::optional<ExactDesign> make_symmetric(const ExactDesign& found,
                                                          const MeshSymmetry& symmetry,
                                                          double share);
  [[nodiscard]] std::optional<ExactDesign> make_symmetric(const ExactDesign& found,
                                                          const MeshSymmetry& symmetry);

  EditModel& model_;
  EditSearch& search_;
  const MeshSymmetry& symmetry_;
};

}  // namespace planish
