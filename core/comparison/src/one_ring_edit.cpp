// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engines/constraint_correction.hpp"
#include "planish/comparison/methods.hpp"

namespace planish::comparison {

ComparedEdit edit_one_ring(const EditTask& task) {
  constexpr int kParts = 8;
  constexpr int kPasses = 20;
  constexpr double kFlat = 1e-9;  // mean edges
  const MeshModel model(task.mesh, task.options.fairness);
  EditProblem problem = pose(task, model, true);
  std::vector<int> ring;
  for (const Handle& handle : task.targets.handles) {
    for (const int f : model.adjacency.faces[handle.vertex]) {
      const auto face = model.face(f);
      ring.insert(ring.end(), face.begin(), face.end());
    }
  }
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  Patch patch = cut(problem, ring);
  const Positions pulled = patch.displacement;
  ComparedEdit result;
  // The handle comes in parts: Newton's method from afar finds folded solutions.
  for (int part = 1; part <= kParts; ++part) {
    const auto halo = patch.local_count() - patch.free_count;
    patch.displacement.rightCols(halo) =
        (static_cast<double>(part) / kParts) * pulled.rightCols(halo);
    Eigen::Matrix3Xd free = patch.displacement.leftCols(patch.free_count);
    result.finished = correct_constraints(patch, kPasses, free, result.steps) <= kFlat;
    patch.displacement.leftCols(patch.free_count) = free;
  }
  result.positions = displaced(model, patch);
  return result;
}

}  // namespace planish::comparison
