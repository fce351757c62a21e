// SPDX-License-Identifier: MIT
/// Random sequences of everything a user can do, with the invariants after each action. Longer
/// runs: PLANISH_ACTIONS (a sequence, 12 by default) and PLANISH_SEED.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include "planish/edit/handle_edit.hpp"
#include "planish/projection/projection.hpp"
#include "planish/variations/subspace.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::is_valid_edit;
using testing::is_valid_projection;
using testing::is_valid_subspace;
using testing::same_bits;

/// A design under random hands.
class Designer {
 public:
  Designer(const Mesh& mesh, unsigned seed)
      : random_(seed), start_(mesh), base_(mesh), current_(mesh.positions), solver_(mesh, {}) {}

  void act() {
    // Ends the line of copies: the rounding of many adopted designs would add up.
    if (worst_after_adoptions() > kAdoptable) restart();
    const unsigned action = pick(12);
    if (action < 4) return edit();
    if (action < 6) return drag_and_release();
    if (action < 7) return change_options();
    if (action < 9) return explore();
    if (action < 10) return project_noise();
    if (action < 11) return hurried_drag();
    adopt();
  }

 private:
  static constexpr double kAdoptable = 1e-7;  ///< mm/m, well below the promise

  unsigned pick(unsigned count) { return static_cast<unsigned>(random_()) % count; }
  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }
  int any_vertex() { return static_cast<int>(pick(static_cast<unsigned>(base_.vertex_count()))); }

  Eigen::Vector3d any_move(double size) {
    const Eigen::Vector3d direction(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5);
    return size * mean_edge_length(base_) * direction;
  }

  EditTargets any_targets(double size) {
    EditTargets targets;
    std::vector<int> taken;
    const auto free_vertex = [&] {
      int v = any_vertex();
      while (std::find(taken.begin(), taken.end(), v) != taken.end()) v = any_vertex();
      taken.push_back(v);
      return v;
    };
    const unsigned handles = 1 + pick(3), pins = pick(4);
    for (unsigned k = 0; k < handles; ++k) {
      const int v = free_vertex();
      targets.handles.push_back({v, base_.positions.col(v) + any_move(size)});
    }
    for (unsigned k = 0; k < pins; ++k) targets.pins.push_back(free_vertex());
    return targets;
  }

  double worst_after_adoptions() const {
    return testing::worst_svd_mm_per_m(base_, base_.positions);
  }

  void restart() {
    base_ = start_;
    current_ = base_.positions;
    close_.clear();
    pins_.clear();
    solver_ = HandleEditSolver(base_, options_);
  }

  void take(const EditTargets& targets, const HandleEditResult& result, const char* what) {
    EXPECT_TRUE(is_valid_edit(base_, targets, result)) << what;
    EXPECT_TRUE(result.report.usable()) << what << ": " << status_name(result.report.status);
    current_ = apply(base_, result);
    close_.clear();
    pins_.clear();
    for (const Handle& handle : targets.handles) close_.push_back(handle.vertex);
    pins_ = targets.pins;
  }

  void edit() {
    const EditTargets targets = any_targets(2.0);
    const HandleEditResult result = solver_.solve(targets);
    take(targets, result, "edit");
    if (pick(3) != 0) return;
    const HandleEditResult again = solve_handle_edit(base_, targets, options_);
    EXPECT_EQ(result.moved, again.moved) << "a solver's past shows";
    EXPECT_TRUE(same_bits(result.moved_positions, again.moved_positions))
        << "a solver's past shows";
  }

  void drag_and_release() {
    constexpr int kFrames = 3;
    constexpr double kUnhurried = 1e3;  // s: the result then does not depend on the machine
    const EditTargets end = any_targets(1.5);
    for (int frame = 1; frame <= kFrames; ++frame) {
      EditTargets targets = end;
      for (Handle& handle : targets.handles) {
        const Eigen::Vector3d from = base_.positions.col(handle.vertex);
        handle.target = from + (handle.target - from) * frame / kFrames;
      }
      take(targets, solver_.drag(targets, kUnhurried), "drag");
    }
    const HandleEditResult released = solver_.solve(end);
    take(end, released, "release");
    const HandleEditResult fresh = solve_handle_edit(base_, end, options_);
    EXPECT_TRUE(same_bits(released.moved_positions, fresh.moved_positions))
        << "a release depends on the drag";
  }

  /// A frame that is out of time at once: whatever comes back must be exact.
  void hurried_drag() {
    const EditTargets targets = any_targets(1.0);
    const HandleEditResult result = solver_.drag(targets, 0.0);
    // The frame may be the last exact one, of other targets and pins: only its shape is promised.
    EXPECT_TRUE(is_valid_edit(base_, {}, with_handle_error(result, 0.0))) << "hurried drag";
    current_ = apply(base_, result);
    pins_.clear();
  }

  static HandleEditResult with_handle_error(HandleEditResult result, double error) {
    result.report.handle_error = error;
    return result;
  }

  void change_options() {
    options_.locality = 0.25 + 2.0 * uniform();
    options_.smoothness = pick(4) == 0 ? 0.0 : 2.0 * uniform();
    options_.fairness = pick(2) == 0 ? FairnessKind::kSecondDifference : FairnessKind::kLaplacian;
    options_.sparsity = pick(6) == 0 ? Sparsity::kL2 : Sparsity::kL21;
    options_.hard_handles = pick(4) == 0;
    options_.engine = pick(6) == 0 ? Engine::kAugmentedLagrangian : Engine::kNewton;
    solver_.set_options(options_);
  }

  void explore() {
    if (same_bits(current_, base_.positions)) edit();
    SubspaceOptions options;
    options.dimension = 1 + static_cast<int>(pick(4));
    options.reach = static_cast<int>(pick(3));
    const Subspace subspace = compute_subspace(base_, current_, close_, options, {.held = pins_});
    ASSERT_TRUE(is_valid_subspace(current_, subspace));
    if (subspace.dimension() == 0) return;
    Eigen::VectorXd coefficients(subspace.dimension());
    for (double& x : coefficients) x = 2.0 * uniform() - 1.0;
    Positions rows, again;
    evaluate(subspace, coefficients, rows);
    evaluate(subspace, coefficients, again);
    EXPECT_TRUE(same_bits(rows, again));
    Mesh varied = base_;
    varied.positions = current_;
    for (std::size_t k = 0; k < subspace.support.size(); ++k) {
      varied.positions.col(subspace.support[k]) = rows.col(static_cast<Eigen::Index>(k));
    }
    for (const int pin : pins_) {
      EXPECT_TRUE(same_bits(Positions(varied.positions.col(pin)), Positions(current_.col(pin))))
          << "a variation moves pin " << pin;
    }
    const ProjectionResult exact = project_to_planar(varied, base_.positions, {}, pins_);
    EXPECT_TRUE(is_valid_projection(varied, pins_, exact)) << "explore";
    if (exact.report.usable()) current_ = testing::apply(varied, exact);
  }

  /// Shakes a few vertices of the design and makes it flat again, some pinned.
  void project_noise() {
    Mesh shaken = base_;
    shaken.positions = current_;
    for (int k = 0; k < 3; ++k) shaken.positions.col(any_vertex()) += any_move(0.1);
    std::vector<int> pins;
    if (pick(2) == 0) pins.push_back(any_vertex());
    const ProjectionResult result = project_to_planar(shaken, {}, pins);
    EXPECT_TRUE(is_valid_projection(shaken, pins, result)) << "project";
    const ProjectionResult again = project_to_planar(shaken, {}, pins);
    EXPECT_TRUE(same_bits(result.moved_positions, again.moved_positions)) << "project";
  }

  /// The design becomes the base of the next edits, as when a saved file is opened again.
  void adopt() {
    base_.positions = current_;
    close_.clear();
    pins_.clear();
    solver_ = HandleEditSolver(base_, options_);
  }

  std::mt19937 random_;
  Mesh start_, base_;
  Positions current_;
  HandleEditOptions options_;
  HandleEditSolver solver_;
  std::vector<int> close_;
  std::vector<int> pins_;  ///< of the last edit
};

struct Start {
  const char* sample;
  int size;
};

TEST(Sequences, KeepEveryInvariant) {
  constexpr Start kStarts[] = {
      {"vault", 8}, {"dome", 8}, {"freeform", 8}, {"hex", 8}, {"trihex", 8}};
  unsigned turn = 0;
  for (const unsigned seed : testing::seeds()) {
    const Start& start = kStarts[turn++ % std::size(kStarts)];
    Designer designer(testing::sample(start.sample, start.size), seed);
    for (int action = 0; action < testing::action_count(); ++action) {
      designer.act();
      ASSERT_FALSE(HasFailure()) << start.sample << ", seed " << seed << ", action " << action;
    }
  }
}

}  // namespace
}  // namespace planish
