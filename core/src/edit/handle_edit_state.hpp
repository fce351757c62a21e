// SPDX-License-Identifier: MIT
/// What an edit keeps between its solves. Its functions stand in six files: handle_edit.cpp sets up
/// and hands out, handle_edit_search.cpp finds a certified design, handle_edit_parts.cpp goes there
/// in parts, handle_edit_drag.cpp makes the frames of a drag, handle_edit_symmetric.cpp solves
/// under a symmetry, handle_edit_keep_outs.cpp is what all of them do about keep-outs.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "edit/base_violations.hpp"
#include "edit/edit_terms.hpp"
#include "edit/edit_verdict.hpp"
#include "engines/exact_finish.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Between two weights of the limits' barrier. [LIM-2]
inline constexpr double kLimitWeightShrink = 0.1;

/// What an edit within a reach is worth: steps of its searches, of its settling and of a part of
/// the way, and factorizations of all parts.
struct SearchBudget {
  int coarse, last, first_settle, settle, part, all_parts;
};

class HandleEditSolver::State {
 public:
  State(const Mesh& mesh, const HandleEditOptions& options);

  void set_options(const HandleEditOptions& options);
  HandleEditResult solve(const EditTargets& targets, const Progress& progress);
  HandleEditResult solve_symmetric(const EditTargets& targets, const MeshSymmetry& symmetry,
                                   const Progress& progress);
  HandleEditResult drag(const EditTargets& targets, double budget_seconds);
  void keep_frame();
  void go_back();

 private:
  void rebuild();
  void state_limits();
  void make_slides();
  void open_tracks();
  void make_verdict();
  void forget_drag();
  [[nodiscard]] bool is_bounded() const;
  void set_targets(const EditTargets& targets);
  void set_supports(const std::vector<PointSupport>& supports);
  ExactDesign find_design(const Progress& progress, SolveReport& report);
  ExactDesign placed(const std::vector<int>& vertices, const Positions& shape);
  ExactDesign evened(const ExactDesign& design, const MeshSymmetry& symmetry, double share);
  std::optional<ExactDesign> make_symmetric(const ExactDesign& found, const MeshSymmetry& symmetry,
                                            double share);
  std::optional<ExactDesign> make_symmetric(const ExactDesign& found, const MeshSymmetry& symmetry);
  std::optional<ExactDesign> solve_by_copies(const EditTargets& targets,
                                             const MeshSymmetry& symmetry, const Progress& progress,
                                             SolveReport& report);
  ExactDesign find_symmetric(const EditTargets& targets, const MeshSymmetry& symmetry,
                             const Progress& progress, SolveReport& report);
  ExactDesign solve_together(const MeshSymmetry& symmetry, const Progress& progress,
                             SolveReport& report);
  ExactDesign solve_newton(const Progress& progress, SolveReport& report);
  ExactDesign settle(const NewtonOptions& options, const Progress& progress, SolveReport& report);
  void take_slow_movers_along(ExactDesign& design, SolveReport& report);
  [[nodiscard]] bool turns(const ExactDesign& design);
  [[nodiscard]] bool has_keep_outs() const { return !options_.keep_outs.empty(); }
  // Of an edit that has any:
  void keep_out();
  void keep_out(const FreeSpace& free);
  void make_rests();
  void open_planes();
  void forget_parted();
  [[nodiscard]] bool goes_through_itself(const ExactDesign& design);
  void part_panels(const std::function<ExactDesign(SolveReport&)>& find, ExactDesign& design,
                   SolveReport& report);
  [[nodiscard]] bool keep_outs_turn() const;
  [[nodiscard]] bool turn_planes(const ExactDesign& design);
  [[nodiscard]] bool meets_keep_outs(const ExactDesign& design);
  [[nodiscard]] bool lets_go();
  void hold_back(const std::vector<int>& support, ExactDesign& design);
  [[nodiscard]] NewtonOptions engine_options() const;
  [[nodiscard]] bool follows_softness() const;
  [[nodiscard]] const SearchBudget& budget() const;
  std::optional<ExactDesign> settle_at_limits(const NewtonOptions& options,
                                              const Progress& progress, SolveReport& report);
  void choose_sides(const NewtonOptions& options, const Progress& progress, SolveReport& report);
  EngineOutcome follow(bool fresh, DisplacementField& field, const Progress& progress);
  EngineOutcome continue_from_base(const NewtonOptions& options, const Progress& progress);
  EngineOutcome soften(const NewtonOptions& options, const Progress& progress);
  ExactDesign solve_in_parts(const Progress& progress, SolveReport& report);
  ExactDesign solve_augmented_lagrangian(const Progress& progress, SolveReport& report);
  HandleEditResult result_of(const ExactDesign& design, SolveReport report);
  [[nodiscard]] bool nothing_to_do() const;
  [[nodiscard]] static ExactDesign unmoved();
  ExactDesign run_engine(const Progress& progress, SolveReport& report);
  ExactDesign come_nearer(const Progress& progress, SolveReport& report);
  [[nodiscard]] double handle_distance(const ExactDesign& design) const;
  [[nodiscard]] bool is_acceptable(const ExactDesign& design) const;
  [[nodiscard]] bool stops_short(const ExactDesign& design, const SolveReport& report) const;
  void try_in_parts(const Progress& progress, ExactDesign& design, SolveReport& report);

  HandleEditOptions options_;
  KeptKinds kept_;  ///< by the options
  std::unique_ptr<MeshModel> model_;
  std::unique_ptr<BaseViolations> base_;
  std::unique_ptr<MeshLimits> limits_;  ///< null: none are stated
  std::unique_ptr<EditVerdict> verdict_;
  std::vector<PointSupport> supports_;    ///< of `slides_`
  std::unique_ptr<VertexSlides> slides_;  ///< null: no supports, nothing rests on a keep-out
  std::unique_ptr<WorkingSetNewton> newton_;
  std::unique_ptr<DisplacementField> field_;  ///< of the drag
  std::unique_ptr<DisplacementField> trial_;  ///< of cold starts
  std::unique_ptr<ExactFinish> finish_;
  std::unique_ptr<PatchCutter> cutter_;
  EditProblem problem_;
  std::unique_ptr<EditTerms> terms_;
  EditTargets targets_;  ///< of the solve
  std::vector<int> drag_support_;
  std::optional<ExactDesign> last_exact_;  ///< of the drag, with the pins of the targets
  /// What keep_frame() saw; empty: the drag's start.
  struct KeptFrame {
    std::vector<int> support;
    std::optional<ExactDesign> last_exact;
    DisplacementField::Snapshot field;
  };
  KeptFrame kept_frame_;
  std::vector<int> pins_;        ///< ascending
  std::vector<int> limited_to_;  ///< handles that what may move depends on, ascending
  double setup_seconds_ = 0.0;
};

}  // namespace planish
