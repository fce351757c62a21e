// SPDX-License-Identifier: MIT
#include "planish/constraints/conical_star.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/trigonometry.hpp"
#include "planish/constraints/vector_pair.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr std::size_t kFewest = 6;  ///< of a star: a vertex and five neighbours
constexpr double kFlat = 1e-6;      ///< radians: a cone that opens by less is a plane
constexpr double kDegreesOfRadian = 180.0 / kPi;

using Blocks = std::array<std::array<Eigen::Matrix3d, 9>, 9>;  ///< by two vertices
using FourNormals = std::array<Eigen::Vector3d, 4>;

Eigen::Vector3d arm(const RowPoints<9>& points, int place) {
  return points.col(place) - points.col(0);
}

FourNormals normals_of(const NormalsOnCircle& row, const RowPoints<9>& points) {
  FourNormals normals;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto [from, to] = row.arms[f];
    normals[f] = Eigen::Vector3d(arm(points, from).cross(arm(points, to))).normalized();
  }
  return normals;
}

double determinant(const FourNormals& n) {
  return (n[1] - n[0]).dot((n[2] - n[0]).cross(n[3] - n[0]));
}

/// Twice the area of the triangle of the first three.
double area_of(const FourNormals& n) { return (n[1] - n[0]).cross(n[2] - n[0]).norm(); }

/// How far the fourth is from the plane of the three.
double height(const FourNormals& n) { return determinant(n) / area_of(n); }

/// ∂det/∂n_f. They add up to zero.
FourNormals slopes_of(const FourNormals& n) {
  FourNormals slopes;
  slopes[0].setZero();
  for (std::size_t f = 1; f < 4; ++f) {
    slopes[f] = (n[f % 3 + 1] - n[0]).cross(n[(f + 1) % 3 + 1] - n[0]);
    slopes[0] -= slopes[f];
  }
  return slopes;
}

/// ∂²det/∂n_f∂n_g: [w]× of what is left of the determinant.
Eigen::Matrix3d mixed_slope(const FourNormals& n, std::size_t f, std::size_t g) {
  if (f == g) return Eigen::Matrix3d::Zero();
  if (f == 0 || g == 0) {  // moving all four together changes nothing
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t h = 1; h < 4; ++h) sum -= f == 0 ? mixed_slope(n, h, g) : mixed_slope(n, f, h);
    return sum;
  }
  const bool in_order = f % 3 + 1 == g;
  const std::size_t left = in_order ? g % 3 + 1 : f % 3 + 1;
  return (in_order ? -1.0 : 1.0) * cross_matrix(n[left] - n[0]);
}

/// How the unit normal of a face moves with its two arms.
struct NormalMotion {
  Eigen::Vector3d normal;
  double size = 1.0;                    ///< twice the area of the triangle of both arms
  std::array<Eigen::Matrix3d, 2> area;  ///< ∂(a × b)
  std::array<Eigen::Matrix3d, 2> unit;  ///< ∂ of it over its length
};

NormalMotion motion_of(const RowPoints<9>& points, const std::array<int, 2>& arms) {
  NormalMotion motion;
  const Eigen::Vector3d a = arm(points, arms[0]), b = arm(points, arms[1]);
  const Eigen::Vector3d area = a.cross(b);
  motion.size = area.norm();
  motion.normal = area / motion.size;
  motion.area = {-cross_matrix(b), cross_matrix(a)};
  const Eigen::Matrix3d across =
      (Eigen::Matrix3d::Identity() - motion.normal * motion.normal.transpose()) / motion.size;
  for (std::size_t k = 0; k < 2; ++k) motion.unit[k] = across * motion.area[k];
  return motion;
}

/// ∂²(slope · n) of a slope that is held, by an arm and an arm.
Eigen::Matrix3d bend_of(const NormalMotion& motion, const Eigen::Vector3d& slope, std::size_t k,
                        std::size_t l) {
  const Eigen::Vector3d& n = motion.normal;
  const double along = slope.dot(n);
  const Eigen::Matrix3d outer = slope * n.transpose();
  const Eigen::Matrix3d bend = (3.0 * along * n * n.transpose() - outer - outer.transpose() -
                                along * Eigen::Matrix3d::Identity()) /
                               (motion.size * motion.size);
  const Eigen::Matrix3d own = motion.area[k].transpose() * bend * motion.area[l];
  if (k == l) return own;
  const Eigen::Matrix3d mixed = cross_matrix((slope - along * n) / motion.size);
  return k < l ? Eigen::Matrix3d(own - mixed) : Eigen::Matrix3d(own + mixed);
}

/// Three faces of a star, a third of it apart: their normals span the circle of the others.
struct Triple {
  std::size_t first = 0;
  double area = 0.0;    ///< twice that of the triangle of the normals
  double radius = 0.0;  ///< of their circle

  [[nodiscard]] bool is_flat() const { return !(area > kFlat * kFlat) || !(radius > kFlat); }
};

/// A star, face by face: face f is between the neighbours f and f + 1.
class StarFaces {
 public:
  StarFaces(const Positions& positions, std::span<const int> star)
      : positions_(positions), star_(star), valence_(star.size() - 1) {
    for (std::size_t f = 0; f < valence_; ++f) {
      normals_.push_back(Eigen::Vector3d(edge(f).cross(edge(f + 1))).normalized());
    }
  }

  [[nodiscard]] std::size_t valence() const { return valence_; }
  [[nodiscard]] int neighbour(std::size_t k) const { return star_[1 + k % valence_]; }
  [[nodiscard]] Eigen::Vector3d edge(std::size_t k) const {
    return positions_.col(neighbour(k)) - positions_.col(star_[0]);
  }
  /// The faces of a triple, by number.
  [[nodiscard]] std::array<std::size_t, 3> faces(const Triple& triple) const {
    return {triple.first, (triple.first + valence_ / 3) % valence_,
            (triple.first + 2 * valence_ / 3) % valence_};
  }

  /// The triple whose normals are furthest apart; of those that rounding alone tells apart the
  /// first.
  [[nodiscard]] Triple widest() const {
    constexpr double kClearly = 1.0 + 1e-6;
    Triple best;
    const std::size_t triples = valence_ % 3 == 0 ? valence_ / 3 : valence_;
    for (std::size_t first = 0; first < triples; ++first) {
      Triple here{first};
      const auto [a, b, c] = faces(here);
      const Eigen::Vector3d ab = normals_[b] - normals_[a], ac = normals_[c] - normals_[a];
      here.area = ab.cross(ac).norm();
      here.radius = ab.norm() * ac.norm() * (normals_[c] - normals_[b]).norm() / (2.0 * here.area);
      if (here.area > kClearly * best.area) best = here;
    }
    return best;
  }

  /// Calls visit(face, height) for every face beside the triple.
  template <class Visit>
  void for_each_other(const Triple& triple, const Visit& visit) const {
    const auto three = faces(triple);
    for (std::size_t f = 0; f < valence_; ++f) {
      if (std::find(three.begin(), three.end(), f) != three.end()) continue;
      visit(f, height({normals_[three[0]], normals_[three[1]], normals_[three[2]], normals_[f]}));
    }
  }

  /// Least height of a face's triangle at the vertex.
  [[nodiscard]] double least_height() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < valence_; ++f) {
      const double area = edge(f).cross(edge(f + 1)).norm();
      least = std::min(least, area / std::max(edge(f).norm(), edge(f + 1).norm()));
    }
    return least;
  }

 private:
  const Positions& positions_;
  std::span<const int> star_;
  std::size_t valence_;
  std::vector<Eigen::Vector3d> normals_;
};

/// The row of a triple and the face `other`. A neighbour between two of them has one place.
NormalsOnCircle row_of(const StarFaces& star, int vertex, const Triple& triple, std::size_t other) {
  NormalsOnCircle row;
  row.vertices.fill(vertex);
  int used = 0;
  const auto place_of = [&](int neighbour) {
    const auto begin = row.vertices.begin() + 1;
    const auto found = std::find(begin, begin + used, neighbour);
    if (found == begin + used) row.vertices[at(++used)] = neighbour;
    return static_cast<int>(found - row.vertices.begin());
  };
  const auto [a, b, c] = star.faces(triple);
  const std::array<std::size_t, 4> faces{a, b, c, other};
  for (std::size_t f = 0; f < 4; ++f) {
    row.arms[f] = {place_of(star.neighbour(faces[f])), place_of(star.neighbour(faces[f] + 1))};
  }
  return row;
}

}  // namespace

double residual(const NormalsOnCircle& row, const RowPoints<9>& points) {
  return row.scale * height(normals_of(row, points));
}

RowPoints<9> gradient(const NormalsOnCircle& row, const RowPoints<9>& points) {
  const FourNormals normals = normals_of(row, points);
  const FourNormals slopes = slopes_of(normals);
  const double scale = row.scale / area_of(normals);
  RowPoints<9> result = RowPoints<9>::Zero();
  for (std::size_t f = 0; f < 4; ++f) {
    const NormalMotion motion = motion_of(points, row.arms[f]);
    for (std::size_t k = 0; k < 2; ++k) {
      const Eigen::Vector3d by_arm = scale * (motion.unit[k].transpose() * slopes[f]);
      result.col(row.arms[f][k]) += by_arm;
      result.col(0) -= by_arm;
    }
  }
  return result;
}

CurvatureBlocks<9, true> hessian(const NormalsOnCircle& row, const RowPoints<9>& points) {
  const FourNormals normals = normals_of(row, points);
  const FourNormals slopes = slopes_of(normals);
  const double scale = row.scale / area_of(normals);
  std::array<NormalMotion, 4> motions;
  for (std::size_t f = 0; f < 4; ++f) motions[f] = motion_of(points, row.arms[f]);
  Blocks h;
  for (auto& blocks : h) blocks.fill(Eigen::Matrix3d::Zero());
  // Moving all points together changes nothing: what an arm adds, the vertex takes away.
  const auto add = [&](int a, int b, const Eigen::Matrix3d& block) {
    h[at(a)][at(b)] += block;
    h[at(a)][0] -= block;
    h[0][at(b)] -= block;
    h[0][0] += block;
  };
  for (std::size_t f = 0; f < 4; ++f) {
    for (std::size_t g = 0; g < 4; ++g) {
      const Eigen::Matrix3d mixed = mixed_slope(normals, f, g);
      for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t l = 0; l < 2; ++l) {
          Eigen::Matrix3d block = motions[f].unit[k].transpose() * mixed * motions[g].unit[l];
          if (f == g) block += bend_of(motions[f], slopes[f], k, l);
          add(row.arms[f][k], row.arms[g][l], scale * block);
        }
      }
    }
  }
  CurvatureBlocks<9, true> blocks;
  std::size_t next = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    for (std::size_t l = 0; l <= k; ++l) blocks[next++] = h[k][l];
  }
  return blocks;
}

double star_defect(const Positions& positions, std::span<const int> star) {
  if (star.size() < kFewest) return 0.0;
  const StarFaces faces(positions, star);
  const Triple triple = faces.widest();
  if (triple.is_flat()) return 0.0;
  double worst = 0.0;
  faces.for_each_other(triple, [&](std::size_t, double height) {
    const double angle = kDegreesOfRadian * std::abs(height) / triple.radius;
    if (!(angle <= worst)) worst = angle;
  });
  return worst;
}

void ConicalStar::append_rows(const Positions& positions, std::span<const int> star,
                              std::vector<Row>& out) {
  if (star.size() < kFewest) return;
  const StarFaces faces(positions, star);
  const Triple triple = faces.widest();
  if (triple.is_flat()) return;
  double mean = 0.0;
  for (std::size_t k = 0; k < faces.valence(); ++k) mean += faces.edge(k).norm();
  mean /= static_cast<double>(faces.valence());
  faces.for_each_other(triple, [&](std::size_t face, double) {
    out.push_back(row_of(faces, star[0], triple, face));
    out.back().scale = mean / triple.radius;
  });
}

double ConicalStar::excess(const Positions& positions, std::span<const int> star) {
  constexpr double kUnits = 16.0;  // four normals of two edges, each off by up to √3/2 ε |p| twice
  constexpr double kCoarsest = 1e-3;
  const double defect = measure(positions, star);
  if (defect == 0.0) return 0.0;
  const StarFaces faces(positions, star);
  double largest = 0.0;
  for (const int v : star) largest = std::max(largest, positions.col(v).cwiseAbs().maxCoeff());
  const double step = std::numeric_limits<double>::epsilon() * largest;
  const double least = faces.least_height() * faces.widest().radius;
  const bool is_rounding = defect <= std::min(kCoarsest, kDegreesOfRadian * kUnits * step / least);
  return is_rounding ? 0.0 : defect;
}

}  // namespace planish
