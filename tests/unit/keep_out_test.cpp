// SPDX-License-Identifier: MIT
/// Keep-outs as text, and their rows: a base that they never block, the unit, planes beside boxes.
#include "planish/obstacles/keep_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

TEST(KeepOut, ReadsBackWhatItWrites) {
  for (const char* text :
       {"below=0", "below=-2.5", "above=3.25", "plane=0,0.5,-1,4", "box=-1,0,0.5,2,1,3.25", "self",
        "mesh=0,0,0;1,0,0.5;1,1,0;0,1,0/0,1,2;0,2,3"}) {
    const auto keep_out = parse_keep_out(text);
    ASSERT_TRUE(keep_out) << text;
    EXPECT_EQ(keep_out_text(*keep_out), text);
    EXPECT_EQ(find_problem(std::vector<KeepOut>{*keep_out}), std::nullopt) << text;
  }
}

TEST(KeepOut, IsRefusedWithItsName) {
  for (const char* text :
       {"", "below", "below=", "below=x", "below=1,2", "plane=1,0,0", "above=,", "plane=1,0,0,0,0",
        "mesh=a.obj", "self=", "self=1", "under=3", "mesh", "mesh=0,0,0;1,0,0;1,1,0",
        "mesh=0,0;1,0;1,1/0,1,2", "mesh=0,0,0;1,0,0;1,1,0/0,1,-2", "mesh=/"}) {
    EXPECT_FALSE(parse_keep_out(text)) << text;
  }
  const auto problem_of = [](const char* text) {
    return find_problem(std::vector<KeepOut>{*parse_keep_out(text)}).value_or("");
  };
  EXPECT_EQ(problem_of("below=inf"), "keep_out: below must be finite");
  EXPECT_EQ(problem_of("box=0,0,0,1,-1,1"),
            "keep_out: box: its first corner must be the lower one");
  EXPECT_EQ(problem_of("plane=0,0,0,1"), "keep_out: plane: its direction has no length");
}

TEST(KeepOut, LeavesTheSideFreeThatItSays) {
  const auto sides = free_space({*parse_keep_out("below=1"), *parse_keep_out("above=3"),
                                 *parse_keep_out("plane=0,2,0,8")},
                                0.25)
                         .sides;
  const auto is_free = [&](std::size_t k, const Eigen::Vector3d& p) {
    return sides[k].normal.dot(p) >= sides[k].bound;
  };
  EXPECT_TRUE(is_free(0, {0, 0, 1.26}));
  EXPECT_FALSE(is_free(0, {0, 0, 1.24}));
  EXPECT_TRUE(is_free(1, {0, 0, 2.74}));
  EXPECT_FALSE(is_free(1, {0, 0, 2.76}));
  EXPECT_TRUE(is_free(2, {0, 3.74, 0}));
  EXPECT_FALSE(is_free(2, {0, 3.76, 0}));
}

/// What is on a plane or beyond it has no room and rests there; the others are at rest unpushed.
TEST(KeepOutRows, KeepTheirBaseOutAndLetWhatIsInsideRest) {
  const Mesh mesh = testing::three_panels();
  const Adjacency adjacency = build_adjacency(mesh);
  const FreeSpace free = free_space({*parse_keep_out("below=0.1")}, 0.0);
  const MeshKeepOuts keep_outs({mesh, adjacency, mesh.positions, 1.0}, free);
  std::vector<int> points;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const KeepOutRow& row : keep_outs.of(f)) {
      points.push_back(row.vertex());
      const Eigen::Vector3d here = mesh.positions.col(row.vertex());
      EXPECT_EQ(row.rests, here.z() <= 0.1) << row.vertex();
      if (row.rests) {
        EXPECT_NEAR(row.share(here), 0.0, 1e-9);
        EXPECT_GE(row.share(here), 0.0);
      } else {
        EXPECT_GE(row.share(here), 0.5 - 1e-12);
      }
      const double room = row.rests ? 0.0 : here.z() - 0.1;
      EXPECT_LT(row.share(here - (room + 1e-8) * Eigen::Vector3d::UnitZ()), 0.0);
    }
  }
  std::sort(points.begin(), points.end());
  EXPECT_EQ(points, (std::vector<int>{0, 1, 2, 3, 4, 5, 6})) << "each point once";
  EXPECT_EQ(keep_outs.resting_points().size(), 6u);
}

/// The unit of the points does not matter: the same shares.
TEST(KeepOutRows, MeanTheSameInAnyUnit) {
  const Mesh mesh = testing::three_panels();
  const Adjacency adjacency = build_adjacency(mesh);
  const Positions metres = mesh.positions / 1000.0;
  const FreeSpace free =
      free_space({*parse_keep_out("below=-0.05"), *parse_keep_out("plane=1,2,0,6"),
                  *parse_keep_out("box=-1,0,0.5,0,1,2")},
                 0.02);
  const MeshKeepOuts in_model({mesh, adjacency, mesh.positions, 1.0}, free);
  const MeshKeepOuts in_solver({mesh, adjacency, metres, 1000.0}, free);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto model = in_model.of(f), solver = in_solver.of(f);
    ASSERT_EQ(model.size(), solver.size());
    for (std::size_t k = 0; k < model.size(); ++k) {
      EXPECT_NEAR(model[k].share(mesh.positions.col(model[k].vertex())),
                  solver[k].share(metres.col(solver[k].vertex())), 1e-9);
    }
  }
}

/// A panel that turns beside a box gets another plane, and open() brings back the first.
TEST(KeepOutRows, TurnWithThePanelBesideABox) {
  const Mesh mesh = testing::three_panels();
  const Adjacency adjacency = build_adjacency(mesh);
  const FreeSpace free = free_space({*parse_keep_out("box=0.4,0.4,0.35,0.7,0.7,1")}, 0.0);
  MeshKeepOuts keep_outs({mesh, adjacency, mesh.positions, 1.0}, free);
  ASSERT_TRUE(keep_outs.has_turning_planes());
  const Eigen::Vector3d before = keep_outs.of(0).front().normal;
  const std::vector<int> first = {0};
  const auto still = [&](int v) -> Eigen::Vector3d { return mesh.positions.col(v); };
  EXPECT_FALSE(keep_outs.choose_planes(first, still)) << "the base has the best";
  const auto turned = [&](int v) -> Eigen::Vector3d {
    Eigen::Vector3d p = mesh.positions.col(v);
    p.z() += 0.4 * (p.x() - 0.5);
    return p;
  };
  EXPECT_TRUE(keep_outs.choose_planes(first, turned));
  const Eigen::Vector3d after = keep_outs.of(0).front().normal;
  EXPECT_GT((after - before).norm(), 1e-3);
  keep_outs.open();
  EXPECT_EQ(keep_outs.of(0).front().normal, before);
}

/// Two squares, one above the other, and one beside them that touches neither.
Mesh stacked_squares() {
  return testing::make_mesh({{0, 0, 0},
                             {1, 0, 0},
                             {1, 1, 0},
                             {0, 1, 0},
                             {0, 0, 1},
                             {1, 0, 1},
                             {1, 1, 1},
                             {0, 1, 1},
                             {3, 0, 0},
                             {4, 0, 0},
                             {4, 1, 0},
                             {3, 1, 0}},
                            {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}});
}

/// Where two panels went through each other a plane of the base stands between them, and only
/// there.
TEST(KeepOutRows, PartPanelsThatWentThroughEachOther) {
  const Mesh mesh = stacked_squares();
  const Adjacency adjacency = build_adjacency(mesh);
  FreeSpace free;
  free.apart = 0.1;
  MeshKeepOuts keep_outs({mesh, adjacency, mesh.positions, 1.0}, free);
  EXPECT_FALSE(keep_outs.has_rows());
  const auto raised_by = [&](double by) {
    return [&mesh, by](int v) -> Eigen::Vector3d {
      return mesh.positions.col(v) + Eigen::Vector3d(0, 0, v < 4 ? by : 0.0);
    };
  };
  const std::vector<int> first = {0};
  EXPECT_FALSE(keep_outs.part_panels(first, raised_by(0.85)));
  EXPECT_FALSE(keep_outs.has_rows()) << "the clearance is kept";
  EXPECT_TRUE(keep_outs.part_panels(first, raised_by(0.95)));
  keep_outs.forget_parted();
  EXPECT_FALSE(keep_outs.has_rows());
  EXPECT_TRUE(keep_outs.part_panels(first, raised_by(3.0)));
  EXPECT_TRUE(keep_outs.of(2).empty());
  ASSERT_EQ(keep_outs.of(0).size(), 4u);
  ASSERT_EQ(keep_outs.of(1).size(), 4u);
  for (const KeepOutRow& row : keep_outs.of(0)) {
    const Eigen::Vector3d here = mesh.positions.col(row.vertex());
    EXPECT_GT(row.share(here + Eigen::Vector3d(0, 0, 0.449)), 0.0);
    EXPECT_LT(row.share(here + Eigen::Vector3d(0, 0, 0.451)), 0.0) << "half of what is beside 0.1";
  }
  EXPECT_FALSE(keep_outs.part_panels(first, raised_by(3.0))) << "they have a plane";
  EXPECT_TRUE(keep_outs.choose_planes(first, raised_by(0.4))) << "only the first has moved";
  for (const KeepOutRow& row : keep_outs.of(0)) {
    const Eigen::Vector3d here = mesh.positions.col(row.vertex());
    EXPECT_GT(row.share(here + Eigen::Vector3d(0, 0, 0.84)), 0.0);
  }
}

TEST(KeepOut, AModelIsPanelsOfItsPoints) {
  const auto problem = [](const char* text) {
    return find_problem(std::vector<KeepOut>{*parse_keep_out(text)}).value_or("");
  };
  const std::string wrong = "keep_out: mesh: a panel has three or more of its 3 points (from 0)";
  EXPECT_EQ(problem("mesh=0,0,0;1,0,0;1,1,0/0,1,3"), wrong);
  EXPECT_EQ(problem("mesh=0,0,0;1,0,0;1,1,0/0,1"), wrong);
  KeepOut large = *parse_keep_out("mesh=0,0,0;1,0,0;1,1,0/0,1,2");
  large.mesh.panels.resize(kMostContextPanels + 1, {0, 1, 2});
  EXPECT_EQ(find_problem(std::vector<KeepOut>{large}).value_or(""),
            "keep_out: mesh: at most 20000 panels, here are 20001");
  large.mesh.panels.clear();
  EXPECT_EQ(find_problem(std::vector<KeepOut>{large}).value_or(""),
            "keep_out: mesh: it has no panels");
}

/// A wall between the floor and the ceiling of the stack: what went through gets a plane at the
/// wall, less the clearance, and what touches it in the base rests.
TEST(KeepOutRows, PartPanelsFromWalls) {
  const Mesh mesh = stacked_squares();
  const Adjacency adjacency = build_adjacency(mesh);
  const double top = mesh.positions.row(2).maxCoeff(), low = mesh.positions.row(2).minCoeff();
  const double level = 0.5 * (top + low);
  FreeSpace free;
  free.wall_clearance = 0.125 * (top - low);
  Positions wall(3, 4);
  wall << -9, 9, 9, -9, -9, -9, 9, 9, level, level, level, level;
  free.walls = {wall};
  MeshKeepOuts keep_outs({mesh, adjacency, mesh.positions, 1.0}, free);
  EXPECT_FALSE(keep_outs.has_rows());
  std::vector<int> faces;
  for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(f);
  const auto at_rest = [&](int v) -> Eigen::Vector3d { return mesh.positions.col(v); };
  EXPECT_FALSE(keep_outs.part_panels(faces, at_rest));
  const auto swapped = [&](int v) -> Eigen::Vector3d {
    Eigen::Vector3d p = mesh.positions.col(v);
    p.z() = top + low - p.z();
    return p;
  };
  EXPECT_TRUE(keep_outs.part_panels(faces, swapped));
  for (const int f : faces) {
    for (const KeepOutRow& row : keep_outs.of(f)) {
      const double side = mesh.positions(2, row.vertex()) > level ? 1.0 : -1.0;
      Eigen::Vector3d bound = mesh.positions.col(row.vertex());
      bound.z() = level + side * free.wall_clearance;
      EXPECT_NEAR(row.share(bound), 0.0, 1e-12);
      EXPECT_GT(row.share(mesh.positions.col(row.vertex())), 0.0);
    }
  }
  keep_outs.forget_parted();
  EXPECT_FALSE(keep_outs.has_rows());

  free.walls[0].row(2).setConstant(top);
  const MeshKeepOuts touching({mesh, adjacency, mesh.positions, 1.0}, free);
  EXPECT_FALSE(touching.resting_points().empty());
}

/// What touches in the base rests, and may go away.
TEST(KeepOutRows, LetPanelsRestThatTouchInTheBase) {
  Mesh mesh = stacked_squares();
  for (const int v : {4, 5, 6, 7}) mesh.positions(2, v) = 0.0;
  const Adjacency adjacency = build_adjacency(mesh);
  FreeSpace free;
  free.apart = 0.0;
  const MeshKeepOuts keep_outs({mesh, adjacency, mesh.positions, 1.0}, free);
  EXPECT_EQ(keep_outs.resting_points().size(), 8u);
  EXPECT_TRUE(keep_outs.of(2).empty());
}

}  // namespace
}  // namespace planish
