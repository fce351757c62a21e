// SPDX-License-Identifier: MIT
#include "planish/constraints/planar_polygon.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "planish/constraints/vector_pair.hpp"

namespace planish {
namespace {

/// Adjugate of a symmetric 3 × 3 matrix: (A − θI)⁻¹ up to a factor that normalising removes.
Eigen::Matrix3d adjugate(const Eigen::Matrix3d& a) {
  Eigen::Matrix3d result;
  result.col(0) = a.col(1).cross(a.col(2));
  result.col(1) = a.col(2).cross(a.col(0));
  result.col(2) = a.col(0).cross(a.col(1));
  return result;
}

Eigen::Vector3d decomposed_direction(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  return solver.eigenvectors().col(0);
}

/// Index into `face` of the vertex that maximises `measure`.
template <class Measure>
std::size_t farthest(std::span<const int> face, const Measure& measure) {
  std::size_t best = 0;
  double largest = -1.0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const double value = measure(face[k]);
    if (value > largest) {
      largest = value;
      best = k;
    }
  }
  return best;
}

/// Doubled area, in mean edges squared, below which the scale of an equation stops growing.
constexpr double kLeastArea = 1e-9;

/// Reciprocal of an area, bounded so that a degenerate face gives a weak equation, not infinity.
double bounded_scale(double area, double extent) {
  constexpr double kSliver = 1e-6;
  const double floor = kSliver * extent * extent;
  return 1.0 / std::max({area, floor, std::numeric_limits<double>::min()});
}

/// mm/m that rounding leaves of a flat panel: half a unit in the last place per coordinate moves a
/// corner by up to √3/2 ε |p|, two corners apart, and as much again for the plane through them.
double rounding_mm_per_m(double largest_coordinate, double longest_edge) {
  constexpr double kUnits = 4.0;
  constexpr double kCoarsest = 1e-3;  // a panel that holds less is not called flat
  const double step = std::numeric_limits<double>::epsilon() * largest_coordinate;
  return std::min(kCoarsest, 1000.0 * kUnits * step / longest_edge);
}

}  // namespace

Eigen::Vector3d smallest_direction(const Eigen::Matrix3d& covariance,
                                   const Eigen::Vector3d& guess) {
  constexpr int kSteps = 3;
  constexpr double kAccuracy = 1e-13;
  const double size = covariance.trace();
  if (!(size > 0.0) || guess.isZero()) return decomposed_direction(covariance);
  Eigen::Vector3d n = guess;
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::Vector3d image = covariance * n;
    const double theta = n.dot(image);
    const Eigen::Matrix3d shifted = covariance - theta * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d adj = adjugate(shifted);
    if ((image - theta * n).norm() <= kAccuracy * size) {
      // θ is the smallest eigenvalue only if the other two of A − θI are positive: then both
      // their sum and their product (the trace of the adjugate) are.
      const bool smallest = shifted.trace() > 0.0 && adj.trace() > kAccuracy * size * size;
      return smallest ? n : decomposed_direction(covariance);
    }
    const Eigen::Vector3d next = adj * n;
    const double length = next.norm();
    if (!(length > 0.0) || !std::isfinite(length)) break;
    n = next / length;
  }
  return decomposed_direction(covariance);
}

void project_to_plane_centred(Eigen::Ref<Eigen::Matrix3Xd> points, Eigen::Vector3d& normal) {
  const Eigen::Vector3d mean = points.rowwise().mean();
  points.colwise() -= mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    covariance.noalias() += points.col(k) * points.col(k).transpose();
  }
  normal = smallest_direction(covariance, normal);
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    points.col(k) -= normal * normal.dot(points.col(k));
  }
}

namespace {

/// What the scale of a bent panel's equation follows: the doubled area of the panel, or of the
/// triangle that carries its plane, and an edge.
struct BentSize {
  FourPoints area_slope = FourPoints::Zero();
  FourPoints edge_slope = FourPoints::Zero();
  double area = 0.0, edge = 0.0;
};

/// The corners between which the sides of that area run: a quad's diagonals, or of the triangle.
std::array<int, 4> area_sides(const FlatnessEquation& equation) {
  return equation.is_quad ? std::array{0, 2, 1, 3} : std::array{0, 1, 0, 2};
}

BentSize bent_size(const FlatnessEquation& equation, const FourPoints& points) {
  const auto [a, b, c, d] = area_sides(equation);
  const Eigen::Vector3d first = points.col(b) - points.col(a);
  const Eigen::Vector3d second = points.col(d) - points.col(c);
  const Eigen::Vector3d normal = first.cross(second);
  const Eigen::Vector3d edge = points.col(1) - points.col(0);
  BentSize size;
  size.area = normal.norm();
  size.edge = edge.norm();
  const Eigen::Vector3d unit = normal / size.area;
  size.area_slope.col(b) += second.cross(unit);
  size.area_slope.col(a) -= second.cross(unit);
  size.area_slope.col(d) += unit.cross(first);
  size.area_slope.col(c) -= unit.cross(first);
  size.edge_slope.col(1) = edge / size.edge;
  size.edge_slope.col(0) = -edge / size.edge;
  return size;
}

using SizeHessian = Eigen::Matrix<double, 12, 12>;

/// ∂²(area · edge) / (area · edge).
SizeHessian bent_size_curvature(const FlatnessEquation& equation, const FourPoints& points) {
  const BentSize size = bent_size(equation, points);
  const auto [a, b, c, d] = area_sides(equation);
  const Eigen::Vector3d first = points.col(b) - points.col(a);
  const Eigen::Vector3d second = points.col(d) - points.col(c);
  const Eigen::Vector3d normal = first.cross(second) / size.area;
  const Eigen::Vector3d along = (points.col(1) - points.col(0)) / size.edge;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  // ∂(first × second) by each of them.
  const Eigen::Matrix3d by_first = -cross_matrix(second);
  const Eigen::Matrix3d by_second = cross_matrix(first);
  const Eigen::Matrix3d mixed =
      by_first.transpose() * across * by_second / size.area - cross_matrix(normal);
  Eigen::Matrix<double, 3, 12> side = Eigen::Matrix<double, 3, 12>::Zero();
  Eigen::Matrix<double, 3, 12> other = side;
  Eigen::Matrix<double, 3, 12> edge = side;
  side.middleCols<3>(3 * b) += Eigen::Matrix3d::Identity();
  side.middleCols<3>(3 * a) -= Eigen::Matrix3d::Identity();
  other.middleCols<3>(3 * d) += Eigen::Matrix3d::Identity();
  other.middleCols<3>(3 * c) -= Eigen::Matrix3d::Identity();
  edge.middleCols<3>(3) += Eigen::Matrix3d::Identity();
  edge.middleCols<3>(0) -= Eigen::Matrix3d::Identity();
  const SizeHessian cross = side.transpose() * mixed * other;
  const Eigen::Map<const Eigen::Matrix<double, 12, 1>> area_slope(size.area_slope.data());
  const Eigen::Map<const Eigen::Matrix<double, 12, 1>> edge_slope(size.edge_slope.data());
  const SizeHessian product = area_slope * edge_slope.transpose();
  const Eigen::Matrix3d turning = Eigen::Matrix3d::Identity() - along * along.transpose();
  SizeHessian area = cross + cross.transpose();
  area += side.transpose() * (by_first.transpose() * across * by_first / size.area) * side;
  area += other.transpose() * (by_second.transpose() * across * by_second / size.area) * other;
  return area / size.area + (product + product.transpose()) / (size.area * size.edge) +
         edge.transpose() * turning * edge / (size.edge * size.edge);
}

}  // namespace

FlatnessEquation bent_equation(const Positions& positions, FlatnessEquation equation,
                               bool is_quad) {
  const auto length = [&](std::size_t k) {
    return (positions.col(equation.vertices[(k + 1) % 4]) - positions.col(equation.vertices[k]))
        .norm();
  };
  // A bend is measured by the longest edge.
  std::size_t longest = 0;
  for (std::size_t k = 1; is_quad && k < 4; ++k) {
    if (length(k) > length(longest)) longest = k;
  }
  std::rotate(equation.vertices.begin(), equation.vertices.begin() + longest,
              equation.vertices.end());
  equation.is_quad = is_quad;
  equation.edge = length(0);
  equation.bend = residual(equation, positions(Eigen::all, equation.vertices));
  return equation;
}

double scale_at(const FlatnessEquation& equation, const FourPoints& points) {
  if (equation.edge > 0.0) {
    const BentSize size = bent_size(equation, points);
    return equation.edge / (size.area * size.edge);
  }
  if (equation.least_area <= 0.0) return equation.scale;
  const Eigen::Vector3d b = points.col(1) - points.col(0);
  const Eigen::Vector3d c = points.col(2) - points.col(0);
  return 1.0 / std::max(b.cross(c).norm(), equation.least_area);
}

double residual(const FlatnessEquation& equation, const FourPoints& points) {
  const Eigen::Vector3d b = points.col(1) - points.col(0);
  const Eigen::Vector3d c = points.col(2) - points.col(0);
  const Eigen::Vector3d d = points.col(3) - points.col(0);
  return scale_at(equation, points) * b.cross(c).dot(d) - equation.bend;
}

FourPoints gradient(const FlatnessEquation& equation, const FourPoints& points) {
  const Eigen::Vector3d b = points.col(1) - points.col(0);
  const Eigen::Vector3d c = points.col(2) - points.col(0);
  const Eigen::Vector3d d = points.col(3) - points.col(0);
  const double scale = scale_at(equation, points);
  const Eigen::Vector3d normal = b.cross(c);
  FourPoints result;
  result.col(1) = scale * c.cross(d);
  result.col(2) = scale * d.cross(b);
  result.col(3) = scale * normal;
  if (equation.edge > 0.0) {
    const BentSize size = bent_size(equation, points);
    result.col(0) = -(result.col(1) + result.col(2) + result.col(3));
    const double distance = scale * normal.dot(d);
    return result - distance * (size.area_slope / size.area + size.edge_slope / size.edge);
  }
  if (equation.least_area > 0.0 && scale * equation.least_area < 1.0) {
    // c = det / |b × c|: the quotient's second term, −c ∇|b × c| / |b × c|.
    const Eigen::Vector3d unit = scale * normal;
    const double share = scale * unit.dot(d);
    result.col(1) -= share * c.cross(unit);
    result.col(2) -= share * unit.cross(b);
  }
  result.col(0) = -(result.col(1) + result.col(2) + result.col(3));
  return result;
}

CurvatureBlocks<4, true> hessian(const FlatnessEquation& equation, const FourPoints& points) {
  const double scale = scale_at(equation, points);
  const Eigen::Matrix3d b = scale * cross_matrix(points.col(1) - points.col(0));
  const Eigen::Matrix3d c = scale * cross_matrix(points.col(2) - points.col(0));
  const Eigen::Matrix3d d = scale * cross_matrix(points.col(3) - points.col(0));
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
  // ∂(d × b)/∂b = [d]×, ∂(b × c)/∂b = −[c]×, ∂(b × c)/∂c = [b]×; the blocks of vertex 0 follow
  // because moving all four points together changes nothing.
  const Eigen::Matrix3d& h21 = d;
  const Eigen::Matrix3d h31 = -c;
  const Eigen::Matrix3d& h32 = b;
  const Eigen::Matrix3d h10 = -(h21.transpose() + h31.transpose());
  const Eigen::Matrix3d h20 = -(h21 + h32.transpose());
  const Eigen::Matrix3d h30 = -(h31 + h32);
  CurvatureBlocks<4, true> blocks{none, h10, none, h20, h21, none, h30, h31, h32, none};
  if (equation.edge > 0.0) {
    const double distance = residual(equation, points) + equation.bend;
    const SizeHessian size = bent_size_curvature(equation, points);
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l <= k; ++l) {
        blocks[block_index<FlatnessEquation>(k, l)] -= distance * size.block<3, 3>(3 * k, 3 * l);
      }
    }
  }
  return blocks;
}

namespace {

/// The diagonals carry a quad's plane: the residual is then the distance between them. On a quad
/// without area (a line, a point, a bow-tie) that scale would be boundless, so there the scale
/// follows the triangle of the first three vertices as the quad opens.
FlatnessEquation quad_equation(const Positions& positions, std::span<const int> face) {
  const Eigen::Vector3d first = positions.col(face[2]) - positions.col(face[0]);
  const Eigen::Vector3d second = positions.col(face[3]) - positions.col(face[1]);
  const double extent = std::max(first.norm(), second.norm());
  const double area = first.cross(second).norm();
  const double scale = bounded_scale(area, extent);
  const double least_area = area * scale < 1.0 ? std::max(1.0 / scale, kLeastArea) : 0.0;
  return {{face[0], face[1], face[2], face[3]}, scale, least_area};
}

}  // namespace

std::array<std::size_t, 3> spread_corners(const Positions& positions, std::span<const int> face) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int v : face) mean += positions.col(v) / static_cast<double>(face.size());
  const auto point = [&](std::size_t k) -> Eigen::Vector3d { return positions.col(face[k]); };
  const std::size_t a =
      farthest(face, [&](int v) { return (positions.col(v) - mean).squaredNorm(); });
  // A vertex that is taken already never wins, not even where all measures are zero.
  const std::size_t b = farthest(face, [&](int v) {
    return v == face[a] ? -1.0 : (positions.col(v) - point(a)).squaredNorm();
  });
  const Eigen::Vector3d side = point(b) - point(a);
  const std::size_t c = farthest(face, [&](int v) {
    const Eigen::Vector3d arm = positions.col(v) - point(a);
    return v == face[a] || v == face[b] ? -1.0 : side.cross(arm).squaredNorm();
  });
  return {a, b, c};
}

void append_flatness_equations(const Positions& positions, std::span<const int> face,
                               std::vector<FlatnessEquation>& out) {
  if (face.size() < 4) return;
  if (face.size() == 4) {
    out.push_back(quad_equation(positions, face));
    return;
  }
  const auto [a, b, c] = spread_corners(positions, face);
  const Eigen::Vector3d side = positions.col(face[b]) - positions.col(face[a]);
  const Eigen::Vector3d arm = positions.col(face[c]) - positions.col(face[a]);
  const double scale = bounded_scale(side.cross(arm).norm(), side.norm());
  constexpr double kLeastShare = 1e-3;  // of the carrying triangle, before the scale stops growing
  for (std::size_t k = 0; k < face.size(); ++k) {
    if (k != a && k != b && k != c)
      out.push_back({{face[a], face[b], face[c], face[k]}, scale, kLeastShare / scale});
  }
}

FacePlanarity face_planarity(const Positions& positions, std::span<const int> face) {
  if (face.size() < 4) return {};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  // Relative to the first vertex: far from the origin the mean itself would round too coarsely.
  const Eigen::Vector3d origin = positions.col(face[0]);
  for (const int v : face) mean += positions.col(v) - origin;
  mean /= static_cast<double>(face.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double longest = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    largest = std::max(largest, positions.col(face[k]).cwiseAbs().maxCoeff());
    const Eigen::Vector3d here = positions.col(face[k]) - origin;
    const Eigen::Vector3d next = positions.col(face[(k + 1) % face.size()]) - origin;
    longest = std::max(longest, (next - here).norm());
    covariance.noalias() += (here - mean) * (here - mean).transpose();
  }
  if (!(longest > 0.0)) return {};
  covariance /= longest * longest;  // the decomposition must not underflow on tiny models
  const Eigen::Vector3d first = positions.col(face[2]) - origin;
  const Eigen::Vector3d second = positions.col(face[3]) - positions.col(face[1]);
  const Eigen::Vector3d guess = first.cross(second).stableNormalized();
  const Eigen::Vector3d normal = smallest_direction(covariance, guess);
  double low = 0.0;
  double high = 0.0;
  for (const int v : face) {
    const Eigen::Vector3d here = positions.col(v) - origin;
    const double distance = normal.dot(here - mean);
    low = std::min(low, distance);
    high = std::max(high, distance);
  }
  const double mm_per_m = 1000.0 * (high - low) / longest;
  const bool is_rounding = mm_per_m <= rounding_mm_per_m(largest, longest);  // false for NaN
  return {high - low, mm_per_m, is_rounding ? 0.0 : mm_per_m};
}

}  // namespace planish
