// SPDX-License-Identifier: MIT
#include "offset/sphere_axes.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kCloses = 1e-9;

/// m_j as a linear map of m_i.
Eigen::Matrix3d reflection(const DirectedEdge& edge) {
  return Eigen::Matrix3d::Identity() - 2.0 * edge.direction * edge.direction.transpose();
}

class Reflections {
 public:
  Reflections(const std::vector<DirectedEdge>& edges, const Positions& normals)
      : edges_(edges), normals_(normals), maps_(at(normals.cols())), edges_at_(at(normals.cols())) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      edges_at_[at(edges[e].from)].push_back(e);
      edges_at_[at(edges[e].to)].push_back(e);
    }
    reached_.assign(maps_.size(), 0);
    result_.axes.setZero(3, normals.cols());
  }

  FittedAxes run() {
    for (std::size_t v = 0; v < maps_.size(); ++v) {
      if (reached_[v] == 0 && !edges_at_[v].empty()) fit_piece(static_cast<int>(v));
    }
    return std::move(result_);
  }

 private:
  /// Breadth first, so that the chains of reflections stay short.
  void reach_from(int start) {
    piece_.assign(1, start);
    maps_[at(start)].setIdentity();
    reached_[at(start)] = 1;
    for (std::size_t k = 0; k < piece_.size(); ++k) {
      const int v = piece_[k];
      for (const std::size_t e : edges_at_[at(v)]) {
        const int next = edges_[e].from == v ? edges_[e].to : edges_[e].from;
        if (reached_[at(next)] != 0) continue;
        reached_[at(next)] = 1;
        maps_[at(next)] = reflection(edges_[e]) * maps_[at(v)];
        piece_.push_back(next);
      }
    }
  }

  /// Calls visit(edge, what closing it asks of the first vector).
  template <class Visit>
  void for_each_loop(const Visit& visit) const {
    for (const int v : piece_) {
      for (const std::size_t e : edges_at_[at(v)]) {
        const DirectedEdge& edge = edges_[e];
        if (edge.from != v) continue;
        visit(maps_[at(edge.to)] - reflection(edge) * maps_[at(edge.from)]);
      }
    }
  }

  /// The part of `wish` that closes every loop; along the best single direction where none does.
  [[nodiscard]] Eigen::Vector3d closing_part(const Eigen::Vector3d& wish) const {
    Eigen::Matrix3d triangle =
        Eigen::Matrix3d::Zero();  // of the QR of all gaps, one below the other
    double loops = 0.0;
    for_each_loop([&](const Eigen::Matrix3d& gap) {
      Eigen::Matrix<double, 6, 3> both;
      both << triangle, gap;
      const Eigen::HouseholderQR<Eigen::Matrix<double, 6, 3>> qr(both);
      triangle = qr.matrixQR().topRows<3>().triangularView<Eigen::Upper>();
      loops += 1.0;
    });
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(triangle, Eigen::ComputeFullV);
    Eigen::Vector3d part = Eigen::Vector3d::Zero();
    for (int k = 2; k >= 0; --k) {
      if (k < 2 && !(svd.singularValues()(k) <= kCloses * std::sqrt(loops))) break;
      part += svd.matrixV().col(k) * svd.matrixV().col(k).dot(wish);
    }
    return part;
  }

  void fit_piece(int start) {
    reach_from(start);
    Eigen::Vector3d wish = Eigen::Vector3d::Zero();
    for (const int v : piece_) wish += maps_[at(v)].transpose() * normals_.col(v);
    const Eigen::Vector3d first = closing_part(wish).stableNormalized();
    for (const int v : piece_) result_.axes.col(v) = maps_[at(v)] * first;
    double worst = first.isZero(0.0) ? 1.0 : 0.0;
    for_each_loop([&](const Eigen::Matrix3d& gap) {
      const double miss = (gap * first).norm();
      if (!(miss <= worst)) worst = miss;
    });
    if (!(worst <= result_.miss)) result_.miss = worst;
  }

  const std::vector<DirectedEdge>& edges_;
  const Positions& normals_;
  std::vector<Eigen::Matrix3d> maps_;  ///< from the first vector of a piece
  std::vector<std::vector<std::size_t>> edges_at_;
  std::vector<char> reached_;
  std::vector<int> piece_;
  FittedAxes result_;
};

}  // namespace

FittedAxes reflect_axes(const std::vector<DirectedEdge>& edges, const Positions& normals) {
  return Reflections(edges, normals).run();
}

}  // namespace planish
