// SPDX-License-Identifier: MIT
/// What the objective of an edit asks of each vertex.
#pragma once

#include <utility>
#include <vector>

#include "edit/edit_reach.hpp"
#include "edit/softness.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Writes the terms of (3) into a problem: handles are drawn to their targets; pins, a kept
/// boundary and what is outside the reach are fixed; the rest stays where it is by ω_s, and by its
/// spring. Remembers which terms are not the default, so that new targets cost what they, the last
/// ones and their reaches hold, not the mesh.
class EditTerms {
 public:
  explicit EditTerms(const MeshModel& model) : reach_(model.mesh, model.adjacency) {}

  /// Every vertex its default; `problem.model` is set, and `problem.terms` as the last fill() and
  /// assign() left them. Within a reach every default is the same: other options cost nothing O(n).
  void fill(const HandleEditOptions& options, EditProblem& problem);

  /// The handles and pins of `targets` and no others; `problem.handles` ascending.
  void assign(const EditTargets& targets, const HandleEditOptions& options, EditProblem& problem);

 private:
  void open_reach(const EditTargets& targets, const HandleEditOptions& options,
                  EditProblem& problem);
  void list_springs(const std::vector<PointSupport>& supports, const Mesh& mesh);
  void add_springs(const EditWeights& weights, EditProblem& problem);
  void add_handles(const EditTargets& targets, const EditWeights& weights, bool hard,
                   EditProblem& problem);
  void override_term(int vertex, const VertexTerm& term, EditProblem& problem);

  EditReach reach_;
  VertexTerm rest_;                              ///< of what may move and is no handle
  bool all_fixed_ = false;                       ///< every default is: there is a reach
  std::vector<PointSupport> supports_;           ///< of `springs_`
  std::vector<std::pair<int, double>> springs_;  ///< vertices and their stiffness
  std::vector<int> overridden_;                  ///< vertices whose term is not the default
};

}  // namespace planish
