// SPDX-License-Identifier: MIT
/// Panels parted where handles stop: they come nearer with every line, and it is an edit like
/// others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/cuts/cut_mesh.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/edit/symmetric_edit.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/obstacles/keep_out.hpp"
#include "planish/splitting/split_where_needed.hpp"
#include "support/scenes.hpp"
#include "support/symmetric_meshes.hpp"

namespace planish {
namespace {

constexpr double kFold = 12.0;

/// Beside a boundary that stays, pulled by most of an edge: short by half of that without a cut.
class SplitEdits : public ::testing::Test {
 protected:
  static HandleEditOptions sharp_options() {
    HandleEditOptions options;
    options.attraction = 1e5;
    options.softness = 3.0;
    options.reach = 2;
    options.keep_boundary = true;
    options.bounds.push_back(*parse_stated_limit("fold=+12"));
    return options;
  }

  static SplitOptions at_most(int cuts) {
    SplitOptions options;
    options.most_cuts = cuts;
    return options;
  }

  void expect_edit_of_cut_mesh(const SplitEdit& found) const;

  const Mesh mesh_ = testing::sample("vault", 12);
  const EditTargets targets_ = testing::pull(mesh_, 26, {0.0, 0.0, 0.9});
  const HandleEditOptions edit_ = sharp_options();
};

/// What it was told while it was looked for ends with the curve.
void expect_curve(const SplitEdit& found, const std::vector<SplitStanding>& told) {
  EXPECT_GT(told.size(), found.curve.size());
  for (std::size_t k = 1; k < told.size(); ++k) {
    ASSERT_GE(told[k].lines, told[k - 1].lines);
    if (told[k].lines == told[k - 1].lines) {
      EXPECT_LT(told[k].handle_error, told[k - 1].handle_error);
    }
  }
  for (const SplitStanding& standing : found.curve) {
    const auto last = std::find_if(told.rbegin(), told.rend(), [&](const SplitStanding& one) {
      return one.lines == standing.lines;
    });
    ASSERT_NE(last, told.rend());
    EXPECT_EQ(last->cuts, standing.cuts);
    EXPECT_EQ(last->handle_error, standing.handle_error);
  }
}

/// Up to two lines, every night three.
TEST_F(SplitEdits, ComeNearerWithEveryLineAndNeverEndWorseWithMore) {
  double error = solve_handle_edit(mesh_, targets_, edit_).report.handle_error;
  const double uncut = error;
  for (int cuts = 1; cuts <= testing::by_night(3, 2); ++cuts) {
    std::vector<SplitStanding> told;
    SplitOptions options = at_most(cuts);
    options.found = [&](const SplitStanding& standing) { told.push_back(standing); };
    const SplitEdit found = split_where_needed(mesh_, targets_, edit_, options);
    expect_curve(found, told);
    expect_edit_of_cut_mesh(found);
    EXPECT_LE(found.result.report.handle_error, error) << cuts;
    error = found.result.report.handle_error;
    ASSERT_GE(found.curve.size(), std::min<std::size_t>(static_cast<std::size_t>(cuts), 2) + 1);
    EXPECT_TRUE(found.curve.front().cuts.empty());
    EXPECT_EQ(found.curve.front().handle_error, uncut);
    for (std::size_t k = 1; k < found.curve.size(); ++k) {
      EXPECT_LT(found.curve[k].handle_error, found.curve[k - 1].handle_error);
      EXPECT_GT(found.curve[k].cuts.size(), found.curve[k - 1].cuts.size());
    }
    EXPECT_EQ(found.curve.back().cuts, found.cuts);
    EXPECT_LE(found.cuts.size(), static_cast<std::size_t>(cuts));
    EXPECT_EQ(found.curve.back().handle_error, error);
    EXPECT_EQ(found.curve.back().moved_vertices, found.result.report.moved_vertices);
  }
  EXPECT_LT(error, (testing::is_night() ? 0.5 : 0.51) * uncut) << "of three lines, or two";
}

void SplitEdits::expect_edit_of_cut_mesh(const SplitEdit& found) const {
  ASSERT_FALSE(found.cuts.empty());
  const auto cut = std::get<CutMesh>(cut_mesh(mesh_, found.cuts));
  EXPECT_TRUE(cut.added.empty());
  EXPECT_EQ(cut.mesh.face_offsets, found.mesh.face_offsets);
  EXPECT_EQ(cut.mesh.face_vertices, found.mesh.face_vertices);
  EXPECT_EQ(cut.mesh.positions, mesh_.positions);
  const HandleEditResult again = solve_handle_edit(cut.mesh, targets_, edit_);
  EXPECT_EQ(again.moved, found.result.moved);
  EXPECT_EQ(again.moved_positions, found.result.moved_positions);
  Mesh after = found.mesh;
  after.positions = apply(found.mesh, found.result);
  EXPECT_LE(planarity_summary(after).max_excess, edit_.tolerance);
  std::vector<int> faces(static_cast<std::size_t>(after.face_count()));
  std::iota(faces.begin(), faces.end(), 0);
  EXPECT_LE(largest_fold_growth(after, build_adjacency(after), found.mesh.positions,
                                after.positions, faces),
            kFold + 1e-6);
}

/// Of both handles on a vault, and every night of all four on a surface of revolution.
TEST_F(SplitEdits, UnderASymmetryCutImagesAndStaySymmetric) {
  const auto expect_symmetric = [&](Mesh mesh, const EditTargets& targets, const char* text) {
    SCOPED_TRACE(text);
    const MeshSymmetry symmetry = testing::symmetry_of(mesh, text);
    ASSERT_TRUE(make_symmetric(mesh, symmetry, edit_.tolerance).symmetric);
    const auto all = std::get<EditTargets>(with_images(targets, mesh, symmetry));
    const SplitEdit found = split_where_needed(mesh, all, edit_, at_most(1), &symmetry);
    ASSERT_EQ(found.curve.size(), 2U);
    EXPECT_EQ(found.curve.back().lines, 1);
    EXPECT_EQ(found.cuts.size(), symmetry.operations.size());
    EXPECT_LT(found.result.report.handle_error, found.curve.front().handle_error);
    std::optional<MeshSymmetry> after = symmetry;
    const auto cut = cut_base(mesh, found.cuts, after, edit_.tolerance);
    ASSERT_TRUE(std::holds_alternative<CutMesh>(cut)) << std::get<std::string>(cut);
    const Mesh& base = std::get<CutMesh>(cut).mesh;
    EXPECT_EQ(base.positions, mesh.positions);
    EXPECT_LE(asymmetry(*after, base, apply(base, found.result)), 1e-9);
    const HandleEditResult again = HandleEditSolver(base, edit_).solve_symmetric(all, *after);
    EXPECT_EQ(again.moved, found.result.moved);
    EXPECT_EQ(again.moved_positions, found.result.moved_positions);
  };
  expect_symmetric(mesh_, targets_, "x");
  if (!testing::is_night()) return;
  const Mesh turned = testing::turned_surface(12, 8);
  Eigen::Vector3d outwards = turned.positions.col(13);
  outwards.z() = 0.0;
  outwards *= 0.9 * mean_edge_length(turned) / outwards.norm();
  expect_symmetric(turned, testing::pull(turned, 13, outwards), "axis:4");
}

/// The handle alone may go there: what it takes along stays below.
TEST_F(SplitEdits, KeepWhatKeepOutsHold) {
  const double top = std::ceil(10.0 * mesh_.positions(2, 26)) / 10.0 + 0.3;
  HandleEditOptions options = edit_;
  options.keep_outs.push_back(*parse_keep_out("above=" + std::to_string(top)));
  const SplitEdit found = split_where_needed(mesh_, targets_, options, at_most(2));
  ASSERT_GT(found.curve.size(), 1U);
  const Positions after = apply(found.mesh, found.result);
  const double edge = mean_edge_length(mesh_);
  for (const int v : found.result.moved) {
    EXPECT_LE(after(2, v), std::max(top, mesh_.positions(2, v)) + 1e-9 * edge) << v;
  }
  EXPECT_FALSE(found.reached);
  EXPECT_LT(found.result.report.handle_error, found.curve.front().handle_error);
}

TEST_F(SplitEdits, CutNothingWhereHandlesArrive) {
  const EditTargets near = testing::pull(mesh_, 66, {0.0, 0.0, 0.1});
  const SplitEdit found = split_where_needed(mesh_, near, edit_, at_most(4));
  EXPECT_TRUE(found.reached);
  EXPECT_TRUE(found.cuts.empty());
  EXPECT_EQ(found.solves, 1);
  EXPECT_EQ(found.curve.size(), 1U);
}

TEST_F(SplitEdits, StopAfterAsManySolvesAsTheyMayOrWhereTheyAreAskedTo) {
  SplitOptions options = at_most(3);
  options.most_solves = 5;
  EXPECT_LE(split_where_needed(mesh_, targets_, edit_, options).solves, 5);
  int steps = 0;
  const Progress stop = [&](const IterationRecord&) {
    return ++steps > 200 ? Flow::kStop : Flow::kContinue;
  };
  const SplitEdit stopped = split_where_needed(mesh_, targets_, edit_, at_most(3), nullptr, stop);
  EXPECT_TRUE(stopped.result.report.usable());
  EXPECT_LE(stopped.result.report.handle_error, stopped.curve.front().handle_error);
}

TEST_F(SplitEdits, NameWhatIsWrong) {
  EXPECT_FALSE(find_problem(SplitOptions{}, edit_, targets_));
  EXPECT_TRUE(find_problem(at_most(0), edit_, targets_));
  SplitOptions options;
  options.within_handle = 1.0;
  EXPECT_TRUE(find_problem(options, edit_, targets_));
  options = {};
  options.most_solves = 0;
  EXPECT_TRUE(find_problem(options, edit_, targets_));
  EXPECT_TRUE(find_problem(SplitOptions{}, edit_, EditTargets{}));
  HandleEditOptions reference = edit_;
  reference.engine = Engine::kAugmentedLagrangian;
  EXPECT_TRUE(find_problem(SplitOptions{}, reference, targets_));
}

}  // namespace
}  // namespace planish
