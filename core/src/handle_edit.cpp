// SPDX-License-Identifier: MIT
#include "planish/handle_edit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base_planarity.hpp"
#include "edit_reach.hpp"
#include "edit_terms.hpp"
#include "planish/engines/augmented_lagrangian.hpp"
#include "planish/engines/cold_search.hpp"
#include "planish/engines/exact_finish.hpp"
#include "planish/engines/working_set_newton.hpp"
#include "planish/index.hpp"
#include "planish/metrics.hpp"
#include "planish/panel_health.hpp"
#include "planish/problem.hpp"
#include "planish/stopwatch.hpp"

namespace planish {
namespace {

/// Whether every touched panel is as sound as it was, by the verdict that reports give.
bool keeps_shape(const Mesh& base, const ExactDesign& design) {
  Positions before;
  Positions after;
  std::vector<int> outline;
  return std::all_of(design.faces.begin(), design.faces.end(), [&](int f) {
    const auto face = base.face(f);
    before = base.positions(Eigen::all, std::vector<int>(face.begin(), face.end()));
    after = before;
    outline.resize(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      outline[k] = static_cast<int>(k);
      const auto found = std::lower_bound(design.vertices.begin(), design.vertices.end(), face[k]);
      if (found == design.vertices.end() || *found != face[k]) continue;
      after.col(outline[k]) = design.positions.col(found - design.vertices.begin());
    }
    return panel_damage(before, after, outline) == PanelDamage::kNone;
  });
}

}  // namespace

Positions apply(const Mesh& mesh, const HandleEditResult& result) {
  Positions positions = mesh.positions;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    positions.col(result.moved[k]) = result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return positions;
}

class HandleEditSolver::State {
 public:
  State(const Mesh& mesh, const HandleEditOptions& options);

  void set_options(const HandleEditOptions& options);
  HandleEditResult solve(const EditTargets& targets, const Progress& progress);
  HandleEditResult drag(const EditTargets& targets, double budget_seconds);

 private:
  void rebuild();
  void set_targets(const EditTargets& targets);
  ExactDesign solve_newton(const Progress& progress, SolveReport& report);
  ExactDesign settle(const NewtonOptions& options, const Interruption& interruption,
                     SolveReport& report);
  NewtonOutcome soften(const NewtonOptions& options, const Interruption& interruption);
  ExactDesign solve_in_parts(const Progress& progress, SolveReport& report);
  ExactDesign solve_augmented_lagrangian(const Progress& progress, SolveReport& report);
  HandleEditResult result_of(const ExactDesign& design, SolveReport report);
  [[nodiscard]] bool nothing_to_do() const;
  [[nodiscard]] bool is_exact(const ExactDesign& design) const;
  [[nodiscard]] bool is_acceptable(const ExactDesign& design) const;
  [[nodiscard]] SolveStatus honest(SolveStatus status, const ExactDesign& design) const;
  [[nodiscard]] static ExactDesign unmoved();
  ExactDesign run_engine(const Progress& progress, SolveReport& report);
  ExactDesign come_nearer(const Progress& progress, SolveReport& report);
  [[nodiscard]] double handle_distance(const ExactDesign& design) const;
  [[nodiscard]] bool stops_short(const ExactDesign& design, const SolveReport& report) const;
  void try_in_parts(const Progress& progress, ExactDesign& design, SolveReport& report);

  HandleEditOptions options_;
  std::unique_ptr<MeshModel> model_;
  std::unique_ptr<BasePlanarity> planarity_;
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
  std::vector<int> pins_;                  ///< ascending
  std::vector<int> limited_to_;            ///< handles that what may move depends on, ascending
  double setup_seconds_ = 0.0;
};

HandleEditSolver::State::State(const Mesh& mesh, const HandleEditOptions& options)
    : options_(options) {
  const Stopwatch watch;
  model_ = std::make_unique<MeshModel>(mesh, options.fairness);
  planarity_ = std::make_unique<BasePlanarity>(mesh);
  rebuild();
  setup_seconds_ = watch.seconds();
}

/// What depends on the options: the terms, and the engines' marks for the fairness rows.
void HandleEditSolver::State::rebuild() {
  newton_ = std::make_unique<WorkingSetNewton>(*model_);
  const int equations = static_cast<int>(model_->equations.size());
  field_ = std::make_unique<DisplacementField>(model_->vertex_count(), equations);
  trial_ = std::make_unique<DisplacementField>(model_->vertex_count(), equations);
  finish_ = std::make_unique<ExactFinish>(*model_);
  cutter_ = std::make_unique<PatchCutter>(model_->vertex_count(), model_->mesh.face_count(),
                                          static_cast<int>(model_->fairness.rows()));
  problem_ = {};
  problem_.model = model_.get();
  terms_ = std::make_unique<EditTerms>(*model_);
  terms_->fill(options_, problem_);
  drag_support_.clear();
  last_exact_.reset();
}

void HandleEditSolver::State::set_options(const HandleEditOptions& options) {
  const bool same_operator = options.fairness == options_.fairness;
  options_ = options;
  if (!same_operator) {
    const Mesh mesh = std::move(model_->mesh);
    model_ = std::make_unique<MeshModel>(mesh, options.fairness);
  }
  rebuild();
}

void HandleEditSolver::State::set_targets(const EditTargets& targets) {
  std::vector<int> pins = targets.pins;
  std::sort(pins.begin(), pins.end());
  targets_ = targets;
  terms_->assign(targets, options_, problem_);
  const bool limited = options_.keep_boundary || has_reach(options_);
  std::vector<int> limited_to = limited ? problem_.handles : std::vector<int>();
  if (pins == pins_ && limited_to == limited_to_) return;
  // What was exact before may have moved what is pinned, kept or out of reach now.
  pins_ = std::move(pins);
  limited_to_ = std::move(limited_to);
  drag_support_.clear();
  last_exact_.reset();
}

/// The base mesh as a design.
ExactDesign HandleEditSolver::State::unmoved() {
  ExactDesign design;
  design.displacement.resize(3, 0);
  design.positions.resize(3, 0);
  return design;
}

/// Largest distance of a handle from its target, solver units.
double HandleEditSolver::State::handle_distance(const ExactDesign& design) const {
  double largest = 0.0;
  for (const int v : problem_.handles) {
    Eigen::Vector3d reached = Eigen::Vector3d::Zero();
    const auto found = std::lower_bound(design.vertices.begin(), design.vertices.end(), v);
    if (found != design.vertices.end() && *found == v) {
      reached = design.displacement.col(found - design.vertices.begin());
    }
    largest = std::max(largest, (reached - problem_.terms[at(v)].target).norm());
  }
  return largest;
}

HandleEditResult HandleEditSolver::State::result_of(const ExactDesign& design, SolveReport report) {
  HandleEditResult result;
  const Positions& base = model_->mesh.positions;
  std::vector<Eigen::Index> columns;
  for (std::size_t k = 0; k < design.vertices.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (design.positions.col(column) != base.col(design.vertices[k])) columns.push_back(column);
  }
  result.moved_positions.resize(3, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const int v = design.vertices[static_cast<std::size_t>(columns[k])];
    result.moved.push_back(v);
    result.moved_positions.col(static_cast<Eigen::Index>(k)) = design.positions.col(columns[k]);
    report.max_displacement =
        std::max(report.max_displacement, (design.positions.col(columns[k]) - base.col(v)).norm());
  }
  report.moved_vertices = static_cast<int>(result.moved.size());
  if (report.usable()) report.status = honest(report.status, design);
  report.objective = design_objective(problem_, design, *cutter_);
  report.planarity_before = planarity_->mm_per_m.worst();
  report.planarity_after =
      std::max(design.worst_mm_per_m, planarity_->mm_per_m.worst_outside(design.faces));
  report.handle_error = model_->unit() * handle_distance(design);
  report.factorizations += design.factorizations;
  report.setup_seconds = setup_seconds_;
  result.report = std::move(report);
  return result;
}

ExactDesign HandleEditSolver::State::solve_newton(const Progress& progress, SolveReport& report) {
  NewtonOptions options;
  if (options_.max_iterations > 0) options.max_steps = options_.max_iterations;
  const Interruption interruption = [&](const IterationRecord& record) {
    return progress && progress(record) == Flow::kStop;
  };
  const bool by_softness = options_.softness > 0.0 && has_reach(options_);
  NewtonOutcome outcome = by_softness
                              ? soften(options, interruption)
                              : find_minimum(problem_, options, *newton_, *trial_, interruption);
  report.status = outcome.status;
  report.iterations += outcome.steps;
  report.factorizations += outcome.factorizations;
  report.records = std::move(outcome.records);
  return settle(options, interruption, report);
}

/// From the soft end of the scale, where there is one minimum, down to the softness asked for, each
/// step from the last: so the edits of all softnesses lie on one branch, and none is a fold that a
/// cold start fell into. [SOF-2]
NewtonOutcome HandleEditSolver::State::soften(const NewtonOptions& options,
                                              const Interruption& interruption) {
  NewtonOptions coarse = options;
  coarse.last_smoothing = 0.0045;
  coarse.stop = 1e-3;
  HandleEditOptions now = options_;
  now.softness = kSoftest;
  terms_->assign(targets_, now, problem_);
  trial_->clear();
  NewtonOutcome outcome = newton_->run_cold(problem_, {3, 16, 0.05}, coarse, *trial_, interruption);
  for (bool last = false; !last && outcome.status != SolveStatus::kCancelled;) {
    now.softness = std::max(options_.softness, now.softness - 1.0);
    last = now.softness == options_.softness;
    terms_->assign(targets_, now, problem_);
    NewtonOptions step = last ? options : coarse;
    step.first_smoothing = 0.015;
    NewtonOutcome next = newton_->run_warm(problem_, step, *trial_, interruption);
    next.steps += outcome.steps;
    next.factorizations += outcome.factorizations;
    outcome = std::move(next);
  }
  terms_->assign(targets_, options_, problem_);
  return outcome;
}

/// From the state that a search left to a certified design, or to the design of that state.
ExactDesign HandleEditSolver::State::settle(const NewtonOptions& options,
                                            const Interruption& interruption, SolveReport& report) {
  const DisplacementField::Snapshot found = trial_->snapshot();
  const std::vector<int> support = newton_->support();
  const bool spent = options_.max_iterations > 0 && report.status == SolveStatus::kIterationLimit;
  if (report.status != SolveStatus::kCancelled && !spent) {
    const NewtonOutcome fine = newton_->settle(problem_, options, *trial_, interruption);
    report.iterations += fine.steps;
    report.factorizations += fine.factorizations;
    ExactDesign design = finish_->finish(problem_, newton_->support(), *trial_, options_.tolerance);
    if (is_acceptable(design)) {
      report.optimality = newton_->optimality(problem_, design.vertices, design.displacement);
      report.status = fine.status == SolveStatus::kCancelled ? fine.status
                      : report.optimality->met()             ? SolveStatus::kConverged
                                                             : SolveStatus::kIterationLimit;
      return design;
    }
    report.factorizations += design.factorizations;
    report.status = SolveStatus::kIterationLimit;
    trial_->restore(found);
    newton_->set_support(support);
  }
  return finish_->finish(problem_, support, *trial_, options_.tolerance);
}

/// The handles moved in parts, each part acceptable before the next: slower, and it always ends on
/// an acceptable design, though perhaps short of the targets. A part that fails is tried at half
/// its length, a few times in all.
ExactDesign HandleEditSolver::State::solve_in_parts(const Progress& progress, SolveReport& report) {
  constexpr double kFirstPart = 0.125;
  constexpr double kShortestPart = 0.125 / 16;
  NewtonOptions options;
  options.stop = 1e-5;
  options.max_steps = 60;
  std::vector<Eigen::Vector3d> targets;
  for (const int v : problem_.handles) targets.push_back(problem_.terms[at(v)].target);
  const Interruption interruption = [&](const IterationRecord& record) {
    return progress && progress(record) == Flow::kStop;
  };
  ExactDesign best = unmoved();
  trial_->clear();
  newton_->set_support(problem_.handles);
  report.status = SolveStatus::kInfeasibleHandles;
  double reached = 0.0;
  for (double part = kFirstPart; reached < 1.0 && part >= kShortestPart;) {
    const DisplacementField::Snapshot before = trial_->snapshot();
    const std::vector<int> support = newton_->support();
    const double share = std::min(1.0, reached + part);
    for (std::size_t k = 0; k < targets.size(); ++k) {
      problem_.terms[at(problem_.handles[k])].target = share * targets[k];
    }
    const NewtonOutcome outcome =
        reached == 0.0 ? newton_->run_cold(problem_, {3, 0, 0.05}, options, *trial_, interruption)
                       : newton_->run_warm(problem_, options, *trial_, interruption);
    report.iterations += outcome.steps;
    report.factorizations += outcome.factorizations;
    ExactDesign next = finish_->finish(problem_, newton_->support(), *trial_, options_.tolerance);
    if (is_acceptable(next)) {
      best = std::move(next);
      reached = share;
    } else {
      trial_->restore(before);
      newton_->set_support(support);
      part *= 0.5;
    }
    if (outcome.status == SolveStatus::kCancelled) {
      report.status = SolveStatus::kCancelled;
      break;
    }
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    problem_.terms[at(problem_.handles[k])].target = targets[k];
  }
  if (reached < 1.0 || report.status == SolveStatus::kCancelled) return best;
  report.status = SolveStatus::kIterationLimit;
  ExactDesign settled = settle(options, interruption, report);
  if (is_acceptable(settled)) return settled;
  report.optimality.reset();
  return best;
}

ExactDesign HandleEditSolver::State::solve_augmented_lagrangian(const Progress& progress,
                                                                SolveReport& report) {
  trial_->clear();
  AlmOptions options;
  if (options_.max_iterations > 0) options.max_outer = options_.max_iterations;
  const AlmOutcome outcome = solve_edit_by_alm(problem_, options, *trial_, progress);
  report.status = outcome.status;
  report.iterations = outcome.inner_steps;
  report.factorizations = outcome.factorizations;
  report.records = outcome.records;
  return finish_->finish(problem_, outcome.support, *trial_, options_.tolerance);
}

bool HandleEditSolver::State::nothing_to_do() const {
  return std::all_of(problem_.handles.begin(), problem_.handles.end(),
                     [&](int v) { return problem_.terms[at(v)].target.isZero(0.0); });
}

bool HandleEditSolver::State::is_exact(const ExactDesign& design) const {
  if (!design.positions.allFinite()) return false;
  return design.worst_excess <= std::max(options_.tolerance, planarity_->excess.worst());
}

/// Exact, and no panel lost the shape it had.
bool HandleEditSolver::State::is_acceptable(const ExactDesign& design) const {
  return is_exact(design) && (!options_.keep_shape || keeps_shape(model_->mesh, design));
}

/// A design of a base that was not flat itself is no exact one, however it ended.
SolveStatus HandleEditSolver::State::honest(SolveStatus status, const ExactDesign& design) const {
  const double excess =
      std::max(design.worst_excess, planarity_->excess.worst_outside(design.faces));
  return excess <= options_.tolerance ? status : SolveStatus::kToleranceNotMet;
}

ExactDesign HandleEditSolver::State::run_engine(const Progress& progress, SolveReport& report) {
  return options_.engine == Engine::kNewton ? solve_newton(progress, report)
                                            : solve_augmented_lagrangian(progress, report);
}

/// For targets that no flat design was found for: handles that may stay short of them, approached
/// in parts. The base mesh is the last resort, and always valid.
ExactDesign HandleEditSolver::State::come_nearer(const Progress& progress, SolveReport& report) {
  const std::vector<VertexTerm> terms = problem_.terms;
  const bool softened = std::any_of(problem_.handles.begin(), problem_.handles.end(),
                                    [&](int v) { return problem_.terms[at(v)].fixed; });
  if (softened && options_.keep_shape) {  // a jump starts beyond the barrier, a path does not
    ExactDesign design = solve_in_parts(progress, report);
    if (report.status != SolveStatus::kInfeasibleHandles) return design;
  }
  for (const int v : problem_.handles) problem_.terms[at(v)].fixed = false;
  ExactDesign design = solve_in_parts(progress, report);
  problem_.terms = terms;
  if (softened && report.status != SolveStatus::kCancelled) {
    report.status = SolveStatus::kInfeasibleHandles;
  }
  return design;
}

/// A jump may end against the barrier, far from the target and from any minimum.
bool HandleEditSolver::State::stops_short(const ExactDesign& design,
                                          const SolveReport& report) const {
  constexpr double kFar = 0.05;  // of the move
  const bool certified = report.optimality && report.optimality->met();
  if (!options_.keep_shape || certified || report.status == SolveStatus::kCancelled) return false;
  return handle_distance(design) > kFar * handle_scale(problem_);
}

/// The way in parts, where it ends lower.
void HandleEditSolver::State::try_in_parts(const Progress& progress, ExactDesign& design,
                                           SolveReport& report) {
  SolveReport other;
  ExactDesign nearer = solve_in_parts(progress, other);
  const double reached = design_objective(problem_, design, *cutter_).total();
  const bool lower = design_objective(problem_, nearer, *cutter_).total() < reached;
  other.iterations += report.iterations;
  other.factorizations += report.factorizations;
  other.records = std::move(report.records);
  if (!lower) {
    other.status = report.status;
    other.optimality = report.optimality;
  } else {
    design = std::move(nearer);
  }
  report = std::move(other);
}

HandleEditResult HandleEditSolver::State::solve(const EditTargets& targets,
                                                const Progress& progress) {
  const Stopwatch watch;
  set_targets(targets);
  SolveReport report;
  if (nothing_to_do()) {
    report.status = SolveStatus::kConverged;
    report.solve_seconds = watch.seconds();
    return result_of(unmoved(), std::move(report));
  }
  ExactDesign design = run_engine(progress, report);
  if (!is_acceptable(design)) {
    report.optimality.reset();
    if (report.status == SolveStatus::kCancelled) {
      design = unmoved();
    } else {
      design = come_nearer(progress, report);
    }
  } else if (stops_short(design, report)) {
    try_in_parts(progress, design, report);
  } else if (report.status == SolveStatus::kSingularSystem) {
    report.status = SolveStatus::kIterationLimit;  // exact, only perhaps not at a minimum
  }
  HandleEditResult result = result_of(design, std::move(report));
  result.report.solve_seconds = watch.seconds();
  return result;
}

HandleEditResult HandleEditSolver::State::drag(const EditTargets& targets, double budget_seconds) {
  const Stopwatch watch;
  set_targets(targets);
  if (nothing_to_do()) {  // back where the drag began: the path that led here is forgotten
    drag_support_.clear();
    last_exact_ = unmoved();
    SolveReport report;
    report.status = SolveStatus::kConverged;
    return result_of(*last_exact_, std::move(report));
  }
  NewtonOptions options;
  options.stop = 3e-5;
  // A frame that changes to another minimum may take dozens of steps; the next frames go on with
  // it.
  options.max_steps = 7;
  const Interruption out_of_time = [&](const IterationRecord&) {
    return watch.seconds() > budget_seconds;
  };
  SolveReport report;
  NewtonOutcome outcome;
  if (!last_exact_ || drag_support_.empty()) {
    field_->clear();
    outcome = newton_->run_cold(problem_, {3, 16, 0.05}, options, *field_, out_of_time);
  } else {
    options.first_smoothing = 1e-3;
    newton_->set_support(drag_support_);
    outcome = newton_->run_warm(problem_, options, *field_, out_of_time);
  }
  drag_support_ = newton_->support();
  report.status =
      outcome.status == SolveStatus::kCancelled ? SolveStatus::kIterationLimit : outcome.status;
  report.iterations = outcome.steps;
  report.factorizations = outcome.factorizations;
  ExactDesign design = finish_->finish(problem_, drag_support_, *field_, options_.tolerance);
  if (is_acceptable(design)) {
    last_exact_ = std::move(design);
  } else {  // the last exact state stands; the next frame starts afresh
    drag_support_.clear();
    report.status = SolveStatus::kIterationLimit;
  }
  HandleEditResult result = result_of(last_exact_ ? *last_exact_ : unmoved(), std::move(report));
  if (last_exact_) last_exact_->factorizations = 0;  // a frame that repeats it has not made them
  result.report.solve_seconds = watch.seconds();
  return result;
}

HandleEditSolver::HandleEditSolver(const Mesh& mesh, const HandleEditOptions& options)
    : state_(std::make_unique<State>(mesh, options)) {}
HandleEditSolver::~HandleEditSolver() = default;
HandleEditSolver::HandleEditSolver(HandleEditSolver&&) noexcept = default;
HandleEditSolver& HandleEditSolver::operator=(HandleEditSolver&&) noexcept = default;

void HandleEditSolver::set_options(const HandleEditOptions& options) {
  state_->set_options(options);
}

HandleEditResult HandleEditSolver::solve(const EditTargets& targets, const Progress& progress) {
  return state_->solve(targets, progress);
}

HandleEditResult HandleEditSolver::drag(const EditTargets& targets, double budget_seconds) {
  return state_->drag(targets, budget_seconds);
}

HandleEditResult HandleEditSolver::release(const EditTargets& targets, const Progress& progress) {
  return state_->solve(targets, progress);
}

HandleEditResult solve_handle_edit(const Mesh& mesh, const EditTargets& targets,
                                   const HandleEditOptions& options) {
  return HandleEditSolver(mesh, options).solve(targets);
}

}  // namespace planish
