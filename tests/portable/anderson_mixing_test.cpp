// SPDX-License-Identifier: MIT
#include "engines/anderson_mixing.hpp"

#include <gtest/gtest.h>

namespace planish {
namespace {

/// g(x) = M x + b on the three coordinates of `points` columns, M of spectral radius 0.95.
class LinearMap {
 public:
  [[nodiscard]] Eigen::Matrix3Xd step(const Eigen::Matrix3Xd& x) const {
    const Eigen::Vector3d rates(0.95, -0.6, 0.3);
    return rates.asDiagonal() * x + Eigen::Matrix3Xd::Constant(3, x.cols(), 1.0) - x;
  }
};

TEST(AndersonMixing, FirstStepIsUnchanged) {
  AndersonMixing mixing;
  const Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 4);
  Eigen::Matrix3Xd step = LinearMap().step(x);
  const Eigen::Matrix3Xd plain = step;
  mixing.accelerate(x, step);
  EXPECT_EQ(step, plain);
}

TEST(AndersonMixing, SolvesALinearFixedPointInAsManyStepsAsItsRank) {
  AndersonMixing mixing;
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 4);
  for (int k = 0; k < 5; ++k) {  // three rates: three secants, and one step to use them
    Eigen::Matrix3Xd step = LinearMap().step(x);
    mixing.accelerate(x, step);
    x += step;
  }
  EXPECT_LT(LinearMap().step(x).norm(), 1e-6);  // five plain steps leave more than 1
}

TEST(AndersonMixing, ForgetsAfterARestart) {
  AndersonMixing mixing;
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 4);
  Eigen::Matrix3Xd step = LinearMap().step(x);
  mixing.accelerate(x, step);
  mixing.restart();
  x += step;
  step = LinearMap().step(x);
  const Eigen::Matrix3Xd plain = step;
  mixing.accelerate(x, step);
  EXPECT_EQ(step, plain);
}

}  // namespace
}  // namespace planish
