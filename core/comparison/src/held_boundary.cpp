// SPDX-License-Identifier: MIT
#include "held_boundary.hpp"

#include <algorithm>

#include "planish/mesh/adjacency.hpp"

namespace planish::comparison {

EditTask with_held_boundary(EditTask task) {
  task.options.sparsity = Sparsity::kNone;
  const Adjacency adjacency = build_adjacency(task.mesh);
  std::vector<int>& pins = task.targets.pins;
  for (int v = 0; v < task.mesh.vertex_count(); ++v) {
    const bool handle = std::any_of(task.targets.handles.begin(), task.targets.handles.end(),
                                    [v](const Handle& h) { return h.vertex == v; });
    if (adjacency.boundary[static_cast<std::size_t>(v)] != 0 && !handle) pins.push_back(v);
  }
  std::sort(pins.begin(), pins.end());
  pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
  return task;
}

}  // namespace planish::comparison
