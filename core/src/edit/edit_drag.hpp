// SPDX-License-Identifier: MIT
/// The frames of a drag: each from the last, exact, within its time.
#pragma once

#include <optional>
#include <vector>

#include "edit/edit_search.hpp"

namespace planish {

/// A drag that begins at the base. Whatever changes what may move begins another one.
class EditDrag {
 public:
  EditDrag(EditModel& model, EditSearch& search);

  /// Solves for the targets that are set, from the last frame. @see HandleEditSolver::drag()
  [[nodiscard]] HandleEditResult frame(double budget_seconds);

  /// Marks where the drag stands. Costs what moved.
  void keep_frame();
  /// Back to what was kept last.
  void go_back();

 private:
  /// Where a drag stands; where it begins: nothing moves, nothing was exact yet.
  struct Place {
    std::vector<int> support;
    std::optional<ExactDesign> exact;  ///< with the pins of the targets
  };
  struct Kept {
    Place place;
    DisplacementField::Snapshot field;
  };

  void forget_if_revised();
  [[nodiscard]] ExactDesign follow(bool fresh, const Progress& in_time, SolveReport& report);

  EditModel& model_;
  EditSearch& search_;
  DisplacementField field_;
  Place now_;
  Kept kept_;
  int revision_;  ///< of the model that the drag is about
};

}  // namespace planish
