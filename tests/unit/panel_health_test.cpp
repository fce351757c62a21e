// SPDX-License-Identifier: MIT
#include "planish/measures/panel_health.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>
#include <vector>

#include "planish/shapes/shapes.hpp"

namespace planish {
namespace {

/// One panel with these corners, turned in space and far from the origin.
PanelHealth health_of(const std::vector<Eigen::Vector2d>& corners) {
  const Eigen::Quaterniond turn(0.3, -0.5, 0.7, 0.4);
  Positions positions(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    positions.col(static_cast<Eigen::Index>(k)) =
        turn.normalized() * Eigen::Vector3d(corners[k].x(), corners[k].y(), 0.0) +
        Eigen::Vector3d(100.0, -20.0, 3.0);
  }
  std::vector<int> face(corners.size());
  std::iota(face.begin(), face.end(), 0);
  return panel_health(positions, face);
}

TEST(PanelHealth, KnowsConvexConcaveAndCrossing) {
  EXPECT_EQ(health_of({{0, 0}, {2, 0}, {2, 1}, {0, 1}}).outline, PanelOutline::kConvex);
  EXPECT_EQ(health_of({{0, 0}, {0, 1}, {2, 1}, {2, 0}}).outline, PanelOutline::kConvex);
  EXPECT_EQ(health_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}).outline, PanelOutline::kConvex);
  EXPECT_EQ(health_of({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}).outline, PanelOutline::kConcave);
  EXPECT_EQ(health_of({{0, 0}, {2, 1}, {2, 0}, {0, 1}}).outline, PanelOutline::kSelfCrossing);
  EXPECT_EQ(health_of({{0, 0}, {2, 1}, {2, 0}, {0, 3}}).outline, PanelOutline::kSelfCrossing);
  // A pentagram turns the same way at every corner, twice around.
  EXPECT_EQ(health_of({{1, 0}, {-0.81, 0.59}, {0.31, -0.95}, {0.31, 0.95}, {-0.81, -0.59}}).outline,
            PanelOutline::kSelfCrossing);
}

TEST(PanelHealth, MeasuresEdgeAndAngle) {
  const PanelHealth wedge = health_of({{0, 0}, {1, 0}, {1, 1}});
  EXPECT_NEAR(wedge.shortest_edge, 1.0, 1e-12);
  EXPECT_NEAR(wedge.smallest_angle, 45.0, 1e-9);
  EXPECT_NEAR(health_of({{0, 0}, {3, 0}, {3, 0.25}, {0, 0.25}}).shortest_edge, 0.25, 1e-12);
  EXPECT_NEAR(health_of({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}).smallest_angle, 18.43494882, 1e-6);
}

using Corners = std::vector<Eigen::Vector2d>;

PanelDamage damage_of(const Corners& before, const Corners& after) {
  const auto in_space = [](const Corners& corners) {
    Positions positions = Positions::Zero(3, static_cast<Eigen::Index>(corners.size()));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      positions.col(static_cast<Eigen::Index>(k)).head<2>() = corners[k];
    }
    return positions;
  };
  std::vector<int> face(before.size());
  std::iota(face.begin(), face.end(), 0);
  return panel_damage(in_space(before), in_space(after), face);
}

TEST(PanelDamage, TellsWhatBecameOfAPanel) {
  const Corners square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Corners bow_tie{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const Corners dented{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
  EXPECT_EQ(damage_of(square, square), PanelDamage::kNone);
  EXPECT_EQ(damage_of(square, {{0, 0}, {3, 0}, {3, 1}, {0, 2}}), PanelDamage::kNone);
  EXPECT_EQ(damage_of(square, bow_tie), PanelDamage::kSelfCrossing);
  EXPECT_EQ(damage_of(square, {{2, 0}, {0, 0}, {0, 2}, {2, 2}}), PanelDamage::kTurnedOver);
  EXPECT_EQ(damage_of(square, dented), PanelDamage::kConcave);
  EXPECT_EQ(damage_of(square, {{0, 0}, {2, 0}, {2, 0.001}, {0, 0.001}}), PanelDamage::kCollapsed);
  EXPECT_EQ(damage_of(square, {{0, 0}, {2, 0}, {2, 0.001}, {0, 2}}), PanelDamage::kCollapsed);
}

TEST(PanelDamage, IsOnlyWhatWasNotThereBefore) {
  const Corners bow_tie{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const Corners dented{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
  const Corners sliver{{0, 0}, {2, 0}, {2, 0.001}, {0, 0.001}};
  for (const Corners& corners : {bow_tie, dented, sliver}) {
    EXPECT_EQ(damage_of(corners, corners), PanelDamage::kNone);
  }
  EXPECT_EQ(damage_of(bow_tie, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}), PanelDamage::kNone) << "healed";
  EXPECT_EQ(damage_of(dented, bow_tie), PanelDamage::kSelfCrossing) << "worse than before";
}

TEST(PanelHealth, EveryQuadOfAVaultIsConvex) {
  const Mesh quads = *make_sample("vault", 9);
  for (int f = 0; f < quads.face_count(); ++f) {
    EXPECT_EQ(panel_health(quads.positions, quads.face(f)).outline, PanelOutline::kConvex);
  }
}

}  // namespace
}  // namespace planish
