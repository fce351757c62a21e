// SPDX-License-Identifier: MIT
/// What the page's first module does without, so that a first visit transfers less: keep-outs,
/// surfaces to stand on, symmetry, exploring. Linked in place of the core's own files, whose
/// functions these are; planish_whole has them. Keep-outs are refused by find_problem(), and the
/// page asks no first module for the others, so that nothing else here is ever reached.
#include "edit/edit_reach.hpp"
#include "edit/handle_edit_state.hpp"
#include "engines/keep_out_terms.hpp"
#include "engines/patch_system.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/obstacles/keep_out.hpp"
#include "planish/problem/problem.hpp"
#include "planish/supports/vertex_slides.hpp"
#include "planish/variations/exact_variation.hpp"
#include "planish/variations/subspace.hpp"
#include "session.hpp"
#include "supports/surface_heights.hpp"

namespace planish {
namespace {

[[noreturn]] void is_not_here() { __builtin_trap(); }

}  // namespace

std::vector<KeepOut> read_keep_outs(std::string_view lines) {
  return std::vector<KeepOut>(lines.empty() ? 0 : 1);  // enough for find_problem()
}
std::optional<KeepOut> parse_keep_out(std::string_view) { return KeepOut{}; }
std::string keep_out_text(const KeepOut&) { return {}; }
std::string_view known_keep_outs() { return {}; }
FreeSpace free_space(const std::vector<KeepOut>&, double) { is_not_here(); }
Refusal find_problem(const std::vector<KeepOut>& keep_outs) {
  if (keep_outs.empty()) return std::nullopt;
  return "keep_out: this module knows none";
}

LimitStanding MeshKeepOuts::standing(std::span<const int>,
                                     const std::function<Eigen::Vector3d(int)>&) const {
  is_not_here();
}
bool MeshKeepOuts::choose_planes(std::span<const int>, const std::function<Eigen::Vector3d(int)>&) {
  is_not_here();
}
bool MeshKeepOuts::part_panels(std::span<const int>, const std::function<Eigen::Vector3d(int)>&) {
  is_not_here();
}
void MeshLimits::keep_out(const LimitBase&, const std::vector<KeepOut>&, double) { is_not_here(); }

void PatchCutter::add_keep_outs(const MeshKeepOuts&, int, Patch&) { is_not_here(); }
double with_keep_outs(double, const Patch&, const Eigen::Matrix3Xd&) { is_not_here(); }
void add_keep_out_gradient(const Patch&, const Eigen::Matrix3Xd&, Eigen::Matrix3Xd&) {
  is_not_here();
}
void PatchSystem::add_keep_outs(const PatchState&) { is_not_here(); }
void WorkingSetNewton::judge_rests(const EditProblem&, double, Optimality&) { is_not_here(); }

Eigen::Vector3d VertexSlides::nearest(int, const Eigen::Vector3d&) const { is_not_here(); }
void VertexSlides::let_all_go() { is_not_here(); }
void VertexSlides::add_feet(const PointSupport&, const std::vector<int>&) { is_not_here(); }
void VertexSlides::order_feet() {}
void VertexSlides::open_feet() {}
void VertexSlides::stand_on_surfaces(const Eigen::Matrix3Xd&) {}
std::span<const SurfaceRow> VertexSlides::surface_rows(int) const { is_not_here(); }
bool VertexSlides::follow_surfaces(int, const Eigen::Vector3d&) { is_not_here(); }
Eigen::Vector3d VertexSlides::on_surface(int, const Eigen::Vector3d&) const { is_not_here(); }
bool VertexSlides::is_at_heights(int, const Eigen::Vector3d&) const { is_not_here(); }
std::vector<double> ways_off_surface(const PointSupport&, const Mesh&, const std::vector<int>&,
                                     const Positions&) {
  is_not_here();
}
std::optional<FarPoint> far_from_surface(const PointSupport&, const Mesh&, double) {
  is_not_here();
}
void VertexSlides::forget_releases() { is_not_here(); }

void HandleEditSolver::State::keep_out() { is_not_here(); }
void HandleEditSolver::State::keep_out(const FreeSpace&) { is_not_here(); }
void HandleEditSolver::State::make_rests() { is_not_here(); }
void HandleEditSolver::State::open_planes() { is_not_here(); }
void HandleEditSolver::State::forget_parted() { is_not_here(); }
bool HandleEditSolver::State::goes_through_itself(const ExactDesign&) { is_not_here(); }
void HandleEditSolver::State::part_panels(const std::function<ExactDesign(SolveReport&)>&,
                                          ExactDesign&, SolveReport&) {
  is_not_here();
}
bool HandleEditSolver::State::keep_outs_turn() const { is_not_here(); }
bool HandleEditSolver::State::turn_planes(const ExactDesign&) { is_not_here(); }
bool HandleEditSolver::State::meets_keep_outs(const ExactDesign&) { is_not_here(); }
bool HandleEditSolver::State::lets_go() { is_not_here(); }
ExactDesign HandleEditSolver::State::settle_beside_keep_outs(const NewtonOptions&, const Progress&,
                                                             SolveReport&) {
  is_not_here();
}
void HandleEditSolver::State::hold_back(const std::vector<int>&, ExactDesign&) { is_not_here(); }
void hold_resting(const Mesh&, const HandleEditOptions&, std::vector<int>&) { is_not_here(); }

Subspace compute_subspace(const Mesh&, const Positions&, const std::vector<int>&,
                          const SubspaceOptions&, const KeptByVariations&, const Progress&) {
  is_not_here();
}
void evaluate(const Subspace&, const Eigen::Ref<const Eigen::VectorXd>&, Positions&) {
  is_not_here();
}
ProjectionResult make_exact(const ShownVariation&, const HandleEditOptions&, double,
                            const KeptByVariations&, const Progress&) {
  is_not_here();
}

Refusal Session::solve_symmetric(EditMode, const EditTargets&, double, HandleEditResult&) {
  is_not_here();
}
KeptByVariations Session::kept_with_images() const { is_not_here(); }
std::variant<Replay, std::string> Session::replay_symmetric(const Design&) const { is_not_here(); }

}  // namespace planish
