// SPDX-License-Identifier: MIT
#include "engines/anderson_mixing.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

double dot(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

void AndersonMixing::restart() {
  last_x_.resize(3, 0);
  filled_ = 0;
  next_ = 0;
}

void AndersonMixing::accelerate(const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& step) {
  constexpr double kRegularization = 1e-8;  // secants may be nearly parallel
  const bool first = last_x_.cols() != x.cols();
  if (!first) {
    const int newest = next_;
    x_differences_[at(newest)] = x - last_x_;
    step_differences_[at(newest)] = step - last_step_;
    filled_ = std::max(filled_, newest + 1);
    next_ = (next_ + 1) % kWindow;
    for (int j = 0; j < filled_; ++j) {
      gram_(newest, j) = gram_(j, newest) =
          dot(step_differences_[at(newest)], step_differences_[at(j)]);
    }
  }
  last_x_ = x;
  last_step_ = step;
  if (first) return;
  Eigen::VectorXd right(filled_);
  for (int j = 0; j < filled_; ++j) right[j] = dot(step_differences_[at(j)], step);
  Eigen::MatrixXd system = gram_.topLeftCorner(filled_, filled_);
  system.diagonal() *= 1.0 + kRegularization;
  const Eigen::VectorXd share = system.ldlt().solve(right);
  if (!share.allFinite()) return;
  for (int j = 0; j < filled_; ++j) {
    step -= share[j] * (x_differences_[at(j)] + step_differences_[at(j)]);
  }
}

}  // namespace planish
