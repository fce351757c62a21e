// SPDX-License-Identifier: MIT
#include "offset/offset_measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/trigonometry.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Smallest, mean and largest of what is added; zeros of nothing.
class SpreadSum {
 public:
  void add(double value) {
    spread_.min = std::min(spread_.min, value);
    spread_.max = std::max(spread_.max, value);
    sum_ += value;
    ++count_;
  }
  [[nodiscard]] Spread spread() const {
    if (count_ == 0) return {};
    // Rounding of the sum must not lead out of the range.
    return {spread_.min, std::clamp(sum_ / count_, spread_.min, spread_.max), spread_.max};
  }

 private:
  Spread spread_{std::numeric_limits<double>::infinity(), 0.0,
                 -std::numeric_limits<double>::infinity()};
  double sum_ = 0.0;
  int count_ = 0;
};

double signed_length(const Eigen::Vector3d& vector, const Eigen::Vector3d& outside) {
  const double length = vector.stableNorm();
  return vector.dot(outside) < 0.0 ? -length : length;
}

/// How far `value` is from `wanted`, if that is farther than before; a NaN is.
void raise(double& worst, double value, double wanted) {
  const double off = std::abs(value - wanted);
  if (!(off <= worst)) worst = off;
}

void measure_panels(const Mesh& mesh, const OutsideNormals& normals, const Positions& moves,
                    double distance, OffsetReport& report) {
  SpreadSum spread;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const Eigen::Vector3d normal = normals.faces.col(f);
    if (normal.isZero(0.0)) continue;
    for (const int v : mesh.face(f)) {
      const double here = normal.dot(moves.col(v));
      spread.add(here);
      if (report.kind == OffsetKind::kFace) raise(report.deviation, here, distance);
    }
  }
  report.panels = spread.spread();
}

void measure_edges(const Mesh& mesh, const std::vector<DirectedEdge>& edges,
                   const OutsideNormals& normals, const Positions& moves, MeshOffset& offset) {
  SpreadSum spread;
  for (const DirectedEdge& edge : edges) {
    const Eigen::Vector3d outside = normals.vertices.col(edge.from) + normals.vertices.col(edge.to);
    const Eigen::Vector3d along = mesh.positions.col(edge.to) - mesh.positions.col(edge.from);
    const Eigen::Vector3d there = offset.positions.col(edge.to) - offset.positions.col(edge.from);
    const double length = std::max(along.stableNorm(), there.stableNorm());
    spread.add(signed_length(edge.across(moves.col(edge.from)), outside));
    if (edge.direction.isZero(0.0) || length == 0.0) continue;
    raise(offset.report.edge_residual, edge.across(there).stableNorm() / length, 0.0);
    if (edge.direction.dot(there) < 0.0) ++offset.report.turned_edges;
  }
  offset.report.heights = spread.spread();
}

void measure_nodes(const Mesh& mesh, const OutsideNormals& normals, const Positions& moves,
                   double distance, MeshOffset& offset) {
  constexpr double kDegrees = 180.0 / kPi;
  SpreadSum spread;
  std::vector<char> used(at(mesh.vertex_count()), 0);
  for (const int v : mesh.face_vertices) used[at(v)] = 1;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (used[at(v)] == 0) continue;
    const Eigen::Vector3d normal = normals.vertices.col(v);
    const Eigen::Vector3d axis = offset.axes.col(v);
    const double here = signed_length(moves.col(v), normal);
    spread.add(here);
    if (offset.report.kind == OffsetKind::kVertex) {
      raise(offset.report.deviation, std::abs(here), std::abs(distance));
    }
    if (normal.isZero(0.0) || axis.isZero(0.0)) continue;
    const double lean = arctangent(normal.cross(axis).norm(), normal.dot(axis)) * kDegrees;
    offset.report.largest_lean = std::max(offset.report.largest_lean, lean);
  }
  offset.report.nodes = spread.spread();
}

}  // namespace

void measure_offset(const Mesh& mesh, const std::vector<DirectedEdge>& edges,
                    const OutsideNormals& normals, double distance, MeshOffset& offset) {
  const Positions moves = offset.positions - mesh.positions;
  measure_panels(mesh, normals, moves, distance, offset.report);
  measure_edges(mesh, edges, normals, moves, offset);
  measure_nodes(mesh, normals, moves, distance, offset);
}

}  // namespace planish
