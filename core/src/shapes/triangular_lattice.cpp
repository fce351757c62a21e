// SPDX-License-Identifier: MIT
#include "shapes/triangular_lattice.hpp"

#include <cmath>
#include <cstdlib>

namespace planish {
namespace {

constexpr std::array<LatticePoint, 6> kNeighbours = {
    {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};

LatticePoint operator+(LatticePoint a, LatticePoint b) { return {a.i + b.i, a.j + b.j}; }

}  // namespace

LatticePatch::LatticePatch(double spacing, double reach,
                           const std::function<bool(const Eigen::Vector2d&)>& inside)
    : spacing_(spacing),
      // A row leans by half a step per row: |i| can exceed the reach by that factor.
      radius_(static_cast<int>(std::ceil(reach / (spacing * kHalfRoot3))) + 2) {
  const std::size_t side = 2 * static_cast<std::size_t>(radius_) + 1;
  inside_.assign(side * side, 0);
  for (int j = 2 - radius_; j <= radius_ - 2; ++j) {
    for (int i = 2 - radius_; i <= radius_ - 2; ++i) {
      if (inside(position({i, j}))) inside_[slot({i, j})] = 1;
    }
  }
  inside_[slot({0, 0})] = 1;
  remove_outliers();
}

std::size_t LatticePatch::slot(LatticePoint point) const {
  return static_cast<std::size_t>(point.j + radius_) * static_cast<std::size_t>(2 * radius_ + 1) +
         static_cast<std::size_t>(point.i + radius_);
}

bool LatticePatch::contains(LatticePoint point) const {
  return std::abs(point.i) <= radius_ && std::abs(point.j) <= radius_ && inside_[slot(point)] != 0;
}

Eigen::Vector2d LatticePatch::position(LatticePoint point) const {
  return {spacing_ * (point.i + 0.5 * point.j), spacing_ * (kHalfRoot3 * point.j)};
}

std::size_t LatticePatch::index(LatticeCell cell) const {
  return 3 * slot(cell.owner) + static_cast<std::size_t>(cell.kind);
}

std::vector<LatticePoint> LatticePatch::points() const {
  std::vector<LatticePoint> points;
  for (int j = -radius_; j <= radius_; ++j) {
    for (int i = -radius_; i <= radius_; ++i) {
      if (inside_[slot({i, j})]) points.push_back({i, j});
    }
  }
  return points;
}

/// Points with fewer than three neighbours would stand out from the boundary like teeth. Two
/// passes settle a smooth region; a very small patch stays as it is.
void LatticePatch::remove_outliers() {
  constexpr std::size_t kTooFewToTrim = 20;
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<LatticePoint> before = points();
    if (before.size() < kTooFewToTrim) return;
    std::vector<LatticePoint> outliers;
    for (const LatticePoint point : before) {
      int neighbours = 0;
      for (const LatticePoint step : kNeighbours) neighbours += contains(point + step) ? 1 : 0;
      if (neighbours < 3) outliers.push_back(point);
    }
    for (const LatticePoint point : outliers) inside_[slot(point)] = 0;
  }
}

std::array<LatticeCell, 6> triangles_around(LatticePoint p) {
  return {{{p, 0},
           {p, 1},
           {{p.i - 1, p.j}, 0},
           {{p.i, p.j - 1}, 1},
           {{p.i, p.j - 1}, 0},
           {{p.i + 1, p.j - 1}, 1}}};
}

std::array<LatticeCell, 6> edges_around(LatticePoint p) {
  return {
      {{p, 0}, {p, 1}, {p, 2}, {{p.i - 1, p.j}, 0}, {{p.i, p.j - 1}, 1}, {{p.i + 1, p.j - 1}, 2}}};
}

std::array<LatticePoint, 3> triangle_corners(LatticeCell triangle) {
  const LatticePoint p = triangle.owner;
  const auto first = static_cast<std::size_t>(triangle.kind);
  return {{p, p + kNeighbours[first], p + kNeighbours[first + 1]}};
}

std::array<LatticeCell, 3> triangle_edges(LatticeCell triangle) {
  const LatticePoint p = triangle.owner;
  if (triangle.kind == 0) return {{{p, 0}, {{p.i + 1, p.j}, 2}, {p, 1}}};
  return {{{p, 1}, {{p.i - 1, p.j + 1}, 0}, {p, 2}}};
}

std::array<LatticePoint, 2> edge_ends(LatticeCell edge) {
  return {{edge.owner, edge.owner + kNeighbours[static_cast<std::size_t>(edge.kind)]}};
}

}  // namespace planish
