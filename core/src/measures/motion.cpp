// SPDX-License-Identifier: MIT
#include "planish/measures/motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "numeric/trigonometry.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/mesh/mean_normal.hpp"

namespace planish {
namespace {

/// The place of a panel that is nearest to some point.
struct NearestPlace {
  double squared = std::numeric_limits<double>::infinity();  ///< its distance from the point
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();             ///< from the point to it
  int face = -1;
  int first = -1,
      second = -1;  ///< vertices: both −1 within the panel, the ends of an edge, a corner
  [[nodiscard]] bool is_corner() const { return first >= 0 && second < 0; }
};

/// The base, asked for the feet of points.
class OldSurface {
 public:
  OldSurface(const Mesh& mesh, const Adjacency& adjacency) : mesh_(mesh), adjacency_(adjacency) {}

  [[nodiscard]] PointMotion motion(int vertex, const Eigen::Vector3d& point);

 private:
  [[nodiscard]] NearestPlace walk(int vertex, const Eigen::Vector3d& point);
  void look_around(int vertex, const Eigen::Vector3d& point, NearestPlace& nearest);
  void look_at(int face, const Eigen::Vector3d& point, NearestPlace& nearest) const;
  void look_at_edge(int face, int a, int b, const Eigen::Vector3d& point,
                    NearestPlace& nearest) const;
  [[nodiscard]] bool covers(std::span<const int> face, const Eigen::Vector3d& normal,
                            const Eigen::Vector3d& place) const;
  [[nodiscard]] Eigen::Vector3d normal_of(int face) const {
    return area_vector(mesh_.positions, mesh_.face(face)).stableNormalized();
  }
  [[nodiscard]] std::vector<int> faces_at_edge(int a, int b) const;
  [[nodiscard]] double angle_at(int face, int vertex) const;
  [[nodiscard]] Eigen::Vector3d normal_at(const NearestPlace& place) const;
  [[nodiscard]] bool is_on_border(const NearestPlace& place) const;

  const Mesh& mesh_;
  const Adjacency& adjacency_;
  std::vector<int> passed_;  ///< panels that the walk has looked at
};

/// Whether `place`, in the panel's plane, is inside of its outline, by the parity of crossings.
bool OldSurface::covers(std::span<const int> face, const Eigen::Vector3d& normal,
                        const Eigen::Vector3d& place) const {
  Eigen::Index along = 0;
  normal.cwiseAbs().maxCoeff(&along);
  const Eigen::Index u = (along + 1) % 3, v = (along + 2) % 3;
  bool inside = false;
  Eigen::Vector3d a = mesh_.positions.col(face.back()) - place;
  for (const int corner : face) {
    const Eigen::Vector3d b = mesh_.positions.col(corner) - place;
    if ((a[v] > 0.0) != (b[v] > 0.0) && a[u] - a[v] * (b[u] - a[u]) / (b[v] - a[v]) > 0.0) {
      inside = !inside;
    }
    a = b;
  }
  return inside;
}

void OldSurface::look_at_edge(int face, int a, int b, const Eigen::Vector3d& point,
                              NearestPlace& nearest) const {
  const Eigen::Vector3d start = mesh_.positions.col(a) - point;
  const Eigen::Vector3d edge = mesh_.positions.col(b) - mesh_.positions.col(a);
  const double length = edge.squaredNorm();
  const double share = length > 0.0 ? -start.dot(edge) / length : 0.0;
  NearestPlace place{.face = face, .first = a, .second = -1};
  if (share <= 0.0) {
    place.arm = start;
  } else if (share >= 1.0) {
    place.arm = mesh_.positions.col(b) - point;
    place.first = b;
  } else {
    place.arm = start + share * edge;
    place.second = b;
  }
  place.squared = place.arm.squaredNorm();
  if (place.squared < nearest.squared) nearest = place;
}

void OldSurface::look_at(int face, const Eigen::Vector3d& point, NearestPlace& nearest) const {
  const auto corners = mesh_.face(face);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int v : corners) middle += mesh_.positions.col(v) - point;
  middle /= static_cast<double>(corners.size());
  const Eigen::Vector3d normal = normal_of(face);
  const double height = normal.dot(middle);
  const bool is_nearer = height * height < nearest.squared;
  if (!normal.isZero(0.0) && !is_nearer) return;  // no place of a flat panel is
  if (is_nearer && covers(corners, normal, point + height * normal)) {
    nearest = {.squared = height * height, .arm = height * normal, .face = face};
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    look_at_edge(face, corners[k], corners[(k + 1) % corners.size()], point, nearest);
  }
}

/// Looks at all panels around a vertex that were not passed yet.
void OldSurface::look_around(int vertex, const Eigen::Vector3d& point, NearestPlace& nearest) {
  for (const int face : adjacency_.faces[vertex]) {
    if (std::find(passed_.begin(), passed_.end(), face) != passed_.end()) continue;
    passed_.push_back(face);
    look_at(face, point, nearest);
  }
}

NearestPlace OldSurface::walk(int vertex, const Eigen::Vector3d& point) {
  passed_.clear();
  NearestPlace nearest;
  look_around(vertex, point, nearest);
  for (int here = -1; nearest.face != here;) {
    here = nearest.face;
    for (const int corner : mesh_.face(here)) look_around(corner, point, nearest);
  }
  return nearest;
}

std::vector<int> OldSurface::faces_at_edge(int a, int b) const {
  std::vector<int> faces;
  for (const int face : adjacency_.faces[a]) {
    const auto corners = mesh_.face(face);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const int here = corners[k], next = corners[(k + 1) % corners.size()];
      if ((here == a && next == b) || (here == b && next == a)) faces.push_back(face);
    }
  }
  return faces;
}

/// The angle inside the panel, radians, 0 … 2π.
double OldSurface::angle_at(int face, int vertex) const {
  const auto corners = mesh_.face(face);
  const auto place = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
  const auto k = static_cast<std::size_t>(place);
  const auto at = [&](std::size_t corner) -> Eigen::Vector3d {
    return mesh_.positions.col(corners[corner % corners.size()]) - mesh_.positions.col(vertex);
  };
  const Eigen::Vector3d next = at(k + 1), previous = at(k + corners.size() - 1);
  const double angle = arctangent(normal_of(face).dot(next.cross(previous)), next.dot(previous));
  return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

/// The normal, of length 1; 0 where the panels have no area or cancel out.
Eigen::Vector3d OldSurface::normal_at(const NearestPlace& place) const {
  if (place.first < 0) return normal_of(place.face);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (place.is_corner()) {
    for (const int face : adjacency_.faces[place.first]) {
      sum += angle_at(face, place.first) * normal_of(face);
    }
  } else {
    for (const int face : faces_at_edge(place.first, place.second)) sum += normal_of(face);
  }
  return sum.stableNormalized();
}

bool OldSurface::is_on_border(const NearestPlace& place) const {
  if (place.first < 0) return false;
  if (place.is_corner()) return adjacency_.boundary[static_cast<std::size_t>(place.first)] != 0;
  return faces_at_edge(place.first, place.second).size() == 1;
}

PointMotion OldSurface::motion(int vertex, const Eigen::Vector3d& point) {
  const auto around = adjacency_.faces[vertex];
  const Eigen::Vector3d move = point - mesh_.positions.col(vertex);
  const double slide = across(move, mean_normal(mesh_, mesh_.positions, around)).norm();
  if (around.empty()) return {.shape = 0.0, .slide = slide};
  const NearestPlace nearest = walk(vertex, point);
  const double height = -normal_at(nearest).dot(nearest.arm);
  if (is_on_border(nearest)) return {.shape = height, .slide = slide};
  const double distance = nearest.arm.norm();
  return {.shape = height < 0.0 ? -distance : distance, .slide = slide};
}

}  // namespace

std::vector<PointMotion> motions(const Mesh& base, const Adjacency& adjacency,
                                 std::span<const int> moved, const Positions& after) {
  OldSurface surface(base, adjacency);
  std::vector<PointMotion> found;
  found.reserve(moved.size());
  for (const int v : moved) found.push_back(surface.motion(v, after.col(v)));
  return found;
}

MotionRange range_of(std::span<const PointMotion> motions) {
  MotionRange range;
  for (const PointMotion& one : motions) {
    range.raised = std::max(range.raised, one.shape);
    range.lowered = std::max(range.lowered, -one.shape);
    range.slide = std::max(range.slide, one.slide);
  }
  return range;
}

}  // namespace planish
