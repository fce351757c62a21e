// SPDX-License-Identifier: MIT
/// Handles and pins of every kind. In every case a valid, exact design comes back.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// All panels flat, and what is not listed as moved has its old bits.
void expect_exact(const Mesh& mesh, const HandleEditResult& result) {
  const Positions edited = apply(mesh, result);
  ASSERT_TRUE(edited.allFinite());
  EXPECT_LE(planarity_summary(mesh, edited).max, testing::kPromise);
  EXPECT_LE(result.report.planarity_after, testing::kPromise);
  EXPECT_EQ(moved_vertex_count(mesh.positions, edited), static_cast<int>(result.moved.size()));
  EXPECT_NE(result.report.status, SolveStatus::kToleranceNotMet);
}

class EditOn : public ::testing::TestWithParam<const char*> {
 protected:
  EditOn()
      : mesh(testing::sample(GetParam(), testing::by_night(16, 14))),
        middle(testing::middle_vertex(mesh)) {}
  Mesh mesh;
  int middle;
};

TEST_P(EditOn, HardHandlesMeetTheirTargetsExactly) {
  const EditTargets targets = testing::pull(mesh, middle, {0.05, -0.1, 0.3});
  const HandleEditResult result = solve_handle_edit(mesh, targets, {.hard_handles = true});
  expect_exact(mesh, result);
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  EXPECT_LT((apply(mesh, result).col(middle) - targets.handles[0].target).norm(), 1e-12);
  EXPECT_LT(result.report.handle_error, 1e-12);
}

TEST_P(EditOn, SoftHandlesComeNear) {
  const HandleEditResult result = solve_handle_edit(mesh, testing::pull(mesh, middle, {0, 0, 0.5}));
  expect_exact(mesh, result);
  EXPECT_LT(result.report.handle_error, 0.1);
  EXPECT_GT(result.report.handle_error, 0.0);
}

TEST_P(EditOn, PinsKeepTheirBits) {
  EditTargets targets = testing::pull(mesh, middle, {0, 0, 0.4});
  const HandleEditResult free = solve_handle_edit(mesh, targets);
  std::vector<int> others;
  for (const int v : free.moved) {
    if (v != middle) others.push_back(v);
  }
  ASSERT_GT(others.size(), 2u);
  targets.pins = {others[0], others[others.size() / 2]};
  const HandleEditResult result = solve_handle_edit(mesh, targets);
  expect_exact(mesh, result);
  for (const int pin : targets.pins) {
    EXPECT_FALSE(std::binary_search(result.moved.begin(), result.moved.end(), pin));
  }
  EXPECT_GE(result.report.objective.total(), free.report.objective.total() * (1 - 1e-3));
}

TEST_P(EditOn, SeveralHandlesActTogether) {
  EditTargets targets = testing::pull(mesh, middle, {0, 0, 0.3});
  for (const int v : {2 * mesh.vertex_count() / 7, 5 * mesh.vertex_count() / 7}) {
    targets.handles.push_back({v, mesh.positions.col(v) + Eigen::Vector3d(0.1, 0, -0.2)});
  }
  const HandleEditResult result = solve_handle_edit(mesh, targets);
  expect_exact(mesh, result);
  EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
  for (const Handle& handle : targets.handles) {
    EXPECT_TRUE(std::binary_search(result.moved.begin(), result.moved.end(), handle.vertex));
  }
  std::reverse(targets.handles.begin(), targets.handles.end());
  const Positions other = apply(mesh, solve_handle_edit(mesh, targets));
  EXPECT_LT((other - apply(mesh, result)).colwise().norm().maxCoeff(), 1e-9) << "order matters";
}

/// Two neighbours that are told to change places, softly and hard.
TEST_P(EditOn, ContradictoryHandlesKeepPanelsFlat) {
  const auto face = mesh.face(mesh.face_count() / 2);
  EditTargets targets;
  targets.handles.push_back({face[0], mesh.positions.col(face[2])});
  targets.handles.push_back({face[2], mesh.positions.col(face[0])});
  targets.handles.push_back({face[1], mesh.positions.col(face[1]) + Eigen::Vector3d(0, 0, 2)});
  for (const bool hard : {false, true}) {
    SCOPED_TRACE(hard ? "hard" : "soft");
    expect_exact(mesh, solve_handle_edit(mesh, targets, {.hard_handles = hard}));
  }
}

/// How far a handle gets does not depend on how far beyond that its target is.
TEST(FarTargets, GetAtLeastHalfAsFarAsTheBestNearerOne) {
  for (const char* const name : {"roof", "vault", "freeform"}) {
    const Mesh mesh = testing::sample(name, 11);
    const int middle = testing::middle_vertex(mesh);
    const double edge = mean_edge_length(mesh);
    const auto way = [&](double edges, bool hard) {
      const EditTargets targets = testing::pull(mesh, middle, {0, 0, edges * edge});
      const HandleEditOptions options{
          .hard_handles = hard, .reach = 4, .keep_boundary = true, .softness = 4.0};
      const HandleEditResult result = solve_handle_edit(mesh, targets, options);
      expect_exact(mesh, result);
      return edges - result.report.handle_error / edge;
    };
    const double near = std::max(way(3.0, false), way(6.0, false));
    EXPECT_GT(near, 2.0) << name;
    for (const double edges : {40.0, 1000.0}) {
      EXPECT_GT(way(edges, false), 0.5 * near) << name << " " << edges;
    }
    EXPECT_GT(way(1000.0, true), 0.5 * near) << name << " hard";
  }
}

/// Nearer targets are no answer where the way in parts gets to those that were asked for.
TEST(FarTargets, AreMetWherePartsArrive) {
  struct Case {
    const char* sample;
    int size, vertex;
    double lift;
    HandleEditOptions options;
  };
  const std::vector<Case> cases{{"hex", 6, 30, 8.0, {}},
                                {"vault", 9, 40, 3.0, {.reach = 2}},
                                {"freeform", 9, 40, 40.0, {}},
                                {"dome", 9, 40, 3.0, {.hard_handles = true}}};
  for (const Case& one : cases) {
    const Mesh mesh = testing::sample(one.sample, one.size);
    const EditTargets targets = testing::pull(mesh, one.vertex, {0, 0, one.lift});
    const HandleEditResult result = solve_handle_edit(mesh, targets, one.options);
    expect_exact(mesh, result);
    EXPECT_LT(result.report.handle_error, 0.05 * one.lift) << one.sample;
  }
}

/// Whoever stops a search is not asked again, and is told that it was stopped.
TEST(FarTargets, CanBeCancelledAtEveryStep) {
  const Mesh mesh = testing::sample("freeform", 9);
  const EditTargets targets = testing::pull(mesh, 40, {0, 0, 400.0});
  const HandleEditOptions options{.reach = 3, .softness = 4.0};
  int steps = 0;
  const auto count = [&](const IterationRecord&) {
    ++steps;
    return Flow::kContinue;
  };
  HandleEditSolver solver(mesh, options);
  EXPECT_EQ(solver.solve(targets, count).report.status, SolveStatus::kInfeasibleHandles);
  ASSERT_GT(steps, 100);
  for (int stop = 1; stop <= steps; stop += testing::by_night(7, 61)) {
    int calls = 0;
    const HandleEditResult result = solver.solve(targets, [&](const IterationRecord&) {
      return ++calls < stop ? Flow::kContinue : Flow::kStop;
    });
    EXPECT_EQ(calls, stop);
    EXPECT_EQ(result.report.status, SolveStatus::kCancelled) << stop << " of " << steps;
    expect_exact(mesh, result);
  }
}

/// Hard targets that no flat design meets: three corners stay, the fourth is lifted.
/// A jump to them ends where no step is possible, a path in parts does not.
TEST(HardHandles, AreCertifiedWhereAJumpMakesNoStep) {
  const Mesh mesh = testing::sample("dome", 16);
  const EditTargets targets = testing::pull(mesh, 104, {0.3, 0.15, 1.5});
  const HandleEditResult result = solve_handle_edit(
      mesh, targets, {.hard_handles = true, .reach = 6, .keep_boundary = true, .softness = 5.0});
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  EXPECT_LT(result.report.objective.total(), 2.0);  // the jump's 11.3
}

TEST_P(EditOn, ImpossibleHardHandlesAreReported) {
  const Adjacency adjacency = build_adjacency(mesh);
  const auto around = adjacency.faces[middle];
  const auto panel =
      std::find_if(around.begin(), around.end(), [&](int f) { return mesh.face(f).size() > 3; });
  ASSERT_NE(panel, around.end());
  const auto face = mesh.face(*panel);
  EditTargets targets = testing::pull(mesh, face[0], {0, 0, 0.3});
  targets.pins.assign(face.begin() + 1, face.end());
  const HandleEditResult result = solve_handle_edit(mesh, targets, {.hard_handles = true});
  expect_exact(mesh, result);
  EXPECT_EQ(result.report.status, SolveStatus::kInfeasibleHandles)
      << status_name(result.report.status);
  EXPECT_GT(result.report.handle_error, 0.01);
}

TEST_P(EditOn, EverythingElsePinnedLeavesTheMeshAlone) {
  EditTargets targets = testing::pull(mesh, middle, {0.1, 0.2, 0.5});
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (v != middle) targets.pins.push_back(v);
  }
  const HandleEditResult result = solve_handle_edit(mesh, targets);
  expect_exact(mesh, result);
  EXPECT_GT(result.report.handle_error, 0.1);
}

/// The base is exact and sound, but it is no answer to a hard handle.
TEST_P(EditOn, AHardHandleThatNothingCanFollowIsReported) {
  EditTargets targets = testing::pull(mesh, middle, {0.0, 0.0, 3.0});
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (v != middle) targets.pins.push_back(v);
  }
  for (const Engine engine : {Engine::kNewton, Engine::kAugmentedLagrangian}) {
    const HandleEditResult result =
        solve_handle_edit(mesh, targets, {.hard_handles = true, .engine = engine});
    expect_exact(mesh, result);
    EXPECT_EQ(result.report.status, SolveStatus::kInfeasibleHandles);
    EXPECT_GT(result.report.handle_error, 1.0);
  }
}

TEST_P(EditOn, HandlesOnTheBoundaryAndInTheCorners) {
  const Adjacency adjacency = build_adjacency(mesh);
  int tried = 0;
  for (int v = 0; v < mesh.vertex_count() && tried < 12; v += 5) {
    if (!adjacency.boundary[static_cast<std::size_t>(v)]) continue;
    ++tried;
    SCOPED_TRACE(v);
    const HandleEditResult result =
        solve_handle_edit(mesh, testing::pull(mesh, v, {0.1, 0.05, 0.4}));
    expect_exact(mesh, result);
    EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
    EXPECT_LT(result.report.handle_error, 0.2);
  }
  EXPECT_GT(tried, 4);
}

TEST_P(EditOn, LargeMovesStayExact) {
  const double edge = mean_edge_length(mesh);
  for (const double length : {3.0, 10.0}) {
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.5, 0.5, -1)}) {
      const bool slants = direction.z() < 0.0;
      if (slants != (length == 10.0) && !testing::is_night()) continue;
      const Eigen::Vector3d move = length * edge * direction.normalized();
      SCOPED_TRACE(::testing::Message() << move.transpose());
      const HandleEditResult result = solve_handle_edit(mesh, testing::pull(mesh, middle, move));
      expect_exact(mesh, result);
      EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
      EXPECT_LT(result.report.handle_error, 0.95 * move.norm()) << "it follows at least in part";
    }
  }
}

TEST_P(EditOn, AHandleAtItsPlaceMovesNothing) {
  const HandleEditResult result = solve_handle_edit(mesh, testing::pull(mesh, middle, {0, 0, 0}));
  EXPECT_TRUE(result.moved.empty());
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  EXPECT_EQ(result.report.objective.total(), 0.0);
}

TEST_P(EditOn, NoHandlesMoveNothing) {
  const HandleEditResult result = solve_handle_edit(mesh, {});
  EXPECT_TRUE(result.moved.empty());
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
}

TEST_P(EditOn, CancellingGivesAnExactDesign) {
  for (const int allowed : {1, 3, 10}) {
    int calls = 0;
    HandleEditSolver solver(mesh, {});
    const HandleEditResult result = solver.solve(
        testing::pull(mesh, middle, {0, 0, 0.5}),
        [&](const IterationRecord&) { return ++calls >= allowed ? Flow::kStop : Flow::kContinue; });
    expect_exact(mesh, result);
    EXPECT_EQ(result.report.status, SolveStatus::kCancelled);
    EXPECT_EQ(calls, allowed);
  }
}

/// The working set may only leave minima out, never find worse ones than the reference engine.
TEST_P(EditOn, NewtonIsNeverWorseThanTheReferenceEngine) {
  const EditTargets targets = testing::pull(mesh, middle, {0, 0, 0.5});
  const double newton = solve_handle_edit(mesh, targets).report.objective.total();
  const double reference =
      solve_handle_edit(mesh, targets, {.engine = Engine::kAugmentedLagrangian})
          .report.objective.total();
  EXPECT_LE(newton, 1.001 * reference);
}

/// [HE-1] … [HE-3]: the reported terms are those of (3) with the options' weights.
TEST_P(EditOn, ReportedTermsAreTheWeightedTermsOfTheProblem) {
  const HandleEditOptions options{.attraction = 300.0, .locality = 0.7, .smoothness = 2.0};
  const HandleEditResult result =
      solve_handle_edit(mesh, testing::pull(mesh, middle, {0, 0, 0.5}), options);
  const double unit = mean_edge_length(mesh);
  const Positions d = (apply(mesh, result) - mesh.positions) / unit;
  const Eigen::Vector3d wanted(0, 0, 0.5 / unit);
  double sparsity = 0.0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (v != middle) sparsity += 0.5 * 0.7 * d.col(v).norm();
  }
  const FairnessOperator e =
      fairness_operator(mesh, build_adjacency(mesh), FairnessKind::kSecondDifference);
  const ObjectiveTerms& terms = result.report.objective;
  EXPECT_NEAR(terms.handle, 150.0 * (d.col(middle) - wanted).squaredNorm(), 1e-9);
  EXPECT_NEAR(terms.sparsity, sparsity, 1e-9);
  EXPECT_NEAR(terms.fairness, (e * d.transpose()).squaredNorm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Meshes, EditOn,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"));

TEST(EditTargets, NameWhatIsWrong) {
  const Mesh mesh = testing::quad_grid(4, 4);
  const Eigen::Vector3d here = Eigen::Vector3d::Zero();
  const auto problem = [&](const std::vector<Handle>& handles, const std::vector<int>& pins) {
    EditTargets targets;
    targets.handles = handles;
    targets.pins = pins;
    return find_problem(targets, mesh).value_or("");
  };
  EXPECT_EQ(problem({Handle{5, here}}, {4}), "");
  EXPECT_NE(problem({Handle{16, here}}, {}).find("handle 16"), std::string::npos);
  EXPECT_NE(problem({Handle{-1, here}}, {}).find("handle -1"), std::string::npos);
  EXPECT_NE(problem({Handle{3, here}, Handle{3, here}}, {}).find("twice"), std::string::npos);
  EXPECT_NE(problem({Handle{3, here}}, {3}).find("vertex 3"), std::string::npos);
  EXPECT_NE(problem({}, {99}).find("pin 99"), std::string::npos);
  const Eigen::Vector3d nowhere(0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_NE(problem({Handle{3, nowhere}}, {}).find("handle 3"), std::string::npos);
}

TEST(HandleEditOptions, NameWhatIsWrong) {
  const auto problem = [](const HandleEditOptions& options) {
    return find_problem(options).value_or("");
  };
  EXPECT_EQ(problem({}), "");
  EXPECT_NE(problem({.attraction = 0.0}).find("attraction"), std::string::npos);
  EXPECT_NE(problem({.locality = -1.0}).find("locality"), std::string::npos);
  EXPECT_NE(problem({.smoothness = std::numeric_limits<double>::infinity()}).find("smoothness"),
            std::string::npos);
  EXPECT_NE(problem({.tolerance = 0.0}).find("tolerance"), std::string::npos);
  EXPECT_NE(problem({.max_iterations = -1}).find("max_iterations"), std::string::npos);
}

/// A vertex that no face uses can be a handle: nothing else follows.
TEST(EditTargets, MayNameAnIsolatedVertex) {
  Mesh mesh = testing::quad_grid(4, 4);
  mesh.positions.conservativeResize(3, 17);
  mesh.positions.col(16) = Eigen::Vector3d(9, 9, 9);
  const HandleEditResult result = solve_handle_edit(mesh, testing::pull(mesh, 16, {0, 0, 1}));
  EXPECT_EQ(result.moved, std::vector<int>{16});
  EXPECT_LT(result.report.handle_error, 1e-3);
}

/// A sheet of four panels with a crease, and a lone panel: everything is corner and boundary.
TEST(EditTargets, WorkOnTinyMeshes) {
  const Mesh panel =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const HandleEditResult lifted = solve_handle_edit(panel, testing::pull(panel, 2, {0, 0, 0.5}));
  expect_exact(panel, lifted);
  EXPECT_LT(lifted.report.handle_error, 0.1);
  const Mesh creased =
      testing::quad_grid(3, 3, [](double x, double) { return x < 1.5 ? 0.0 : 3.0 * (x - 1.0); });
  for (int v = 0; v < 9; ++v) {
    SCOPED_TRACE(v);
    expect_exact(creased, solve_handle_edit(creased, testing::pull(creased, v, {0.1, 0, 0.4})));
  }
}

}  // namespace
}  // namespace planish
