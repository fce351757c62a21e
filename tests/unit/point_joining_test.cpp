// SPDX-License-Identifier: MIT
#include "planish/mesh/point_joining.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/small_files.hpp"

namespace planish {
namespace {

TEST(PointJoining, KeepsTheFirstPointAndTheOrder) {
  Positions points(3, 5);
  points << 0, 1, 0, 1.05, -0.0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  const JoinedPoints exact = find_joined_points(points, 0.0);
  EXPECT_EQ(exact.target, (std::vector<int>{0, 1, 0, 2, 0}));
  EXPECT_EQ(exact.kept, (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(exact.largest, 0.0);
  const JoinedPoints near = find_joined_points(points, 0.1);
  EXPECT_EQ(near.target, (std::vector<int>{0, 1, 0, 1, 0}));
  EXPECT_NEAR(near.largest, 0.05, 1e-15);
  points(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(find_joined_points(points, 0.1).joined(), 0u);
}

TEST(PointJoining, NeverMakesASideShort) {
  const Mesh mesh = testing::four_panels();
  EXPECT_EQ(safe_joining(mesh, 1e-6), 1e-6);
  EXPECT_NEAR(safe_joining(mesh, 1.0), 0.15, 0.01);
  const JoinedPoints joined = find_joined_points(testing::points_apart(mesh).positions, 0.1);
  EXPECT_EQ(joined.kept.size(), 9u);
}

}  // namespace
}  // namespace planish
