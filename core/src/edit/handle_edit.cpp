// SPDX-License-Identifier: MIT
#include "planish/edit/handle_edit.hpp"

#include <algorithm>
#include <utility>

#include "edit/edit_reach.hpp"
#include "edit/handle_edit_state.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"

namespace planish {

namespace {

/// Zero where the design does not move `vertex`; solver units.
Eigen::Vector3d displacement_of(const ExactDesign& design, int vertex) {
  const auto found = std::lower_bound(design.vertices.begin(), design.vertices.end(), vertex);
  if (found == design.vertices.end() || *found != vertex) return Eigen::Vector3d::Zero();
  return design.displacement.col(found - design.vertices.begin());
}

}  // namespace

Positions apply(const Mesh& mesh, const HandleEditResult& result) {
  Positions positions = mesh.positions;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    positions.col(result.moved[k]) = result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return positions;
}

HandleEditSolver::State::State(const Mesh& mesh, const HandleEditOptions& options)
    : options_(options) {
  const Stopwatch watch;
  kept_ = kept_kinds(options.tolerance, options.constraints);
  model_ = std::make_unique<MeshModel>(mesh, options.fairness, kept_);
  base_ = std::make_unique<BaseViolations>(*model_);
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
  state_limits();
  forget_drag();
}

/// Costs what the supports hold, and nothing from one frame to the next.
void HandleEditSolver::State::set_supports(const std::vector<PointSupport>& supports) {
  if (supports == supports_) return;
  supports_ = supports;
  make_slides();
  make_verdict();
  forget_drag();
}

/// What the supports and the keep-outs leave the points that are on them.
void HandleEditSolver::State::make_slides() {
  slides_.reset();
  if (!std::all_of(supports_.begin(), supports_.end(), is_spring))
    slides_ = std::make_unique<VertexSlides>(model_->mesh, supports_, model_->unit());
  if (has_keep_outs()) make_rests();
  problem_.slides = slides_.get();
}

/// Before a solve from the base: nothing held or turned by what an earlier one met.
void HandleEditSolver::State::open_tracks() {
  if (slides_ != nullptr) slides_->open();
  if (has_keep_outs()) open_planes();
}

/// The rows of the stated limits and the keep-outs, and a verdict that knows them.
void HandleEditSolver::State::state_limits() {
  limits_.reset();
  if (!options_.bounds.empty() || has_keep_outs()) {
    limits_ = std::make_unique<MeshLimits>(
        LimitBase{model_->mesh, model_->adjacency, model_->points, model_->unit()},
        options_.bounds);
  }
  problem_.limits = limits_.get();
  if (has_keep_outs()) return keep_out();
  make_slides();
  make_verdict();
}

void HandleEditSolver::State::make_verdict() {
  verdict_ = std::make_unique<EditVerdict>(
      *model_, *base_, kept_,
      EditBounds{
          .keep_shape = options_.keep_shape, .limits = limits_.get(), .slides = slides_.get()});
}

/// Whether a jump to the targets may end beyond a barrier, where a path does not.
bool HandleEditSolver::State::is_bounded() const {
  return options_.keep_shape || limits_ != nullptr;
}

void HandleEditSolver::State::set_options(const HandleEditOptions& options) {
  const KeptKinds kept = kept_kinds(options.tolerance, options.constraints);
  const bool same_kinds = kept.same_kinds(kept_);
  const bool same_model = same_kinds && options.fairness == options_.fairness;
  options_ = options;
  kept_ = kept;
  if (!same_model) {
    const Mesh mesh = std::move(model_->mesh);
    model_ = std::make_unique<MeshModel>(mesh, options.fairness, kept_);
  }
  if (!same_kinds) base_ = std::make_unique<BaseViolations>(*model_);
  rebuild();
}

void HandleEditSolver::State::set_targets(const EditTargets& targets) {
  std::vector<int> pins = targets.pins;
  std::sort(pins.begin(), pins.end());
  targets_ = targets;
  set_supports(targets.supports);
  terms_->assign(targets, options_, problem_);
  const bool limited = options_.keep_boundary || has_reach(options_);
  std::vector<int> limited_to = limited ? problem_.handles : std::vector<int>();
  if (pins == pins_ && limited_to == limited_to_) return;
  // What was exact before may have moved what is pinned, kept or out of reach now.
  pins_ = std::move(pins);
  limited_to_ = std::move(limited_to);
  forget_drag();
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
    const Eigen::Vector3d left = displacement_of(design, v) - problem_.terms[at(v)].target;
    largest = std::max(largest, left.norm());
  }
  return largest;
}

/// By the verdict, and hard handles are where they must be: the base itself is exact and sound, and
/// what a solver has left where nothing can follow a handle.
bool HandleEditSolver::State::is_acceptable(const ExactDesign& design) const {
  const bool met = std::all_of(problem_.handles.begin(), problem_.handles.end(), [&](int v) {
    return !problem_.terms[at(v)].fixed ||
           displacement_of(design, v) == problem_.terms[at(v)].target;
  });
  return met && verdict_->is_acceptable(design);
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
  if (report.usable()) report.status = verdict_->honest(report.status, design);
  report.objective = design_objective(problem_, design, *cutter_);
  verdict_->add_to(report, design);
  report.handle_error = model_->unit() * handle_distance(design);
  report.cost += design.cost;
  report.setup_seconds = setup_seconds_;
  result.report = std::move(report);
  return result;
}

bool HandleEditSolver::State::nothing_to_do() const {
  return std::all_of(problem_.handles.begin(), problem_.handles.end(),
                     [&](int v) { return problem_.terms[at(v)].target.isZero(0.0); });
}

/// An acceptable design for the targets that are set, at the worst the base itself.
ExactDesign HandleEditSolver::State::find_design(const Progress& progress, SolveReport& report) {
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
  return design;
}

HandleEditResult HandleEditSolver::State::solve(const EditTargets& targets,
                                                const Progress& progress) {
  const Stopwatch watch;
  set_targets(targets);
  if (has_keep_outs()) forget_parted();
  open_tracks();
  SolveReport report;
  if (nothing_to_do()) {
    report.status = SolveStatus::kConverged;
    report.solve_seconds = watch.seconds();
    return result_of(unmoved(), std::move(report));
  }
  const auto find = [&](SolveReport& found) { return find_design(progress, found); };
  ExactDesign design = find(report);
  if (has_keep_outs()) part_panels(find, design, report);
  HandleEditResult result = result_of(design, std::move(report));
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

void HandleEditSolver::keep_frame() { state_->keep_frame(); }

void HandleEditSolver::go_back() { state_->go_back(); }

HandleEditResult solve_handle_edit(const Mesh& mesh, const EditTargets& targets,
                                   const HandleEditOptions& options) {
  return HandleEditSolver(mesh, options).solve(targets);
}

}  // namespace planish
