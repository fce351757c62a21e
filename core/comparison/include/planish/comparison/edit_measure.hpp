// SPDX-License-Identifier: MIT
/// One yardstick for every method's result.
#pragma once

#include "planish/comparison/edit_task.hpp"

namespace planish::comparison {

/// What an edit did to the mesh; energies in mean-edge units, unweighted.
struct EditMeasure {
  int moved = 0;              ///< vertices whose coordinates are not bit-identical
  int moved_visibly = 0;      ///< vertices moved by more than 1e-3 of the largest pull
  double displacement = 0.0;  ///< ‖d‖_{2,1} over all but the handles
  double fairness = 0.0;      ///< ‖E d‖²
  double objective = 0.0;     ///< (3) with the task's weights, handles included
  double planarity = 0.0;     ///< worst panel, mm/m
  double handle_error = 0.0;  ///< largest distance of a handle from its target, model units
  double edge_strain = 0.0;   ///< largest relative change of an edge's length
  double fold_change = 0.0;   ///< largest change of the angle between neighbouring panels, degrees
};

/// @param positions 3 × n, the edited mesh
[[nodiscard]] EditMeasure measure(const EditTask& task, const Positions& positions);

}  // namespace planish::comparison
