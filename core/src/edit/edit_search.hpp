// SPDX-License-Identifier: MIT
/// From the base to a certified design: a continuation to the targets and keep-outs, one settling
/// at its end, and the way in parts for what a jump does not reach. Its functions stand in three
/// files: edit_search.cpp, edit_continuation.cpp and edit_parts.cpp.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "edit/edit_model.hpp"
#include "engines/working_set_newton.hpp"

namespace planish {

using FindDesign = std::function<ExactDesign(SolveReport&)>;

class EditSearch {
 public:
  explicit EditSearch(EditModel& model);

  /// An acceptable design for the targets that are set, at the worst the base itself. Its active
  /// set is the model's, which is reset before.
  [[nodiscard]] ExactDesign find(const Progress& progress, SolveReport& report);

  /// The steps of a frame of a drag, from the support that the engine holds or, `fresh`, from
  /// nothing.
  EngineOutcome follow(bool fresh, DisplacementField& field, const Progress& progress);

  /// Points that keep-outs hold and that are pulled away are held no longer. @see
  /// ActiveSet::release()
  bool release();

  /// An exact design near one that need not be exact, with the same vertices moving.
  [[nodiscard]] ExactDesign corrected(const ExactDesign& design);

  /// The conditions at a design near the one that find() ended with.
  [[nodiscard]] Optimality optimality(const ExactDesign& design);

  [[nodiscard]] WorkingSetNewton& newton() { return newton_; }
  [[nodiscard]] const WorkingSetNewton& newton() const { return newton_; }

 private:
  /// What an edit within a reach is worth: steps of its searches and of its settling.
  struct Budget {
    int coarse, last, first_settle, settle;
  };

  /// What going in parts is worth: steps of one, factorizations of all.
  struct PartsBudget {
    int part, all;
  };

  /// An edit of nearer targets. `left`: from those that were asked for, ∞ where it is no answer.
  struct Pull {
    double part = 0.0;
    ExactDesign design;
    SolveReport report;
    bool follows = false;
    double left = std::numeric_limits<double>::infinity();
  };

  /// Other targets than those that are asked for, which stand again after it.
  class OtherTargets {
   public:
    OtherTargets(EditSearch& search, const EditTargets& now);
    OtherTargets(const OtherTargets&) = delete;
    OtherTargets& operator=(const OtherTargets&) = delete;
    ~OtherTargets();

   private:
    void take(const EditTargets& targets);

    EditSearch& search_;
    EditTargets asked_;
  };

  /// From where on handles are so far from their targets, of their way, that nearer ones are tried.
  static constexpr double kFarShort = 0.5;

  /// Where a search stands: what moves, and how.
  struct Place {
    std::vector<int> support;
    DisplacementField::Snapshot field;
  };

  [[nodiscard]] bool follows_softness() const;
  [[nodiscard]] bool is_limited() const;
  [[nodiscard]] bool is_short_way() const;
  [[nodiscard]] bool parts_help() const;
  [[nodiscard]] Budget budget() const;
  [[nodiscard]] PartsBudget parts_budget() const;
  [[nodiscard]] NewtonOptions engine_options() const;
  [[nodiscard]] Place place() const { return {newton_.support(), field_.snapshot()}; }
  void go_back(const Place& place);
  void set_field(const ExactDesign& design);
  void load(const ExactDesign& design);
  [[nodiscard]] ExactDesign design() { return model_.finish(newton_.support(), field_); }

  ExactDesign find_freely(const Progress& progress, SolveReport& report);

  // The engines.
  ExactDesign run_engine(const Progress& progress, SolveReport& report);
  ExactDesign solve_newton(const Progress& progress, SolveReport& report);
  ExactDesign solve_augmented_lagrangian(const Progress& progress, SolveReport& report);
  ExactDesign settle(const NewtonOptions& options, const Progress& progress, SolveReport& report);
  void refine(const NewtonOptions& options, ExactDesign& design, SolveReport& report);
  void take_if_certified(ExactDesign& design, SolveReport& report);
  void include_slow_movers(ExactDesign& design, SolveReport& report);

  // The continuation.
  EngineOutcome continue_from_base(const NewtonOptions& options, const Progress& progress);
  EngineOutcome soften(const NewtonOptions& options, const Progress& progress);
  void update_active_set(const NewtonOptions& options, const Progress& progress,
                         SolveReport& report);
  std::optional<ExactDesign> settle_at_keep_outs(const NewtonOptions& options,
                                                 const Progress& progress, SolveReport& report);

  [[nodiscard]] EditTargets part_of(const EditTargets& targets, double part) const;

  // The way in parts, and less far.
  [[nodiscard]] bool stops_short(double share, const ExactDesign& design,
                                 const SolveReport& report) const;
  [[nodiscard]] static bool is_certified(const SolveReport& report) {
    return report.optimality && report.optimality->met();
  }
  [[nodiscard]] bool may_look_on() const;
  void try_way(const FindDesign& way, ExactDesign& design, SolveReport& report);
  void stand_at(const ExactDesign& design);
  [[nodiscard]] double objective_or_infinite(const ExactDesign& design);
  [[nodiscard]] bool has_outlines() const;
  [[nodiscard]] EditTargets with_outlines_pinned() const;
  void slide_from_pinned_outlines(const Progress& progress, ExactDesign& design,
                                  SolveReport& report);
  std::optional<ExactDesign> solve_with_pinned_outlines(const Progress& progress,
                                                        SolveReport& report);
  Pull pull(double part, const Progress& progress);
  void find_nearer(const Progress& progress, ExactDesign& design, SolveReport& report);
  ExactDesign advance(bool cold, const NewtonOptions& options, const Progress& progress,
                      SolveReport& report);
  ExactDesign solve_in_parts(const Progress& progress, SolveReport& report);
  ExactDesign fall_back(const Progress& progress, SolveReport& report);
  void pull_harder(const Progress& progress, ExactDesign& design, SolveReport& report);
  void hold_at_targets(const Progress& progress, ExactDesign& design, SolveReport& report);

  /// The options of the edit, its handles soft where no flat design meets hard ones.
  [[nodiscard]] HandleEditOptions posed_options() const;

  EditModel& model_;
  bool softens_handles_ = false;
  WorkingSetNewton newton_;
  DisplacementField field_;
};

/// Makes a design by `find`, again from the base for as long as it goes through panels that it had
/// no plane to; the base where that does not end. [KEE-4]
[[nodiscard]] ExactDesign find_parted(EditModel& model, const FindDesign& find,
                                      SolveReport& report);

}  // namespace planish
