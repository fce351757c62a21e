// SPDX-License-Identifier: MIT
#include "planish/fabrication/joints.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <set>

#include "../../core/src/numeric/trigonometry.hpp"
#include "planish/fabrication/panel_frame.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// A unit cube, corners anticlockwise from outside.
Mesh cube() {
  return testing::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// Two squares that share an edge; the second rises by `slope` over its width.
Mesh fold(double slope, bool turned = false) {
  const std::vector<int> second =
      turned ? std::vector<int>{4, 5, 2, 1} : std::vector<int>{1, 2, 5, 4};
  return testing::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, slope}, {0, 1, 0}, {1, 1, 0}, {2, 1, slope}},
      {{0, 1, 4, 3}, second});
}

const Joint& inner(const JointTable& table) {
  for (const Joint& joint : table.joints) {
    if (joint.second.panel >= 0) return joint;
  }
  ADD_FAILURE() << "no inner joint";
  return table.joints[0];
}

TEST(Joints, OfACubeAreTwelveRightAngles) {
  const JointTable table = joint_table(cube());
  ASSERT_EQ(table.joints.size(), 12U);
  for (const Joint& joint : table.joints) {
    EXPECT_NEAR(joint.dihedral, kPi / 2, 1e-15);
    EXPECT_EQ(joint.length, 1.0);
    EXPECT_LT(joint.first.panel, joint.second.panel);
    EXPECT_FALSE(joint.same_way);
  }
}

TEST(Joints, AreLessThanFlatOnARidgeAndMoreInAValley) {
  EXPECT_NEAR(inner(joint_table(fold(0.0))).dihedral, kPi, 1e-15);
  EXPECT_NEAR(inner(joint_table(fold(-1.0))).dihedral, 0.75 * kPi, 1e-15);
  EXPECT_NEAR(inner(joint_table(fold(1.0))).dihedral, 1.25 * kPi, 1e-15);
}

TEST(Joints, DoNotDependOnHowTheNeighbourIsOriented) {
  const JointTable table = joint_table(fold(1.0, true));
  EXPECT_TRUE(inner(table).same_way);
  EXPECT_NEAR(inner(table).dihedral, 1.25 * kPi, 1e-15);
}

TEST(Joints, AreNumberedByFirstUseAndFoundFromBothPanels) {
  const Mesh mesh = testing::sample("trihex", 8);
  const JointTable table = joint_table(mesh);
  ASSERT_EQ(table.of_side.size(), mesh.face_vertices.size());
  int seen = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (int side = 0; side < static_cast<int>(face.size()); ++side) {
      const int number = table.of_side[static_cast<std::size_t>(
          mesh.face_offsets[static_cast<std::size_t>(f)] + side)];
      ASSERT_LE(number, seen);
      seen = std::max(seen, number + 1);
      const Joint& joint = table.joints[static_cast<std::size_t>(number)];
      const PanelSide& own = joint.first.panel == f ? joint.first : joint.second;
      EXPECT_EQ(own.panel, f);
      EXPECT_EQ(own.side, side);
      const int a = face[static_cast<std::size_t>(side)];
      const int b = face[(static_cast<std::size_t>(side) + 1) % face.size()];
      EXPECT_EQ((std::set<int>{a, b}), (std::set<int>{joint.from, joint.to}));
    }
  }
  EXPECT_EQ(seen, static_cast<int>(table.joints.size()));
}

TEST(PanelFrame, IsRightHandedAndFollowsTheCorners) {
  for (const char* name : {"vault", "dome", "freeform", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, 9);
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      const PanelFrame frame =
          panel_frame(mesh.positions, face, longest_side(mesh.positions, face));
      Eigen::Matrix3d axes;
      axes << frame.x, frame.y, frame.normal;
      EXPECT_NEAR(axes.determinant(), 1.0, 1e-14);
      EXPECT_LE((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      double area = 0.0;  // anticlockwise seen from outside
      for (std::size_t k = 0; k < face.size(); ++k) {
        const Eigen::Vector3d p = frame.to_panel(mesh.positions.col(face[k]));
        const Eigen::Vector3d q = frame.to_panel(mesh.positions.col(face[(k + 1) % face.size()]));
        area += p.x() * q.y() - p.y() * q.x();
        EXPECT_LE((frame.to_model(p) - mesh.positions.col(face[k])).norm(), 1e-13);
      }
      EXPECT_GT(area, 0.0);
    }
  }
}

/// A square's four sides differ by rounding only: the first one counts.
TEST(PanelFrame, OfARegularPanelDoesNotTurnByChance) {
  Mesh mesh = fold(0.0);
  mesh.positions(0, 4) += 1e-13;
  EXPECT_EQ(longest_side(mesh.positions, mesh.face(0)), 0);
  mesh.positions(0, 4) += 0.5;
  EXPECT_EQ(longest_side(mesh.positions, mesh.face(0)), 2);
}

TEST(PanelFrame, OfAPanelWithoutAreaIsStillAFrame) {
  const Mesh mesh =
      testing::make_mesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 0}, {1e99, 0, 0}, {0, 1e99, 0}},
                         {{0, 1, 2}, {0, 3, 0}, {3, 4, 5}});
  for (int f = 0; f < 3; ++f) {
    const PanelFrame frame = panel_frame(mesh.positions, mesh.face(f), 0);
    EXPECT_NEAR(frame.x.cross(frame.y).dot(frame.normal), 1.0, 1e-14) << f;
  }
}

}  // namespace
}  // namespace planish
