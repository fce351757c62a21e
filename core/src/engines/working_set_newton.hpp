// SPDX-License-Identifier: MIT
/// Engine 2: Newton's method on a working set that follows the support of the edit.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engines/displacement_field.hpp"
#include "engines/engine_outcome.hpp"
#include "engines/patch_system.hpp"
#include "engines/primal_dual_step.hpp"
#include "engines/working_set.hpp"
#include "planish/problem/corner_force.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Tuning of WorkingSetNewton. Lengths marked "share" are multiplied by the largest handle
/// displacement; all others are in mean edges.
struct NewtonOptions {
  /// First ε of √(‖d‖² + ε²), share, > last. Too small: poor local minima. [WSN-3]
  double first_smoothing = 0.05;
  /// Last ε, share, > 0. Too large: rounded supports; too small: ill-conditioned.
  double last_smoothing = 1e-4;
  /// Factor in (0, 1) between two smoothings. Near 1: slower; near 0: worse minima.
  double smoothing_shrink = 0.3;
  /// The working set is the support grown by this many face rings, ≥ 1. [WSN-4]
  int rings = 2;
  /// Rings and lines of the starting set are kept until ε falls below this share.
  double keep_start = 0.003;
  StepOptions step;
  /// Stop when the objective changes by less than this share of itself, > 0.
  double stop = 1e-6;
  /// Stop as well when no vertex moves further than this in a step, share, ≥ 0.
  double settled_move = 1e-4;
  /// settle() ends a stage when no vertex's ∇L is longer than this, solver units, > 0.
  double stationary = 5e-7;
  int max_steps = 150;
  /// Of settle(): at the first ε alone, and in all.
  int max_first_settle_steps = 350;
  int max_settle_steps = 350;
};

/// Where a cold start looks first.
struct StartSet {
  int rings = 3;        ///< face rings around the handles
  int line_length = 0;  ///< edges along each edge polyline through a handle, both ways
  double first_smoothing = 0.05;
};

/// Largest displacement asked for: the length that smoothing is measured against.
[[nodiscard]] double handle_scale(const EditProblem& problem);

/// One engine per mesh; the state lives in the field that the caller passes. Costs follow the
/// working set: O(n) memory once, nothing O(n) per run unless the problem has no norm term.
class WorkingSetNewton {
 public:
  explicit WorkingSetNewton(const MeshModel& model);

  /// Runs from `field` = 0 with the vertices of `start` in the first working set.
  EngineOutcome run_cold(const EditProblem& problem, const StartSet& start,
                         const NewtonOptions& options, DisplacementField& field,
                         const Progress& progress);

  /// Goes on with a cold run that was stopped at a coarse smoothing: from its field and support(),
  /// with the same start set, at options.first_smoothing.
  EngineOutcome run_on(const EditProblem& problem, const StartSet& start,
                       const NewtonOptions& options, DisplacementField& field,
                       const Progress& progress);

  /// Runs from the field of an earlier run and its support().
  EngineOutcome run_warm(const EditProblem& problem, const NewtonOptions& options,
                         DisplacementField& field, const Progress& progress);

  /// Runs from `field` = 0 on the whole mesh or, where a support is sought, around `seeds`, which
  /// need not be handles.
  /// @param scale the length that smoothing is a share of, > 0
  EngineOutcome run_around(const EditProblem& problem, std::span<const int> seeds, double scale,
                           const NewtonOptions& options, DisplacementField& field,
                           const Progress& progress);

  /// Goes from the field of a run and its support() to a first-order point of the problem: the
  /// working set grows by what moves at its rim, ε falls until it is nothing, and what is at rest
  /// then leaves the support. kConverged: so it ended; otherwise the budget did. [OPT-2]
  EngineOutcome settle(const EditProblem& problem, const NewtonOptions& options,
                       DisplacementField& field, const Progress& progress);

  /// Goes on after settle(): what was taken to rest stays there, and steps at the ε that it ended
  /// at bring the rest to a minimum of its own whose rows hold to rounding, so that a finish
  /// changes nothing. Where rows are nearly dependent, the shortest way from 1e-11 to there leads
  /// far from the minimum.
  EngineOutcome refine(const EditProblem& problem, const NewtonOptions& options,
                       DisplacementField& field);

  /// Lets move after all what moved by so little that settle() took it to rest. Where rows
  /// are stiff, stopping it costs the certificate.
  void keep_slow_movers(DisplacementField& field);

  /// The conditions at a design near the state that the last settle() left, with its multipliers.
  /// @param vertices ascending; @param displacement 3 × |vertices|, all other vertices at rest
  [[nodiscard]] Optimality optimality(const EditProblem& problem, std::span<const int> vertices,
                                      const Eigen::Matrix3Xd& displacement);

  /// How the flatness of the panels pulls at their corners, panel by panel, at the state that the
  /// last run or settle() left. Panels without a pull are left out.
  [[nodiscard]] std::vector<CornerForce> corner_forces() const;

  /// What pulls at the vertices with tracks, at the state that the last run or settle() left.
  [[nodiscard]] std::vector<TrackForce> track_forces();

  /// Where the last settle() looked: at its end everything else was neither moved nor pulled at.
  /// Ascending.
  [[nodiscard]] std::vector<int> certified_set() const;

  /// Vertices that the last run found to move, ascending; handles included.
  [[nodiscard]] const std::vector<int>& support() const { return support_; }
  void set_support(std::vector<int> support) { support_ = std::move(support); }

 private:
  /// Sets start_ to the vertices of `start`.
  void set_start(const EditProblem& problem, const StartSet& start);
  EngineOutcome run(const EditProblem& problem, double scale, const NewtonOptions& options,
                    DisplacementField& field, const Progress& progress);
  void choose_working_set(const EditProblem& problem, const NewtonOptions& options,
                          double relative_smoothing, DisplacementField& field);
  /// Whether the problem's region is.
  [[nodiscard]] static bool is_working_set_at_once(const EditProblem& problem);
  void find_support(double smoothing);
  void choose_first_working_set(const EditProblem& problem);
  void open_patch(const EditProblem& problem, DisplacementField& field);
  [[nodiscard]] std::vector<int> movers_at_rim(double rest) const;
  void extend(const std::vector<int>& movers, bool first_stage, int extensions);
  [[nodiscard]] double rounding() const;
  [[nodiscard]] double limit_violation();
  [[nodiscard]] bool settle_at(double smoothing, const NewtonOptions& options,
                               EngineOutcome& outcome);
  void shrink_what_rests(double smoothing, double shrink);
  void keep_support(double rest);
  void hold_what_rests();
  /// The settled state, at this smoothing, is what is kept.
  void keep_settled(double smoothing, DisplacementField& field);
  void judge_rests(const EditProblem& problem, double rest, Optimality& result);

  const MeshModel& model_;
  PatchCutter cutter_;
  WorkingSetGrower grower_;
  Patch patch_;
  PatchSystem system_;
  PatchState state_;
  std::vector<int> support_, start_, working_;
  bool seeks_support_ = true;

  PatchState settled_;  ///< what the last settle() ended with, nothing stopped
  double settled_smoothing_ = 0.0;
  double last_off_ = 0.0;  ///< |c| before the last step of settle()

  PrimalDualStep step_;
  Eigen::Matrix3Xd gradient_, before_;
  Eigen::VectorXd residuals_, shares_;
};

}  // namespace planish
