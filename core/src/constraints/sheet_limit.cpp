// SPDX-License-Identifier: MIT
#include "planish/constraints/sheet_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planish/constraints/vector_pair.hpp"

namespace planish {
namespace {

constexpr std::size_t kMostCorners = 64;  ///< rows grow with the square of a panel's corners
constexpr double kAllowedExtent =
    2e-3;  ///< of a squared extent beyond the limit: what it may grow by

VectorPair pair_of(const SheetRow& row, const RowPoints<Eigen::Dynamic>& points) {
  const Eigen::Vector3d u = points * row.u, v = points * row.v;
  return row.along ? squared_along(u, v) : squared_across(u, v);
}

/// How a panel may lie on the sheet: along a side, with so much of the sheet that way.
struct Placing {
  int side = 0;
  double along = 0.0, across = 0.0;  ///< of the sheet
  double filled = 0.0;               ///< the larger share of the sheet that the panel takes
};

/// Extents of a panel along a direction and across it, squared.
std::array<double, 2> extents(const Positions& points, std::span<const int> panel,
                              const Eigen::Vector3d& v) {
  std::array<double, 2> largest{};
  for (std::size_t k = 0; k < panel.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      const Eigen::Vector3d u = points.col(panel[k]) - points.col(panel[l]);
      const double along = std::pow(u.dot(v), 2) / v.squaredNorm();
      largest[0] = std::max(largest[0], along);
      largest[1] = std::max(largest[1], u.squaredNorm() - along);
    }
  }
  return largest;
}

Placing best_placing(const Positions& points, std::span<const int> panel, double shorter,
                     double longer) {
  Placing best{-1, 0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < panel.size(); ++k) {
    const Eigen::Vector3d v = points.col(panel[(k + 1) % panel.size()]) - points.col(panel[k]);
    if (v.isZero(0.0)) continue;
    const auto [along, across] = extents(points, panel, v);
    for (const bool lengthwise : {true, false}) {
      const double w = lengthwise ? longer : shorter, h = lengthwise ? shorter : longer;
      const double filled = std::max(std::sqrt(along) / w, std::sqrt(across) / h);
      if (best.side >= 0 && !(filled < best.filled)) continue;
      best = {static_cast<int>(k), w, h, filled};
    }
  }
  return best;
}

/// The row of two corners, with each vertex once.
SheetRow row_of(int from, int to, int side_from, int side_to) {
  SheetRow row;
  for (const int vertex : {from, to, side_from, side_to}) {
    if (std::find(row.vertices.begin(), row.vertices.end(), vertex) == row.vertices.end()) {
      row.vertices.push_back(vertex);
    }
  }
  const auto place = [&](int vertex) {
    return std::find(row.vertices.begin(), row.vertices.end(), vertex) - row.vertices.begin();
  };
  row.u.setZero(static_cast<Eigen::Index>(row.vertices.size()));
  row.v = row.u;
  row.u[place(from)] = -1.0;
  row.u[place(to)] = 1.0;
  row.v[place(side_from)] = -1.0;
  row.v[place(side_to)] = 1.0;
  return row;
}

}  // namespace

double value(const SheetRow& row, const RowPoints<Eigen::Dynamic>& points) {
  return pair_of(row, points).value;
}

RowPoints<Eigen::Dynamic> gradient(const SheetRow& row, const RowPoints<Eigen::Dynamic>& points) {
  const VectorPair pair = pair_of(row, points);
  return pair.by_u * row.u.transpose() + pair.by_v * row.v.transpose();
}

LimitHessian<Eigen::Dynamic> hessian(const SheetRow& row, const RowPoints<Eigen::Dynamic>& points) {
  const VectorPair pair = pair_of(row, points);
  const Eigen::Index n = points.cols();
  LimitHessian<Eigen::Dynamic> result(3 * n, 3 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index l = 0; l < n; ++l) {
      result.block<3, 3>(3 * k, 3 * l) =
          row.u[k] * row.u[l] * pair.uu + row.u[k] * row.v[l] * pair.uv +
          row.v[k] * row.u[l] * pair.uv.transpose() + row.v[k] * row.v[l] * pair.vv;
    }
  }
  return result;
}

void SheetLimit::append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                             std::vector<Row>& out) {
  const auto panel = base.mesh.face(face);
  if (panel.size() > kMostCorners) return;
  const Placing placing =
      best_placing(base.points, panel, limit.least / base.unit, limit.most / base.unit);
  if (placing.side < 0) return;
  const int from = panel[static_cast<std::size_t>(placing.side)];
  const int to = panel[static_cast<std::size_t>(placing.side + 1) % panel.size()];
  for (std::size_t k = 0; k < panel.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      SheetRow row = row_of(panel[l], panel[k], from, to);
      RowPoints<Eigen::Dynamic> points(3, static_cast<Eigen::Index>(row.vertices.size()));
      for (std::size_t c = 0; c < row.vertices.size(); ++c) {
        points.col(static_cast<Eigen::Index>(c)) = base.points.col(row.vertices[c]);
      }
      for (const bool along : {true, false}) {
        row.along = along;
        const double most = along ? placing.along * placing.along : placing.across * placing.across;
        const double now = value(row, points);
        if (!along && !(now > 1e-12 * most)) continue;  // the side itself has no width
        row.scale =
            LimitScale::at_most(most, now, 0.5 * most, kAllowedExtent * std::max(now, 1e-3 * most));
        out.push_back(row);
      }
    }
  }
}

}  // namespace planish
