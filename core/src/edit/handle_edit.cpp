// SPDX-License-Identifier: MIT
#include "planish/edit/handle_edit.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "edit/edit_drag.hpp"
#include "edit/edit_model.hpp"
#include "edit/edit_search.hpp"
#include "edit/free_space_images.hpp"
#include "edit/switching/parting_planes.hpp"
#include "edit/symmetric_solve.hpp"
#include "planish/numeric/stopwatch.hpp"

namespace planish {

double farthest_handle(const std::vector<Handle>& handles, const Positions& points) {
  double farthest = 0.0;
  for (const Handle& handle : handles) {
    farthest = std::max(farthest, (handle.target - points.col(handle.vertex)).norm());
  }
  return farthest;
}

Positions apply(const Mesh& mesh, const HandleEditResult& result) {
  Positions positions = mesh.positions;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    positions.col(result.moved[k]) = result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return positions;
}

class HandleEditSolver::State {
 public:
  State(const Mesh& mesh, const HandleEditOptions& options) : model_(mesh, options) { rebuild(); }

  void set_options(const HandleEditOptions& options) {
    if (model_.set_options(options)) rebuild();
  }

  HandleEditResult solve(const EditTargets& targets, const Progress& progress) {
    const Stopwatch watch;
    model_.set_targets(targets);
    if (model_.parted_panels() != nullptr) model_.parted_panels()->reset();
    return solve_by([&](SolveReport& report) { return search_->find(progress, report); }, watch);
  }

  HandleEditResult solve_symmetric(const EditTargets& targets, const MeshSymmetry& symmetry,
                                   const Progress& progress) {
    const Stopwatch watch;
    model_.set_targets(targets);
    const HandleEditOptions& options = model_.options();
    const bool has_keep_outs = !options.keep_outs.empty();
    if (has_keep_outs)
      model_.keep_out(with_images(free_space(options.keep_outs, options.clearance), symmetry));
    SymmetricSolve symmetric(model_, *search_, symmetry);
    HandleEditResult result = solve_by(
        [&](SolveReport& report) { return symmetric.find(targets, progress, report); }, watch);
    if (has_keep_outs) model_.keep_out();
    return result;
  }

  HandleEditResult drag(const EditTargets& targets, double budget_seconds) {
    model_.set_targets(targets);
    return drag_->frame(budget_seconds);
  }

  std::vector<CornerForce> corner_forces() const { return search_->newton().corner_forces(); }

  void keep_frame() { drag_->keep_frame(); }
  void go_back() { drag_->go_back(); }

 private:
  void rebuild() {
    search_.emplace(model_);
    drag_.emplace(model_, *search_);
  }

  HandleEditResult solve_by(const FindDesign& find, const Stopwatch& watch) {
    SolveReport report;
    ExactDesign design = EditModel::unmoved();
    if (model_.nothing_to_do()) {
      model_.active_set().reset();
      report.status = SolveStatus::kConverged;
    } else {
      design = find_parted(model_, find, report);
    }
    HandleEditResult result = model_.result_of(design, std::move(report));
    result.report.solve_seconds = watch.seconds();
    return result;
  }

  EditModel model_;
  std::optional<EditSearch> search_;
  std::optional<EditDrag> drag_;
};

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

HandleEditResult HandleEditSolver::solve_symmetric(const EditTargets& targets,
                                                   const MeshSymmetry& symmetry,
                                                   const Progress& progress) {
  return state_->solve_symmetric(targets, symmetry, progress);
}

std::vector<CornerForce> HandleEditSolver::corner_forces() const { return state_->corner_forces(); }

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
