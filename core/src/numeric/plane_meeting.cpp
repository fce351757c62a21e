// SPDX-License-Identifier: MIT
#include "numeric/plane_meeting.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace planish {

PlaneMeeting meet_planes(const std::vector<Eigen::Vector3d>& normals,
                         const Eigen::Vector3d& guess) {
  constexpr double kOnePlane = 1e-12;  // the square of the fold
  constexpr int kPasses = 4;  // each takes back what the squares lost, at worst four digits a pass
  PlaneMeeting meeting{guess};
  if (normals.empty()) return meeting;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : normals) squares += normal * normal.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  const Eigen::Vector3d& values = solver.eigenvalues();
  const auto decides = [&](int k) { return values(k) > kOnePlane * values(2); };
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& normal : normals)
      pull += normal * (1.0 - normal.dot(meeting.point));
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d direction = solver.eigenvectors().col(k);
      if (decides(k)) meeting.point += direction * (direction.dot(pull) / values(k));
    }
  }
  double sum = 0.0;
  for (const Eigen::Vector3d& normal : normals) {
    const double off = normal.dot(meeting.point) - 1.0;
    sum += off * off;
  }
  meeting.miss = std::sqrt(sum / static_cast<double>(normals.size()));
  for (int k = 0; k < 3; ++k) meeting.rank += decides(k) ? 1 : 0;
  return meeting;
}

}  // namespace planish
