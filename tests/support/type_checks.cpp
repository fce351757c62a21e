// SPDX-License-Identifier: MIT
#include "support/type_checks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>

namespace planish::testing {
namespace {

Eigen::Matrix3Xd corners_of(const Mesh& mesh, int f) {
  const auto face = mesh.face(f);
  Eigen::Matrix3Xd corners(3, static_cast<Eigen::Index>(face.size()));
  for (std::size_t k = 0; k < face.size(); ++k) {
    corners.col(static_cast<Eigen::Index>(k)) = mesh.positions.col(face[k]);
  }
  return corners;
}

/// Outside, of the plane with the least squares from the corners.
Eigen::Vector3d normal_of(const Eigen::Matrix3Xd& corners) {
  const Eigen::Matrix3Xd about = corners.colwise() - Eigen::Vector3d(corners.rowwise().mean());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(about, Eigen::ComputeFullU);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < about.cols(); ++k) {
    area += Eigen::Vector3d(about.col(k)).cross(Eigen::Vector3d(about.col((k + 1) % about.cols())));
  }
  const Eigen::Vector3d normal = svd.matrixU().col(2);
  return normal.dot(area) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

/// Corners in coordinates of the panel's plane, seen from outside.
Eigen::Matrix2Xd in_plane(const Eigen::Matrix3Xd& corners, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
  Eigen::Matrix2Xd plane(2, corners.cols());
  for (Eigen::Index k = 0; k < corners.cols(); ++k) {
    const Eigen::Vector3d p = corners.col(k) - corners.col(0);
    plane.col(k) << x.dot(p), y.dot(p);
  }
  return plane;
}

/// The template's corners where they lie on a panel, by the singular values of the covariance.
Eigen::Matrix2Xd aligned(const Eigen::Matrix2Xd& from, const Eigen::Matrix2Xd& to) {
  const Eigen::Vector2d a = from.rowwise().mean(), b = to.rowwise().mean();
  const Eigen::Matrix2d covariance = (from.colwise() - a) * (to.colwise() - b).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix2d signs = Eigen::Matrix2d::Identity();
  signs(1, 1) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix2d turn = svd.matrixV() * signs * svd.matrixU().transpose();
  return (turn * (from.colwise() - a)).colwise() + b;
}

/// Its corners in the order in which they come at the panel's corners from `first` on.
Eigen::Matrix2Xd from_corner(const Eigen::Matrix2Xd& outline, Eigen::Index first, bool over) {
  const Eigen::Index k = outline.cols();
  Eigen::Matrix2Xd result(2, k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index j = over ? (first + k - i) % k : (first + i) % k;
    result.col(i) << outline(0, j), over ? -outline(1, j) : outline(1, j);
  }
  return result;
}

double largest_distance(const Eigen::Matrix2Xd& a, const Eigen::Matrix2Xd& b) {
  return (a - b).colwise().norm().maxCoeff();
}

double best_fit(const Eigen::Matrix2Xd& outline, const Eigen::Matrix2Xd& panel, bool mirrored) {
  double best = std::numeric_limits<double>::infinity();
  if (outline.cols() != panel.cols()) return best;
  for (Eigen::Index first = 0; first < panel.cols(); ++first) {
    for (int over = 0; over <= (mirrored ? 1 : 0); ++over) {
      const Eigen::Matrix2Xd from = from_corner(outline, first, over == 1);
      best = std::min(best, largest_distance(aligned(from, panel), panel));
    }
  }
  return best;
}

/// How far a point of the panel is outside the line from a to b of a template laid on it.
double outside(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d normal = Eigen::Vector2d(b.y() - a.y(), a.x() - b.x()).normalized();
  return normal.dot(point - a);
}

}  // namespace

PanelTypes types_of(const Mesh& mesh, const TypeOptions& options) {
  std::vector<FlatPanel> panels;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    panels.push_back(flatten_panel(mesh.positions, face, longest_side(mesh.positions, face)));
  }
  return find_panel_types(panels, joint_table(mesh), options);
}

PanelTypes types_within(const Mesh& mesh, double share, bool mirrored) {
  TypeOptions options;
  options.within = share * mean_edge_length(mesh);
  options.mirrored = mirrored;
  return types_of(mesh, options);
}

double worst_fit(const Mesh& mesh, const PanelTypes& types) {
  double worst = 0.0;
  for (const PanelType& type : types.types) {
    for (const int f : type.panels) {
      const Eigen::Matrix3Xd corners = corners_of(mesh, f);
      const Eigen::Matrix2Xd panel = in_plane(corners, normal_of(corners));
      worst = std::max(worst, best_fit(type.outline, panel, types.options.mirrored));
    }
  }
  return worst;
}

SeamCheck check_seams(const Mesh& mesh, const PanelTypes& types) {
  // How far each end of each side is outside its template, by the edge's two points.
  std::map<std::pair<int, int>, std::vector<std::pair<double, double>>> ends;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const Eigen::Matrix3Xd corners = corners_of(mesh, f);
    const Eigen::Matrix2Xd panel = in_plane(corners, normal_of(corners));
    const FamilyMember& member = types.panels[static_cast<std::size_t>(f)];
    const PanelType& type = types.types[static_cast<std::size_t>(member.family)];
    const Eigen::Matrix2Xd laid =
        aligned(from_corner(type.outline, member.first, member.mirrored), panel);
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t next = (k + 1) % face.size();
      const Eigen::Index i = static_cast<Eigen::Index>(k), j = static_cast<Eigen::Index>(next);
      const double here = outside(panel.col(i), laid.col(i), laid.col(j));
      const double there = outside(panel.col(j), laid.col(i), laid.col(j));
      const bool up = face[k] < face[next];
      ends[std::minmax(face[k], face[next])].emplace_back(up ? here : there, up ? there : here);
    }
  }
  const JointTable joints = joint_table(mesh);
  SeamCheck check{std::numeric_limits<double>::infinity(), 0.0, 0.0, 0};
  check.max = -check.min;
  for (const SeamWidth& seam : types.seams) {
    const Joint& joint = joints.joints[static_cast<std::size_t>(seam.joint)];
    const auto& sides = ends.at(std::minmax(joint.from, joint.to));
    EXPECT_EQ(sides.size(), 2u);
    const double a = types.designed + sides[0].first + sides[1].first;
    const double b = types.designed + sides[0].second + sides[1].second;
    check.min = std::min({check.min, a, b});
    check.max = std::max({check.max, a, b});
    check.error = std::max(
        {check.error, std::abs(std::min(a, b) - seam.min), std::abs(std::max(a, b) - seam.max)});
  }
  for (const auto& [edge, sides] : ends) check.seams += sides.size() == 2 ? 1 : 0;
  return check;
}

void expect_partition(const Mesh& mesh, const PanelTypes& types) {
  ASSERT_EQ(types.panels.size(), static_cast<std::size_t>(mesh.face_count()));
  std::set<int> seen;
  for (std::size_t t = 0; t < types.types.size(); ++t) {
    const std::vector<int>& panels = types.types[t].panels;
    EXPECT_FALSE(panels.empty());
    EXPECT_TRUE(std::is_sorted(panels.begin(), panels.end()));
    EXPECT_LE(panels.size(), types.types[t > 0 ? t - 1 : 0].panels.size());
    for (const int f : panels) {
      EXPECT_TRUE(seen.insert(f).second) << "panel " << f << " is in two types";
      EXPECT_EQ(types.panels[static_cast<std::size_t>(f)].family, static_cast<int>(t));
    }
  }
  EXPECT_EQ(seen.size(), types.panels.size());
}

Mesh renumbered(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> points(static_cast<std::size_t>(mesh.vertex_count()));
  std::vector<int> faces(static_cast<std::size_t>(mesh.face_count()));
  std::iota(points.begin(), points.end(), 0);
  std::iota(faces.begin(), faces.end(), 0);
  const auto shuffle = [&](std::vector<int>& list) {  // std::shuffle differs between libraries
    for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[random() % k]);
  };
  shuffle(points);
  shuffle(faces);
  Mesh result;
  result.positions.resize(3, mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    result.positions.col(points[static_cast<std::size_t>(v)]) = mesh.positions.col(v);
  }
  result.face_offsets = {0};
  for (const int f : faces) {
    const auto face = mesh.face(f);
    const std::size_t first = random() % face.size();
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int v = face[(first + k) % face.size()];
      result.face_vertices.push_back(points[static_cast<std::size_t>(v)]);
    }
    result.face_offsets.push_back(static_cast<int>(result.face_vertices.size()));
  }
  return result;
}

}  // namespace planish::testing
