// SPDX-License-Identifier: MIT
#include "supports/surface_sites.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/edge_table.hpp"
#include "numeric/disjoint_sets.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Of each panel, a number that the panels of its side share: those across an edge, less than 30°
/// away.
std::vector<int> sides_of(const Mesh& mesh, const Eigen::Matrix3Xd& areas) {
  constexpr double kLeastCosine = 0.866025403784438647;  // of 30°
  const Eigen::Matrix3Xd normals = areas.colwise().normalized();
  DisjointSets sets(mesh.face_count());
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (std::size_t k = 1; k < uses.size(); ++k) {
    const EdgeUse &a = uses[k - 1], &b = uses[k];
    if (a.low != b.low || a.high != b.high) continue;
    if (normals.col(a.face).dot(normals.col(b.face)) >= kLeastCosine) sets.unite(a.face, b.face);
  }
  std::vector<int> sides(at(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) sides[at(f)] = sets.find(f);
  return sides;
}

Eigen::Matrix3Xd areas_of(const Mesh& mesh) {
  Eigen::Matrix3Xd areas(3, mesh.face_count());
  for (int f = 0; f < mesh.face_count(); ++f) {
    areas.col(f) = area_vector(mesh.positions, mesh.face(f));
  }
  return areas;
}

}  // namespace

/// Σ w q and Σ w of the sites around a place, with their derivatives.
struct SurfaceSites::Sum {
  double value = 0.0, weight = 0.0;
  Eigen::Vector3d value_slope = Eigen::Vector3d::Zero(), weight_slope = Eigen::Vector3d::Zero();
  Eigen::Matrix3d value_bend = Eigen::Matrix3d::Zero(), weight_bend = Eigen::Matrix3d::Zero();
};

SurfaceSites::SurfaceSites(const Mesh& mesh) {
  const Eigen::Matrix3Xd areas = areas_of(mesh);
  sides_ = sides_of(mesh, areas);
  place_sites(mesh);
  join_sites();
  std::vector<Eigen::Vector3d> normals(sites_.size(), Eigen::Vector3d::Zero());
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int s : corners_[f]) normals[at(s)] += areas.col(f);
  }
  for (std::size_t s = 0; s < sites_.size(); ++s) {
    fit(static_cast<int>(s), normals[s].normalized());
  }
}

/// Places one site for each point and side that it is part of.
void SurfaceSites::place_sites(const Mesh& mesh) {
  std::vector<std::vector<std::pair<int, int>>> of_vertex(at(mesh.vertex_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) {
      auto& known = of_vertex[at(v)];
      auto found = std::find_if(known.begin(), known.end(),
                                [&](const auto& one) { return one.first == sides_[at(f)]; });
      if (found == known.end()) {
        found = known.insert(known.end(), {sides_[at(f)], static_cast<int>(sites_.size())});
        sites_.emplace_back().point = mesh.positions.col(v);
      }
      corners_.values.push_back(found->second);
    }
    corners_.offsets.push_back(static_cast<int>(corners_.values.size()));
  }
}

void SurfaceSites::join_sites() {
  std::vector<std::vector<int>> beside(sites_.size());
  for (int f = 0; f < corners_.size(); ++f) {
    for (const int a : corners_[f]) {
      for (const int b : corners_[f]) {
        if (a != b) beside[at(a)].push_back(b);
      }
    }
  }
  for (std::vector<int>& others : beside) {
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    neighbours_.values.insert(neighbours_.values.end(), others.begin(), others.end());
    neighbours_.offsets.push_back(static_cast<int>(neighbours_.values.size()));
  }
}

/// The sites beside one, and beside these.
std::vector<int> SurfaceSites::around(int site) const {
  std::vector<int> found(neighbours_[site].begin(), neighbours_[site].end());
  for (const int other : neighbours_[site]) {
    for (const int further : neighbours_[other]) {
      if (further != site) found.push_back(further);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// z = a x + b y + ½ (c x² + 2 d x y + e y²) over the plane at right angles to `normal`, by least
/// squares; scaled to rise by the distance from it.
void SurfaceSites::fit(int number, const Eigen::Vector3d& normal) {
  constexpr double kReach = 2.5;         // mean distances to the neighbours
  constexpr double kLeastCurved = 1e-6;  // of a square: what too few points leave open is flat
  using Five = Eigen::Matrix<double, 5, 1>;
  Site& site = sites_[at(number)];
  double mean = 0.0;
  for (const int s : neighbours_[number]) mean += (sites_[at(s)].point - site.point).norm();
  mean /= std::max(1.0, static_cast<double>(neighbours_[number].size()));
  site.reach = kReach * mean;
  site.slope = normal;
  if (!(mean > 0.0)) return;
  const Eigen::Vector3d across = normal.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> frame;
  frame << across, normal.cross(across);
  Eigen::Matrix<double, 5, 5> squares = kLeastCurved * Eigen::Matrix<double, 5, 5>::Identity();
  Five right = Five::Zero();
  for (const int s : around(number)) {
    const Eigen::Vector3d way = (sites_[at(s)].point - site.point) / mean;
    const Eigen::Vector2d p = frame.transpose() * way;
    const Five row{p[0], p[1], 0.5 * p[0] * p[0], p[0] * p[1], 0.5 * p[1] * p[1]};
    squares += row * row.transpose();
    right += normal.dot(way) * row;
  }
  const Five z = squares.ldlt().solve(right);
  Eigen::Matrix2d bend;
  bend << z[2], z[3], z[3], z[4];
  const double length = std::sqrt(1.0 + z[0] * z[0] + z[1] * z[1]);
  site.slope = (normal - frame * z.head<2>()) / length;
  site.bend = frame * bend * frame.transpose() / (-length * mean);
}

/// Adds a site with its weight (1 − r²)³, r the distance in reaches.
void SurfaceSites::add(const Site& site, const Eigen::Vector3d& place, Sum& sum) {
  const Eigen::Vector3d way = place - site.point;
  const double scale = 1.0 / (site.reach * site.reach);
  const double left = 1.0 - scale * way.squaredNorm();
  if (left <= 0.0) return;
  const double weight = left * left * left;
  const Eigen::Vector3d weight_slope = (-6.0 * scale * left * left) * way;
  const Eigen::Matrix3d weight_bend = (24.0 * scale * scale * left) * way * way.transpose() -
                                      6.0 * scale * left * left * Eigen::Matrix3d::Identity();
  const double value = (site.slope + 0.5 * site.bend * way).dot(way);
  const Eigen::Vector3d slope = site.slope + site.bend * way;
  const Eigen::Matrix3d mixed = weight_slope * slope.transpose();
  sum.weight += weight;
  sum.weight_slope += weight_slope;
  sum.weight_bend += weight_bend;
  sum.value += weight * value;
  sum.value_slope += weight * slope + value * weight_slope;
  sum.value_bend += weight * site.bend + value * weight_bend + mixed + mixed.transpose();
}

SurfaceHeight SurfaceSites::height(int panel, const Eigen::Vector3d& place) const {
  Sum sum;
  std::vector<int> sites(corners_[panel].begin(), corners_[panel].end());
  for (std::size_t k = 0; k < sites.size(); ++k) {  // it grows: what is within reach has neighbours
    const Site& site = sites_[at(sites[k])];
    const bool beyond = (place - site.point).squaredNorm() >= site.reach * site.reach;
    if (beyond && k >= corners_[panel].size()) continue;
    add(site, place, sum);
    for (const int s : neighbours_[sites[k]]) {
      if (std::find(sites.begin(), sites.end(), s) == sites.end()) sites.push_back(s);
    }
  }
  SurfaceHeight result;
  if (!(sum.weight > 0.0)) {  // far from all: the plane of the nearest
    const auto nearer = [&](int a, int b) {
      return (place - sites_[at(a)].point).squaredNorm() <
             (place - sites_[at(b)].point).squaredNorm();
    };
    const Site& site = sites_[at(*std::min_element(sites.begin(), sites.end(), nearer))];
    result.value = site.slope.dot(place - site.point);
    result.gradient = site.slope;
    return result;
  }
  result.value = sum.value / sum.weight;
  result.gradient = (sum.value_slope - result.value * sum.weight_slope) / sum.weight;
  const Eigen::Matrix3d mixed = result.gradient * sum.weight_slope.transpose();
  result.curvature =
      (sum.value_bend - result.value * sum.weight_bend - mixed - mixed.transpose()) / sum.weight;
  return result;
}

}  // namespace planish
