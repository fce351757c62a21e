// SPDX-License-Identifier: MIT
#include "planish/measures/energies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace planish {
namespace {

using Row = std::vector<std::pair<int, double>>;  ///< (vertex, coefficient)

/// Collects rows, then becomes a matrix.
class RowList {
 public:
  void add(const Row& row) {
    for (const auto& [vertex, value] : row) triplets_.emplace_back(rows_, vertex, value);
    ++rows_;
  }
  [[nodiscard]] FairnessOperator matrix(int columns) const {
    FairnessOperator result(rows_, columns);
    result.setFromTriplets(triplets_.begin(), triplets_.end());
    result.makeCompressed();
    return result;
  }

 private:
  int rows_ = 0;
  std::vector<Eigen::Triplet<double>> triplets_;
};

/// scale · (mean of `around` − vertex)
Row mean_row(int vertex, std::span<const int> around, double scale) {
  Row row{{vertex, -scale}};
  for (const int other : around)
    row.emplace_back(other, scale / static_cast<double>(around.size()));
  return row;
}

Row second_difference(int before, int vertex, int after) {
  return {{before, 1.0}, {vertex, -2.0}, {after, 1.0}};
}

/// Whether the boundary turns a corner here: the vertex belongs to a single triangle or quad.
bool is_corner(const Mesh& mesh, const Adjacency& adjacency, int vertex) {
  const auto faces = adjacency.faces[vertex];
  return faces.size() == 1 && mesh.face(faces[0]).size() < 5;
}

/// The two neighbours along the boundary, or none: a corner, or several boundaries that touch.
std::vector<int> boundary_neighbours(const Mesh& mesh, const Adjacency& adjacency, int vertex) {
  const auto around = adjacency.neighbours[vertex];
  const auto at = static_cast<std::size_t>(vertex);
  if (!adjacency.regular[at] || around.size() < 2 || is_corner(mesh, adjacency, vertex)) return {};
  return {around.front(), around.back()};
}

FairnessOperator laplacian(const Mesh& mesh, const Adjacency& adjacency) {
  RowList rows;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!adjacency.boundary[static_cast<std::size_t>(v)]) {
      if (!adjacency.neighbours[v].empty()) rows.add(mean_row(v, adjacency.neighbours[v], 1.0));
    } else if (const auto pair = boundary_neighbours(mesh, adjacency, v); !pair.empty()) {
      rows.add(mean_row(v, pair, 1.0));
    }
  }
  return rows.matrix(mesh.vertex_count());
}

/// The edge polylines through `vertex`: pairs (before, after) of opposite neighbours.
std::vector<std::pair<int, int>> lines_through(const Mesh& mesh, const Adjacency& adjacency,
                                               int vertex) {
  std::vector<std::pair<int, int>> lines;
  if (adjacency.boundary[static_cast<std::size_t>(vertex)]) {
    const auto pair = boundary_neighbours(mesh, adjacency, vertex);
    if (!pair.empty()) lines.emplace_back(pair[0], pair[1]);
    return lines;
  }
  const auto around = adjacency.neighbours[vertex];
  if (around.size() % 2 != 0) return lines;
  const std::size_t half = around.size() / 2;
  for (std::size_t k = 0; k < half; ++k) lines.emplace_back(around[k], around[k + half]);
  return lines;
}

/// Interior, and no line goes straight through: the averaged row stands in.
bool is_averaged(const Adjacency& adjacency, int vertex) {
  return !adjacency.boundary[static_cast<std::size_t>(vertex)] &&
         adjacency.neighbours[vertex].size() % 2 == 1;
}

FairnessOperator second_differences(const Mesh& mesh, const Adjacency& adjacency) {
  RowList rows;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    for (const auto& [before, after] : lines_through(mesh, adjacency, v)) {
      rows.add(second_difference(before, v, after));
    }
    if (is_averaged(adjacency, v)) rows.add(mean_row(v, adjacency.neighbours[v], 2.0));
  }
  return rows.matrix(mesh.vertex_count());
}

/// after − before, where both are rows of second order: equal columns are summed by the matrix.
Row difference(const Row& after, const Row& before) {
  Row row = after;
  for (const auto& [vertex, value] : before) row.emplace_back(vertex, -value);
  return row;
}

/// The second-order row at `vertex` along the line that arrives from `from`; empty if it ends.
Row continued_row(const Mesh& mesh, const Adjacency& adjacency, int from, int vertex) {
  if (is_averaged(adjacency, vertex)) return mean_row(vertex, adjacency.neighbours[vertex], 2.0);
  for (const auto& [before, after] : lines_through(mesh, adjacency, vertex)) {
    if (before == from || after == from) return second_difference(before, vertex, after);
  }
  return {};
}

/// Along every edge, the change of the second-order row from one end to the other.
FairnessOperator third_differences(const Mesh& mesh, const Adjacency& adjacency) {
  RowList rows;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    for (const int other : adjacency.neighbours[v]) {
      if (other <= v) continue;  // each edge once
      const Row here = continued_row(mesh, adjacency, other, v);
      const Row there = continued_row(mesh, adjacency, v, other);
      if (!here.empty() && !there.empty()) rows.add(difference(there, here));
    }
  }
  return rows.matrix(mesh.vertex_count());
}

}  // namespace

FairnessOperator fairness_operator(const Mesh& mesh, const Adjacency& adjacency,
                                   FairnessKind kind) {
  switch (kind) {
    case FairnessKind::kLaplacian:
      return laplacian(mesh, adjacency);
    case FairnessKind::kSecondDifference:
      return second_differences(mesh, adjacency);
    case FairnessKind::kThirdDifference:
      return third_differences(mesh, adjacency);
  }
  return {};
}

std::vector<double> bending(const FairnessOperator& fairness, const Positions& displacement) {
  constexpr double kEqual = 1.0 - 1e-9;  // a third difference is about both its inner vertices
  std::vector<double> result(static_cast<std::size_t>(fairness.cols()), 0.0);
  for (Eigen::Index r = 0; r < fairness.rows(); ++r) {
    Eigen::Vector3d bend = Eigen::Vector3d::Zero();
    double largest = 0.0;
    for (FairnessOperator::InnerIterator entry(fairness, r); entry; ++entry) {
      bend += entry.value() * displacement.col(entry.col());
      largest = std::max(largest, std::abs(entry.value()));
    }
    for (FairnessOperator::InnerIterator entry(fairness, r); entry; ++entry) {
      if (std::abs(entry.value()) < kEqual * largest) continue;
      double& here = result[static_cast<std::size_t>(entry.col())];
      here = std::max(here, bend.norm());
    }
  }
  return result;
}

}  // namespace planish
