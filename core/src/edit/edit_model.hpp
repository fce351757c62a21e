// SPDX-License-Identifier: MIT
/// What is asked of an edit of one mesh, what that leaves free, and what a design is judged by.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "edit/base_violations.hpp"
#include "edit/edit_terms.hpp"
#include "edit/edit_verdict.hpp"
#include "engines/active_set.hpp"
#include "engines/exact_finish.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

class PartedPanels;

/// Mesh, options and targets of an edit. In a solve only the terms of the problem and the active
/// set change.
class EditModel {
 public:
  EditModel(const Mesh& mesh, const HandleEditOptions& options);
  ~EditModel();
  EditModel(const EditModel&) = delete;
  EditModel& operator=(const EditModel&) = delete;

  /// Costs O(n) where the kinds, the fairness or the limits are others.
  /// @returns whether mesh_model() is another one
  bool set_options(const HandleEditOptions& options);
  void set_targets(const EditTargets& targets);
  /// Takes other keep-outs than the options': for the images of a symmetry.
  void keep_out(const FreeSpace& free);
  /// Takes the keep-outs of the options again.
  void keep_out();
  /// A number that changes whenever what was exact before may have moved what cannot move now.
  [[nodiscard]] int revision() const { return revision_; }

  [[nodiscard]] const HandleEditOptions& options() const { return options_; }
  [[nodiscard]] const EditTargets& targets() const { return targets_; }
  [[nodiscard]] const MeshModel& mesh_model() const { return *model_; }
  [[nodiscard]] EditProblem& problem() { return problem_; }
  [[nodiscard]] const EditProblem& problem() const { return problem_; }
  [[nodiscard]] ActiveSet& active_set() { return active_set_; }
  /// Null: no panel can go through another unseen.
  [[nodiscard]] PartedPanels* parted_panels() { return parted_panels_.get(); }

  /// The terms for other targets of the same handles, or for other weights, on the way to those
  /// that are asked for.
  void pose(const EditTargets& targets, const HandleEditOptions& options);

  /// Whether limits are stated or keep-outs are there.
  [[nodiscard]] bool has_limits() const { return problem_.limits != nullptr; }
  /// Whether a jump to the targets may end beyond a barrier, where a path does not.
  [[nodiscard]] bool is_bounded() const { return options_.keep_shape || has_limits(); }
  /// Whether the barrier of keep-outs acts.
  [[nodiscard]] bool is_beside_keep_outs() const;
  /// Whether every handle is where it should be.
  [[nodiscard]] bool nothing_to_do() const;

  [[nodiscard]] ExactDesign finish(std::span<const int> support, const DisplacementField& field);
  /// A design that is told where its vertices are. @param shape 3 × n, model units
  [[nodiscard]] ExactDesign placed(const std::vector<int>& vertices, const Positions& shape);
  /// The base mesh as a design.
  [[nodiscard]] static ExactDesign unmoved();

  /// Whether the verdict accepts it, and hard handles are where they must be: the base itself is
  /// exact and sound, and what a solver has left where nothing can follow a handle.
  [[nodiscard]] bool is_acceptable(const ExactDesign& design) const;
  /// Largest distance of a handle from its target, solver units.
  [[nodiscard]] double handle_distance(const ExactDesign& design) const;
  [[nodiscard]] ObjectiveTerms objective(const ExactDesign& design);
  [[nodiscard]] HandleEditResult result_of(const ExactDesign& design, SolveReport report);

 private:
  void make_tools();
  void rebuild();
  [[nodiscard]] LimitBase limit_base() const;
  void set_supports(const std::vector<PointSupport>& supports);
  void state_limits();
  void make_slides();
  void make_verdict();
  void list_switching();

  HandleEditOptions options_;
  KeptKinds kept_;  ///< by the options
  std::unique_ptr<MeshModel> model_;
  std::unique_ptr<BaseViolations> base_;
  std::unique_ptr<MeshLimits> limits_;  ///< those stated last; the problem's, where any are now
  std::vector<StatedLimit> bounds_;     ///< of `limits_`
  std::unique_ptr<EditVerdict> verdict_;
  std::vector<PointSupport> supports_;    ///< of `slides_`
  std::unique_ptr<VertexSlides> slides_;  ///< null: no supports, nothing rests on a keep-out
  ActiveSet active_set_;
  std::unique_ptr<PartedPanels> parted_panels_;
  std::unique_ptr<ExactFinish> finish_;
  std::unique_ptr<PatchCutter> cutter_;
  EditProblem problem_;
  std::unique_ptr<EditTerms> terms_;
  EditTargets targets_;
  std::vector<int> pins_;        ///< ascending
  std::vector<int> limited_to_;  ///< handles that what may move depends on, ascending
  int revision_ = 0;
  double setup_seconds_ = 0.0;
};

}  // namespace planish
