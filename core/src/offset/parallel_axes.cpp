// SPDX-License-Identifier: MIT
#include "offset/parallel_axes.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "engines/sparse_cholesky.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A corner of a panel, whose plane comes to the distance 1.
struct PlaneRow {
  int vertex = 0, face = 0;
};

/// A value for every row: what is across an edge, and along the normal of a plane.
struct RowValues {
  Positions edges;
  Eigen::VectorXd planes;

  void add(double factor, const RowValues& other) {
    edges += factor * other.edges;
    planes += factor * other.planes;
  }

  /// NaN if one is.
  [[nodiscard]] double largest() const {
    double most = 0.0;
    for (const auto& edge : edges.colwise()) raise(most, edge.norm());
    for (const double plane : planes) raise(most, std::abs(plane));
    return most;
  }

 private:
  static void raise(double& most, double value) {
    if (!(value <= most)) most = value;
  }
};

RaggedRows graph_of(const std::vector<DirectedEdge>& edges, int count) {
  RaggedRows graph;
  graph.offsets.assign(at(count) + 1, 0);
  for (const DirectedEdge& edge : edges) {
    ++graph.offsets[at(edge.from) + 1];
    ++graph.offsets[at(edge.to) + 1];
  }
  for (std::size_t v = 1; v < graph.offsets.size(); ++v) graph.offsets[v] += graph.offsets[v - 1];
  graph.values.resize(2 * edges.size());
  std::vector<int> next(graph.offsets.begin(), graph.offsets.end() - 1);
  for (const DirectedEdge& edge : edges) {
    graph.values[at(next[at(edge.from)]++)] = edge.to;
    graph.values[at(next[at(edge.to)]++)] = edge.from;
  }
  return graph;
}

class AxesFit {
 public:
  AxesFit(const Mesh& mesh, const std::vector<DirectedEdge>& edges, const OutsideNormals& normals,
          bool equal_planes)
      : edges_(edges), normals_(normals), axes_(normals.vertices) {
    for (int f = 0; f < mesh.face_count() && equal_planes; ++f) {
      if (normals.faces.col(f).isZero(0.0)) continue;
      for (const int v : mesh.face(f)) planes_.push_back({v, f});
    }
    cholesky_.analyze(graph_of(edges, mesh.vertex_count()), 3);
    residuals_ = residuals();
    forces_ = residuals_;
    forces_.edges.setZero();
    forces_.planes.setZero();
  }

  /// False if rounding left no factor for this penalty.
  [[nodiscard]] bool factorize(double penalty) {
    penalty_ = penalty;
    assemble();
    return cholesky_.factorize();
  }

  void step() {
    RowValues forces = forces_;
    forces.add(penalty_, residuals_);
    const Positions rest = normals_.vertices - axes_ - pulled_back(forces);
    Eigen::VectorXd change = Eigen::Map<const Eigen::VectorXd>(rest.data(), rest.size());
    cholesky_.solve(change);
    axes_ += Eigen::Map<const Positions>(change.data(), 3, axes_.cols());
    residuals_ = residuals();
    forces_.add(penalty_, residuals_);
  }

  [[nodiscard]] FittedAxes state() const { return {axes_, residuals_.largest()}; }

 private:
  /// A m − b.
  [[nodiscard]] RowValues residuals() const {
    RowValues rows{Positions(3, static_cast<Eigen::Index>(edges_.size())),
                   Eigen::VectorXd(static_cast<Eigen::Index>(planes_.size()))};
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const DirectedEdge& edge = edges_[e];
      rows.edges.col(static_cast<Eigen::Index>(e)) =
          edge.across(axes_.col(edge.to) - axes_.col(edge.from));
    }
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const PlaneRow& row = planes_[k];
      rows.planes(static_cast<Eigen::Index>(k)) =
          normals_.faces.col(row.face).dot(axes_.col(row.vertex)) - 1.0;
    }
    return rows;
  }

  /// Aᵀ of values of the rows.
  [[nodiscard]] Positions pulled_back(const RowValues& rows) const {
    Positions sum = Positions::Zero(3, axes_.cols());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const DirectedEdge& edge = edges_[e];
      const Eigen::Vector3d pull = edge.across(rows.edges.col(static_cast<Eigen::Index>(e)));
      sum.col(edge.to) += pull;
      sum.col(edge.from) -= pull;
    }
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const PlaneRow& row = planes_[k];
      sum.col(row.vertex) +=
          rows.planes(static_cast<Eigen::Index>(k)) * normals_.faces.col(row.face);
    }
    return sum;
  }

  void assemble() {
    cholesky_.set_zero();
    for (int v = 0; v < cholesky_.node_count(); ++v) add(v, v, Eigen::Matrix3d::Identity());
    for (const DirectedEdge& edge : edges_) {
      const Eigen::Vector3d& d = edge.direction;
      const Eigen::Matrix3d block = penalty_ * (Eigen::Matrix3d::Identity() - d * d.transpose());
      add(edge.from, edge.from, block);
      add(edge.to, edge.to, block);
      const bool later = cholesky_.position(edge.from) > cholesky_.position(edge.to);
      add(later ? edge.from : edge.to, later ? edge.to : edge.from, -block);
    }
    for (const PlaneRow& row : planes_) {
      const Eigen::Vector3d n = normals_.faces.col(row.face);
      add(row.vertex, row.vertex, penalty_ * n * n.transpose());
    }
  }

  void add(int row, int column, const Eigen::Matrix3d& block) {
    const BlockSlot slot = cholesky_.slot(row, column);
    double* values = cholesky_.values().data() + slot.offset;
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) values[r + c * slot.stride] += block(r, c);
    }
  }

  const std::vector<DirectedEdge>& edges_;
  const OutsideNormals& normals_;
  Positions axes_;
  std::vector<PlaneRow> planes_;
  RowValues residuals_, forces_;
  SparseCholesky cholesky_;
  double penalty_ = 0.0;
};

/// Steps until rounding, or until three in a row have not halved the residual.
FittedAxes settle(AxesFit& fit) {
  constexpr double kRounding = 1e-14;
  constexpr int kLeast = 3;  // what no row sees settles like a refined solution
  constexpr int kMost = 60;
  constexpr int kPatience = 3;
  FittedAxes best = fit.state();
  int idle = 0;
  for (int step = 1; step <= kMost && idle < kPatience; ++step) {
    fit.step();
    FittedAxes now = fit.state();
    idle = now.miss <= 0.5 * best.miss ? 0 : idle + 1;
    if (now.miss <= best.miss || step <= kLeast) best = std::move(now);
    if (step >= kLeast && best.miss <= kRounding) break;
  }
  return best;
}

}  // namespace

FittedAxes fit_axes(const Mesh& mesh, const std::vector<DirectedEdge>& edges,
                    const OutsideNormals& normals, bool equal_planes,
                    const std::function<bool(const FittedAxes&)>& good_enough) {
  constexpr double kFirst = 1e10;
  constexpr double kLast = 1e14;  // 1 must not drown in rounding beside it
  constexpr double kHopeless = 1e-3;
  AxesFit fit(mesh, edges, normals, equal_planes);
  FittedAxes best = fit.state();
  for (double penalty = kFirst; penalty <= kLast; penalty *= 100.0) {
    if (!fit.factorize(penalty)) break;
    best = settle(fit);
    if (best.miss > kHopeless || good_enough(best)) break;
  }
  return best;
}

}  // namespace planish
