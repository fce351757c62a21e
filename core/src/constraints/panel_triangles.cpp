// SPDX-License-Identifier: MIT
#include "constraints/panel_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace planish {
namespace {

constexpr int kMostJoined = 64;  ///< the work grows with the cube

/// The best triangulation between each two corners, from near ones to far ones.
class RoundestTriangles {
 public:
  RoundestTriangles(const Positions& outline, const Eigen::Vector3d& normal)
      : outline_(outline),
        normal_(normal),
        worst_(Eigen::MatrixXd::Constant(outline.cols(), outline.cols(),
                                         std::numeric_limits<double>::infinity())),
        apex_(Eigen::MatrixXi::Constant(outline.cols(), outline.cols(), -1)) {
    const Eigen::Index n = outline.cols();
    for (Eigen::Index span = 2; span < n; ++span) {
      for (Eigen::Index i = 0; i + span < n; ++i) choose_apex(i, i + span);
    }
  }

  [[nodiscard]] bool found() const { return worst_(0, outline_.cols() - 1) > 0.0; }

  void list(Eigen::Index i, Eigen::Index j, std::vector<std::array<int, 3>>& out) const {
    if (j - i < 2) return;
    const int k = apex_(i, j);
    list(i, k, out);
    out.push_back({static_cast<int>(i), k, static_cast<int>(j)});
    list(k, j, out);
  }

 private:
  /// Twice the area of a triangle over its longest side squared, negative on the other side.
  [[nodiscard]] double roundness(Eigen::Index i, Eigen::Index k, Eigen::Index j) const {
    const Eigen::Vector3d a = outline_.col(k) - outline_.col(i);
    const Eigen::Vector3d b = outline_.col(j) - outline_.col(k);
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (a + b).squaredNorm()});
    return longest > 0.0 ? normal_.dot(a.cross(b)) / longest : 0.0;
  }

  void choose_apex(Eigen::Index i, Eigen::Index j) {
    double best = -std::numeric_limits<double>::infinity();
    for (Eigen::Index k = i + 1; k < j; ++k) {
      const double worst = std::min({worst_(i, k), worst_(k, j), roundness(i, k, j)});
      if (worst <= best) continue;
      best = worst;
      apex_(i, j) = static_cast<int>(k);
    }
    worst_(i, j) = best;
  }

  const Positions& outline_;
  const Eigen::Vector3d& normal_;
  Eigen::MatrixXd worst_;  ///< roundness of the worst triangle between two corners
  Eigen::MatrixXi apex_;   ///< third corner of the triangle on the line between them
};

}  // namespace

std::vector<std::array<int, 3>> panel_triangles(const Positions& outline,
                                                const Eigen::Vector3d& normal) {
  std::vector<std::array<int, 3>> triangles;
  if (outline.cols() > kMostJoined) return triangles;
  const RoundestTriangles best(outline, normal);
  if (best.found()) best.list(0, outline.cols() - 1, triangles);
  return triangles;
}

}  // namespace planish
