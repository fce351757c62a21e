// SPDX-License-Identifier: MIT
/// What planes that hold a point leave it.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "planish/supports/vertex_slides.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// Three planes through a point, none along an axis or across another.
class HeldByPlanes : public ::testing::Test {
 protected:
  HeldByPlanes() {
    normals << 0.2, 0.1, 0.9, 0.8, -0.3, 0.4, -0.1, 0.7, 0.5;
    normals.rowwise().normalize();
    std::vector<RestingPoint> resting;
    for (int k = 0; k < 3; ++k) resting.push_back({kPoint, normals.row(k).transpose()});
    slides.rest(resting);
  }

  /// Goes so far from each of the planes, deeper where that is negative.
  bool go(const Eigen::Vector3d& heights) {
    return slides.hold_deeper(std::vector<int>{kPoint}, normals.inverse() * heights);
  }

  [[nodiscard]] Eigen::Matrix3d along() const { return slides.track(kPoint)->along; }

  static constexpr int kPoint = 4;
  const Mesh mesh = testing::quad_grid(3, 3);
  Eigen::Matrix3d normals;  ///< rows
  VertexSlides slides{mesh, {}, 1.0};
};

TEST_F(HeldByPlanes, SlideOnOnePlaneAlongTwoAndStayInThree) {
  EXPECT_FALSE(go({1.0, 1.0, 1.0}));
  EXPECT_EQ(along(), Eigen::Matrix3d::Identity());
  ASSERT_TRUE(go({-1.0, 1.0, 1.0}));
  const Eigen::Vector3d first = normals.row(0), second = normals.row(1);
  EXPECT_LT((along() - (Eigen::Matrix3d::Identity() - first * first.transpose())).norm(), 1e-12);
  ASSERT_TRUE(go({1.0, -1.0, 1.0}));
  const Eigen::Vector3d line = first.cross(second).normalized();
  EXPECT_LT((along() - line * line.transpose()).norm(), 1e-12);
  ASSERT_TRUE(go({1.0, 1.0, -1.0}));
  EXPECT_EQ(along(), Eigen::Matrix3d::Zero()) << "to the last bit";
}

TEST_F(HeldByPlanes, AreFreeAgainOnceOpened) {
  ASSERT_TRUE(go({-1.0, -1.0, 1.0}));
  slides.open();
  EXPECT_EQ(along(), Eigen::Matrix3d::Identity());
}

}  // namespace
}  // namespace planish
