// SPDX-License-Identifier: MIT
/// What an edit does about keep-outs. None of it is called where there are none.
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "edit/edit_reach.hpp"
#include "edit/handle_edit_state.hpp"
#include "planish/constraints/mesh_keep_outs.hpp"

namespace planish {

void HandleEditSolver::State::keep_out() {
  keep_out(free_space(options_.keep_outs, options_.clearance));
}

/// Other keep-outs than the options', for the images of a symmetry.
void HandleEditSolver::State::keep_out(const FreeSpace& free) {
  limits_->keep_out({model_->mesh, model_->adjacency, model_->points, model_->unit()}, free);
  make_slides();
  make_verdict();
}

/// Tracks of the points that are on keep-outs.
void HandleEditSolver::State::make_rests() {
  std::vector<RestingPoint> resting = limits_->keep_outs()->resting_points();
  if (resting.empty()) return;
  if (slides_ == nullptr) {
    slides_ = std::make_unique<VertexSlides>(model_->mesh, supports_, model_->unit());
  }
  slides_->rest(std::move(resting));
}

/// Before a solve: no planes from what an earlier one came near to. [KEE-4]
void HandleEditSolver::State::forget_parted() { limits_->keep_outs()->forget_parted(); }

/// Whether a panel may have gone through another that it had no plane to. It has one now.
bool HandleEditSolver::State::goes_through_itself(const ExactDesign& design) {
  return limits_->keep_outs()->part_panels(design.faces, verdict_->places(design));
}

/// Makes `design` again by `find` for as long as it comes near to panels that it had no plane to.
void HandleEditSolver::State::part_panels(const std::function<ExactDesign(SolveReport&)>& find,
                                          ExactDesign& design, SolveReport& report) {
  constexpr int kMostRounds = 12;
  int round = 0;
  while (goes_through_itself(design)) {
    if (report.status == SolveStatus::kCancelled || ++round > kMostRounds) {
      if (report.usable()) report.status = SolveStatus::kInfeasibleHandles;
      report.optimality.reset();
      design = unmoved();
      return;
    }
    open_tracks();
    SolveReport again;
    again.cost = report.cost;
    report = std::move(again);
    design = find(report);
  }
}

void HandleEditSolver::State::open_planes() { limits_->keep_outs()->open(); }

/// Whether what was met may turn out to be other than what a state was solved with.
bool HandleEditSolver::State::keep_outs_turn() const {
  return (slides_ != nullptr && slides_->has_rests()) || limits_->keep_outs()->has_turning_planes();
}

/// Other planes between boxes and panels where the design makes them better. [KEE-3]
/// @returns whether any changed
bool HandleEditSolver::State::turn_planes(const ExactDesign& design) {
  return limits_->keep_outs()->choose_planes(design.faces, verdict_->places(design));
}

/// Whether points that rest on a keep-out went deeper, and are held [KEE-2], or panels turned
/// beside a box. [KEE-3]
bool HandleEditSolver::State::meets_keep_outs(const ExactDesign& design) {
  const bool turned = turn_planes(design);
  return (slides_ != nullptr && slides_->hold_deeper(design.vertices, design.displacement)) ||
         turned;
}

/// Whether a keep-out holds points that are pulled away from it: no longer. [KEE-2]
bool HandleEditSolver::State::lets_go() {
  constexpr double kAtRest = 1e-6;  // of the pull
  return slides_ != nullptr && slides_->has_rests() &&
         slides_->let_go(newton_->track_forces(), kAtRest * handle_scale(problem_));
}

/// The design of a state, with the points that it takes into a keep-out held: it need not be a
/// minimum.
void HandleEditSolver::State::hold_back(const std::vector<int>& support, ExactDesign& design) {
  for (int turn = 0; slides_ != nullptr && turn < kMostOutlineTurns &&
                     slides_->hold_deeper(design.vertices, design.displacement);
       ++turn) {
    design = finish_->finish(problem_, support, *trial_, kept_);
  }
}

void hold_resting(const Mesh& mesh, const HandleEditOptions& options, std::vector<int>& held) {
  const Adjacency adjacency = build_adjacency(mesh);
  const MeshKeepOuts keep_outs({mesh, adjacency, mesh.positions, 1.0},
                               free_space(options.keep_outs, options.clearance));
  for (const RestingPoint& point : keep_outs.resting_points()) held.push_back(point.vertex);
}

}  // namespace planish
