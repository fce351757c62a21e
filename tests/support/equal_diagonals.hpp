// SPDX-License-Identifier: MIT
/// The kind that docs/extending.md adds: quads whose diagonals are equally long.
#pragma once

#include <cmath>

#include "planish/constraints/kind.hpp"

namespace planish::testing {

/// c(p) = scale · (‖p₂ − p₀‖² − ‖p₃ − p₁‖²) = 0, about the difference of the two lengths.
struct EqualDiagonalsRow {
  static constexpr int kArity = 4;
  static constexpr bool kCurvedDiagonal = true;
  std::array<int, kArity> vertices{};
  double scale = 1.0;
};

inline double residual(const EqualDiagonalsRow& row, const RowPoints<4>& p) {
  return row.scale * ((p.col(2) - p.col(0)).squaredNorm() - (p.col(3) - p.col(1)).squaredNorm());
}

inline RowPoints<4> gradient(const EqualDiagonalsRow& row, const RowPoints<4>& p) {
  const Eigen::Vector3d first = 2.0 * row.scale * (p.col(2) - p.col(0));
  const Eigen::Vector3d second = 2.0 * row.scale * (p.col(3) - p.col(1));
  RowPoints<4> result;
  result << -first, second, first, -second;
  return result;
}

/// (0,0) (1,0) (1,1) (2,0) (2,1) (2,2) (3,0) (3,1) (3,2) (3,3).
inline CurvatureBlocks<4, true> hessian(const EqualDiagonalsRow& row, const RowPoints<4>&) {
  const Eigen::Matrix3d unit = 2.0 * row.scale * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
  return {unit, none, -unit, -unit, none, unit, none, unit, none, -unit};
}

struct EqualDiagonals {
  static constexpr std::string_view kName = "equal-diagonals";
  static constexpr std::string_view kUnit = "mm/m";
  static constexpr double kTolerance = 1e-6;
  static constexpr Element kElement = Element::kFace;
  static constexpr Sense kSense = Sense::kZero;
  using Row = EqualDiagonalsRow;

  static void append_rows(const Positions& p, std::span<const int> face, std::vector<Row>& out) {
    if (face.size() != 4) return;
    const double sum =
        (p.col(face[2]) - p.col(face[0])).norm() + (p.col(face[3]) - p.col(face[1])).norm();
    out.push_back({{face[0], face[1], face[2], face[3]}, sum > 0.0 ? 1.0 / sum : 1.0});
  }
  [[nodiscard]] static double measure(const Positions& p, std::span<const int> face) {
    const double first = (p.col(face[2]) - p.col(face[0])).norm();
    const double second = (p.col(face[3]) - p.col(face[1])).norm();
    return first + second > 0.0 ? 2000.0 * std::abs(first - second) / (first + second) : 0.0;
  }
};

}  // namespace planish::testing
