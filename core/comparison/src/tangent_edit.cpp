// SPDX-License-Identifier: MIT
#include "engines/constraint_correction.hpp"
#include "held_boundary.hpp"
#include "planish/comparison/methods.hpp"
#include "tangent_space.hpp"

namespace planish::comparison {

ComparedEdit edit_in_tangent_space(const EditTask& task) {
  constexpr int kPasses = 30;
  constexpr double kFlat = 1e-9;  // mean edges
  const EditTask held = with_held_boundary(task);
  const MeshModel model(held.mesh, held.options.fairness);
  const EditProblem soft = pose(held, model, false);
  Patch patch = cut_all(soft);
  const TangentSpace space(patch);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * patch.free_count);
  for (int v = 0; v < patch.free_count; ++v) {
    const VertexTerm& term = patch.terms[static_cast<std::size_t>(v)];
    right.segment<3>(3 * v) = term.square_weight * term.target;
  }
  ComparedEdit result;
  if (!space.usable()) {
    result.positions = held.mesh.positions;
    return result;
  }
  const Eigen::VectorXd t = space.solve(right);
  Eigen::Matrix3Xd free = Eigen::Map<const Eigen::Matrix3Xd>(t.data(), 3, patch.free_count);
  result.finished = correct_constraints(patch, kPasses, free, result.steps) <= kFlat;
  patch.displacement.leftCols(patch.free_count) = free;
  result.positions = displaced(model, patch);
  return result;
}

}  // namespace planish::comparison
