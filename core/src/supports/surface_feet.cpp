// SPDX-License-Identifier: MIT
/// Vertices on a surface: the part of VertexSlides that is about them. Each has a row for every
/// side that it stands on, of that side to second order where it is and at the height that it has
/// in the base; the row goes along with it until that height is met. [SUP-4]
#include <algorithm>
#include <cmath>
#include <numeric>

#include "planish/numeric/index.hpp"
#include "planish/supports/vertex_slides.hpp"
#include "supports/reference_surface.hpp"

namespace planish {
namespace {

constexpr int kMostSteps = 8;  ///< onto all sides of a vertex
constexpr double kLeastLeft =
    1e-3;  ///< what is left of a normal that other supports forbid as well

}  // namespace

/// Where a displacement takes a vertex, model units.
Eigen::Vector3d VertexSlides::place_of(int vertex, const Eigen::Vector3d& d) const {
  return mesh_.positions.col(vertex) + unit_ * d;
}

/// The row of a point that is `height` too high with displacement `d`, solver units.
SurfaceRow VertexSlides::row_at(const SurfaceFoot& found, const Eigen::Vector3d& d,
                                double height) const {
  SurfaceRow row;
  row.centre = d;
  row.normal = found.height.gradient;
  row.bend = unit_ * found.height.curvature;
  row.height = height;
  return row;
}

void VertexSlides::add_feet(const PointSupport& support, const std::vector<int>& points) {
  const bool own = support.surface.points.empty();
  const auto surface =
      std::make_shared<const ReferenceSurface>(own ? mesh_ : to_mesh(support.surface));
  for (const int v : points) {
    const Eigen::Vector3d point = mesh_.positions.col(v);
    const SlideTrack* const others = track(v);
    for (const int side : surface->sides_at(point, kMostSurfaceRows)) {
      const SurfaceFoot found = surface->foot(point, side, surface->somewhere_near(point, side));
      const Eigen::Vector3d& normal = found.height.gradient;
      if (others != nullptr && (others->along * normal).norm() <= kLeastLeft) continue;
      Foot foot;
      foot.vertex = v;
      foot.surface = surface;
      foot.side = side;
      foot.first = found.place;
      foot.height = found.height.value / unit_;
      foot.base = row_at(found, Eigen::Vector3d::Zero(), 0.0);  // exactly where it stands
      feet_.push_back(std::move(foot));
    }
  }
}

/// Puts the feet of a vertex beside each other.
void VertexSlides::order_feet() {
  if (feet_.empty()) return;
  std::stable_sort(feet_.begin(), feet_.end(),
                   [](const Foot& a, const Foot& b) { return a.vertex < b.vertex; });
  first_foot_.assign(at(mesh_.vertex_count()) + 1, 0);
  for (const Foot& foot : feet_) ++first_foot_[at(foot.vertex) + 1];
  std::partial_sum(first_foot_.begin(), first_foot_.end(), first_foot_.begin());
  surface_rows_.resize(feet_.size());
  open_feet();
}

void VertexSlides::open_feet() {
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    feet_[k].turns = 0;
    feet_[k].last = feet_[k].first;
    surface_rows_[k] = feet_[k].base;
  }
}

bool VertexSlides::follow(Foot& foot, const Eigen::Vector3d& d, SurfaceRow& row) {
  constexpr double kThere = 1e-8;  // mean edges
  constexpr int kMostTurns = 24;
  if (d.isZero(0.0) && row.centre.isZero(0.0)) return false;
  const SurfaceFoot found = foot.surface->foot(place_of(foot.vertex, d), foot.side, foot.last);
  foot.last = found.place;
  const double off = found.height.value / unit_ - foot.height;
  if (std::abs(off) <= kThere || ++foot.turns > kMostTurns) return false;
  row = row_at(found, d, off);
  return true;
}

void VertexSlides::stand_on_surfaces(const Eigen::Matrix3Xd& displacement) {
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    Foot& foot = feet_[k];
    const Eigen::Vector3d d = displacement.col(foot.vertex);
    if (d.isZero(0.0)) continue;
    const SurfaceFoot found = foot.surface->foot(place_of(foot.vertex, d), foot.side, foot.last);
    foot.last = found.place;
    surface_rows_[k] = row_at(found, d, found.height.value / unit_ - foot.height);
  }
}

std::span<const SurfaceRow> VertexSlides::surface_rows(int vertex) const {
  const int first = first_foot_[at(vertex)], end = first_foot_[at(vertex) + 1];
  return std::span(surface_rows_).subspan(at(first), at(end - first));
}

bool VertexSlides::follow_surfaces(int vertex, const Eigen::Vector3d& d) {
  bool changed = false;
  for (int k = first_foot_[at(vertex)]; k < first_foot_[at(vertex) + 1]; ++k) {
    changed = follow(feet_[at(k)], d, surface_rows_[at(k)]) || changed;
  }
  return changed;
}

Eigen::Vector3d VertexSlides::on_surface(int vertex, const Eigen::Vector3d& d) const {
  const SlideTrack* const others = track(vertex);
  Eigen::Vector3d place = d;
  for (int step = 0; step < kMostSteps; ++step) {
    for (const SurfaceRow& row : surface_rows(vertex)) {
      Eigen::Vector3d way = gradient(row, place);
      if (others != nullptr) way = others->along * way;
      if (way.norm() <= kLeastLeft) continue;  // a keep-out holds it
      place -= (residual(row, place) / way.squaredNorm()) * way;
    }
  }
  return place;
}

bool VertexSlides::is_at_heights(int vertex, const Eigen::Vector3d& d) const {
  constexpr double kNear = 0.02;  // mean edges: what is left of a height is reported
  for (int k = first_foot_[at(vertex)]; k < first_foot_[at(vertex) + 1]; ++k) {
    const Foot& foot = feet_[at(k)];
    const SurfaceFoot found = foot.surface->foot(place_of(vertex, d), foot.side, foot.last);
    if (!(std::abs(found.height.value / unit_ - foot.height) <= kNear)) return false;
  }
  return true;
}

}  // namespace planish
