// SPDX-License-Identifier: MIT
/// Vertices on a surface: the part of VertexSlides that is about them. Each is on a plane along the
/// surface, at the height that it has in the base; the plane goes along with it until that height
/// is met. [SUP-4]
#include <cmath>

#include "planish/index.hpp"
#include "planish/vertex_slides.hpp"
#include "reference_surface.hpp"

namespace planish {

/// Where a displacement takes a vertex, model units.
Eigen::Vector3d VertexSlides::place_of(int vertex, const Eigen::Vector3d& d) const {
  return mesh_.positions.col(vertex) + unit_ * d;
}

void VertexSlides::add_feet(const PointSupport& support, const std::vector<int>& points) {
  const bool own = support.surface.points.empty();
  const auto surface =
      std::make_shared<const ReferenceSurface>(own ? mesh_ : to_mesh(support.surface));
  foot_of_.resize(at(mesh_.vertex_count()), -1);
  for (const int v : points) {
    Foot foot;
    foot.vertex = v;
    foot.others = track_of(v);
    foot.place = place_[at(v)];
    foot.surface = surface;
    const Eigen::Vector3d point = mesh_.positions.col(v);
    const SurfaceFoot found = surface->foot(point, surface->somewhere_near(point));
    foot.first = found.place;
    foot.normal = found.normal;
    foot.height = found.height / unit_;
    open(foot);
    foot_of_[at(v)] = static_cast<int>(feet_.size());
    feet_.push_back(std::move(foot));
  }
}

/// On the plane n · d = bound of its surface, within what other supports leave it.
void VertexSlides::touch(Foot& foot, const Eigen::Vector3d& normal, double bound) {
  constexpr double kSame = 1e-9;  // what the others forbid as well
  const SlideTrack& others = foot.others;
  const Eigen::Vector3d left = others.along * normal;
  const double length = left.norm();
  SlideTrack& track = tracks_[at(foot.place)];
  track = others;
  if (length <= kSame) return;
  const Eigen::Vector3d unit = left / length;
  track.along -= unit * unit.transpose();
  if (track.along.trace() < 0.5) track.along.setZero();
  track.offset += unit * ((bound - normal.dot(others.offset)) / length);
}

void VertexSlides::open(Foot& foot) {
  foot.turns = 0;
  foot.last = foot.first;
  touch(foot, foot.normal, foot.normal.dot(foot.others.offset));  // exactly where it stands
}

bool VertexSlides::follow(Foot& foot, const Eigen::Vector3d& d) {
  constexpr double kThere = 1e-4;  // mean edges: what files round away
  constexpr int kMostTurns = 24;
  const SurfaceFoot found = foot.surface->foot(place_of(foot.vertex, d), foot.last);
  foot.last = found.place;
  const double off = found.height / unit_ - foot.height;
  if (std::abs(off) <= kThere || ++foot.turns > kMostTurns) return false;
  touch(foot, found.normal, found.normal.dot(d) - off);
  return true;
}

bool VertexSlides::is_at_height(const Foot& foot, const Eigen::Vector3d& d) const {
  constexpr double kOnTrack = 1e-9;  // mean edges
  constexpr double kNear = 0.02;     // the same of the height: what is left of it is reported
  if (!((d - foot.others.nearest(d)).norm() <= kOnTrack)) return false;
  const SurfaceFoot found = foot.surface->foot(place_of(foot.vertex, d), foot.last);
  return std::abs(found.height / unit_ - foot.height) <= kNear;
}

}  // namespace planish
