// SPDX-License-Identifier: MIT
#include "../../core/src/numeric/plane_meeting.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

namespace planish {
namespace {

using Eigen::Vector3d;

TEST(PlaneMeeting, OfThreePlanesIsTheirPoint) {
  const PlaneMeeting meeting =
      meet_planes({Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()}, Vector3d::Zero());
  EXPECT_LT((meeting.point - Vector3d::Ones()).norm(), 1e-15);
  EXPECT_LT(meeting.miss, 1e-15);
  EXPECT_EQ(meeting.rank, 3);
}

/// [OFF-4]
TEST(PlaneMeeting, OfPlanesThatTouchAConeIsOnItsAxis) {
  std::vector<Vector3d> normals;
  for (const double t : {0.1, 1.3, 2.9, 4.0, 5.5}) {
    normals.push_back(Vector3d(0.6 * std::cos(t), 0.6 * std::sin(t), 0.8));
  }
  const PlaneMeeting meeting = meet_planes(normals, Vector3d(0.3, 0.1, 0.9));
  EXPECT_LT((meeting.point - Vector3d(0.0, 0.0, 1.25)).norm(), 1e-14);
  EXPECT_LT(meeting.miss, 1e-15);
  normals[2] = Vector3d(0.9, 0.0, std::sqrt(0.19));
  EXPECT_GT(meet_planes(normals, Vector3d::Zero()).miss, 0.01);
}

/// Three planes that all but coincide still have one point, to what their normals hold.
TEST(PlaneMeeting, OfShallowFoldsIsExact) {
  for (const double fold : {1e-2, 1e-4, 1e-5}) {
    std::vector<Vector3d> normals;
    for (const double t : {0.3, 2.4, 4.4}) {
      normals.push_back(Vector3d(fold * std::cos(t), fold * std::sin(t), 1.0).normalized());
    }
    const PlaneMeeting meeting = meet_planes(normals, Vector3d(0.1, -0.1, 0.9));
    const double height = std::sqrt(1.0 + fold * fold);
    EXPECT_LT((meeting.point - Vector3d(0.0, 0.0, height)).norm(), 1e-15 / fold) << fold;
    EXPECT_LT(meeting.miss, 1e-15) << fold;
    EXPECT_EQ(meeting.rank, 3) << fold;
  }
  const PlaneMeeting flat = meet_planes(
      {Vector3d::UnitZ(), Vector3d(1e-8, 0.0, 1.0), Vector3d(0.0, 1e-8, 1.0)}, Vector3d::UnitZ());
  EXPECT_EQ(flat.rank, 1);
  EXPECT_LT((flat.point - Vector3d::UnitZ()).norm(), 1e-7);
}

TEST(PlaneMeeting, OfFewerPlanesIsTheNearestToTheGuess) {
  const Vector3d guess(0.2, 0.3, 0.4);
  const PlaneMeeting line = meet_planes({Vector3d::UnitX(), Vector3d::UnitZ()}, guess);
  EXPECT_LT((line.point - Vector3d(1.0, 0.3, 1.0)).norm(), 1e-15);
  EXPECT_EQ(line.rank, 2);
  const PlaneMeeting plane = meet_planes({Vector3d::UnitY(), Vector3d::UnitY()}, guess);
  EXPECT_LT((plane.point - Vector3d(0.2, 1.0, 0.4)).norm(), 1e-15);
  EXPECT_EQ(plane.rank, 1);
  EXPECT_EQ(meet_planes({}, guess).point, guess);
}

}  // namespace
}  // namespace planish
