// SPDX-License-Identifier: MIT
#include "shapes/lattice_shapes.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "shapes/placement.hpp"
#include "shapes/triangular_lattice.hpp"

namespace planish {
namespace {

/// Collects faces; a vertex is numbered when a face first uses its cell.
class CellMesh {
 public:
  explicit CellMesh(const LatticePatch& patch) : patch_(patch), numbers_(patch.cell_limit(), -1) {}

  template <std::size_t kSides>
  void add_face(const std::array<LatticeCell, kSides>& cells) {
    for (const LatticeCell cell : cells) {
      int& number = numbers_[patch_.index(cell)];
      if (number < 0) {
        number = static_cast<int>(cells_.size());
        cells_.push_back(cell);
      }
      mesh_.face_vertices.push_back(number);
    }
    mesh_.face_offsets.push_back(static_cast<int>(mesh_.face_vertices.size()));
  }

  /// The mesh, with `place(cell)` for each vertex.
  template <class Place>
  [[nodiscard]] Mesh finish(const Place& place) && {
    mesh_.positions.resize(3, static_cast<Eigen::Index>(cells_.size()));
    for (std::size_t v = 0; v < cells_.size(); ++v) {
      mesh_.positions.col(static_cast<Eigen::Index>(v)) = place(cells_[v]);
    }
    return std::move(mesh_);
  }

 private:
  const LatticePatch& patch_;
  std::vector<int> numbers_;
  std::vector<LatticeCell> cells_;
  Mesh mesh_;
};

/// Spacing at which a region of `area` holds `points` lattice points.
double spacing_for(double area, double points) { return std::sqrt(area / (kHalfRoot3 * points)); }

/// Three tangent planes of Z = X² + Y² at the corners of a regular triangle meet below the
/// triangle's centre. A projective map then takes the paraboloid to an egg; at its crown it is
/// the stereographic map, which keeps the hexagons nearly regular.
Eigen::Vector3d egg_point(const Eigen::Vector2d& centre, double spacing) {
  const double x = centre.x(), y = centre.y();
  const double z = centre.squaredNorm() - spacing * spacing / 3.0;
  const double depth = 1.0 + z + 0.22 * x + 0.05 * y;
  return {2.3 * x / depth, 1.75 * y / depth, 1.15 * (1.0 - z) / depth};
}

/// Height and slope of the saddle: an anticlastic surface, steeper towards one corner.
struct Tangent {
  double height;
  Eigen::Vector2d slope;
};

Tangent saddle_tangent(const Eigen::Vector2d& p) {
  constexpr double kUp = 0.46, kDown = 0.54, kTwist = 0.10, kSkew = 0.05, kLean = 0.04;
  const double x = p.x(), y = p.y();
  return {
      0.5 * (kUp * x * x - kDown * y * y) + kTwist * x * y + kSkew * x * x * x + kLean * x * y * y,
      {kUp * x + kTwist * y + 3.0 * kSkew * x * x + kLean * y * y,
       -kDown * y + kTwist * x + 2.0 * kLean * x * y}};
}

/// The point of the line in which the tangent planes at p and q meet that lies next to their
/// midpoint: m + λ (slope difference), where both planes have the same height.
Eigen::Vector3d ridge_point(const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  const Tangent at_p = saddle_tangent(p), at_q = saddle_tangent(q);
  const Eigen::Vector2d middle = 0.5 * (p + q);
  const Eigen::Vector2d bend = at_q.slope - at_p.slope;
  const double gap =
      (at_p.height + at_p.slope.dot(middle - p)) - (at_q.height + at_q.slope.dot(middle - q));
  const Eigen::Vector2d plan = middle + (gap / bend.squaredNorm()) * bend;
  const double height =
      0.5 * ((at_p.height + at_p.slope.dot(plan - p)) + (at_q.height + at_q.slope.dot(plan - q)));
  return {plan.x(), plan.y(), height};
}

}  // namespace

Mesh make_hex_shell(int size) {
  constexpr double kRadius = 0.54;
  // A rounded triangle: r² − k r³ cos 3φ ≤ radius², written without angles.
  const auto inside = [](const Eigen::Vector2d& p) {
    const double cubic = p.x() * (p.x() * p.x() - 3.0 * p.y() * p.y());
    return p.squaredNorm() - 0.30 * cubic <= kRadius * kRadius;
  };
  const double points = 0.5 * size * size;  // each hexagon brings two vertices
  const double spacing = spacing_for(3.1416 * kRadius * kRadius, points);
  const LatticePatch patch(spacing, 1.2 * kRadius, inside);
  CellMesh cells(patch);
  for (const LatticePoint point : patch.points()) cells.add_face(triangles_around(point));
  Mesh mesh = std::move(cells).finish([&](LatticeCell triangle) {
    const auto corners = triangle_corners(triangle);
    const Eigen::Vector2d centre =
        (patch.position(corners[0]) + patch.position(corners[1]) + patch.position(corners[2])) /
        3.0;
    return egg_point(centre, spacing);
  });
  place_with_unit_edges(mesh);
  return mesh;
}

Mesh make_trihex_shell(int size) {
  // A long hexagon along the lattice's own directions has straight sides.
  constexpr double kHalfWidth = 0.92, kHalfLength = 1.4, kSlant = 0.57735026918962576;
  const auto inside = [](const Eigen::Vector2d& p) {
    return std::abs(p.y()) <= kHalfWidth &&
           std::abs(p.x()) + kSlant * std::abs(p.y()) <= kHalfLength;
  };
  constexpr double kArea = 4.0 * kHalfWidth * (kHalfLength - 0.5 * kSlant * kHalfWidth);
  const double points = size * (size / 3.0);  // each hexagon brings three vertices
  const LatticePatch patch(spacing_for(kArea, points), kHalfLength, inside);
  CellMesh cells(patch);
  for (const LatticePoint point : patch.points()) cells.add_face(edges_around(point));
  // A triangle between two hexagons closes the notch between them; so no vertex is a pinch.
  std::vector<char> added(patch.cell_limit(), 0);
  for (const LatticePoint point : patch.points()) {
    for (const LatticeCell triangle : triangles_around(point)) {
      int hexagons = 0;
      for (const LatticePoint corner : triangle_corners(triangle)) {
        hexagons += patch.contains(corner) ? 1 : 0;
      }
      if (hexagons < 2 || std::exchange(added[patch.index(triangle)], char{1}) != 0) continue;
      cells.add_face(triangle_edges(triangle));
    }
  }
  Mesh mesh = std::move(cells).finish([&](LatticeCell edge) {
    const auto ends = edge_ends(edge);
    return ridge_point(patch.position(ends[0]), patch.position(ends[1]));
  });
  place_with_unit_edges(mesh);
  return mesh;
}

}  // namespace planish
