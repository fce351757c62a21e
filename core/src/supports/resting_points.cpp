// SPDX-License-Identifier: MIT
/// The points that a keep-out holds: the part of VertexSlides that is about them. [KEE-2]
#include <algorithm>
#include <array>
#include <utility>

#include "planish/numeric/index.hpp"
#include "planish/supports/vertex_slides.hpp"

namespace planish {
namespace {

constexpr double kDeeper = 1e-11;  ///< mean edges

/// P of what `along` leaves and a plane with that normal does, too.
Eigen::Matrix3d within_plane(const Eigen::Matrix3d& along, const Eigen::Vector3d& normal) {
  constexpr double kSame = 1e-9;  // what is forbidden already
  const Eigen::Vector3d left = along * normal;
  const double length = left.norm();
  if (length <= kSame) return along;
  const Eigen::Vector3d unit = left / length;
  const Eigen::Matrix3d rest = along - unit * unit.transpose();
  return rest.trace() < 0.5 ? Eigen::Matrix3d::Zero() : rest;
}

}  // namespace

void VertexSlides::rest(std::vector<RestingPoint> points) {
  std::stable_sort(points.begin(), points.end(), [](const RestingPoint& a, const RestingPoint& b) {
    return a.vertex < b.vertex;
  });
  for (const RestingPoint& point : points) {
    const SlideTrack& track = track_of(point.vertex);
    const std::size_t place = at(place_[at(point.vertex)]);
    if (place < runner_of_.size() && runner_of_[place] >= 0) {
      Runner& runner = runners_[at(runner_of_[place])];
      runner.others.along = within_plane(runner.others.along, point.normal);
      open(runner);
    } else {
      rests_.push_back({point, track.along});
    }
  }
}

Eigen::Vector3d VertexSlides::nearest(int vertex, const Eigen::Vector3d& d) const {
  const SlideTrack* const own = track(vertex);
  return own == nullptr ? d : own->nearest(d);
}

void VertexSlides::let_all_go() {
  for (const int k : held_) {
    rests_[at(k)].releases = 0;
    set_held(rests_[at(k)], false);
  }
  held_.clear();
}

void VertexSlides::forget_releases() {
  for (const int k : held_) rests_[at(k)].releases = 0;
}

std::span<const VertexSlides::Rest> VertexSlides::rests_of(int vertex) const {
  const auto first =
      std::lower_bound(rests_.begin(), rests_.end(), vertex,
                       [](const Rest& rest, int v) { return rest.point.vertex < v; });
  auto last = first;
  while (last != rests_.end() && last->point.vertex == vertex) ++last;
  // Emscripten 3.1.6 makes no span of two iterators.
  return {rests_.data() + (first - rests_.begin()), static_cast<std::size_t>(last - first)};
}

std::span<VertexSlides::Rest> VertexSlides::rests_of(int vertex) {
  const std::span<const Rest> rests = std::as_const(*this).rests_of(vertex);
  return {rests_.data() + (rests.data() - rests_.data()), rests.size()};
}

/// Every plane that holds the point, and its supports.
void VertexSlides::set_held(Rest& rest, bool held) {
  rest.held = held;
  Eigen::Matrix3d along = rest.supports;
  for (const Rest& one : rests_of(rest.point.vertex)) {
    if (one.held) along = within_plane(along, one.point.normal);
  }
  track_of(rest.point.vertex).along = along;
}

bool VertexSlides::hold_deeper(std::span<const int> vertices,
                               const Eigen::Matrix3Xd& displacement) {
  bool changed = false;
  for (std::size_t k = 0; k < vertices.size() && !rests_.empty(); ++k) {
    const Eigen::Vector3d d = displacement.col(static_cast<Eigen::Index>(k));
    for (Rest& rest : rests_of(vertices[k])) {
      if (rest.held || rest.point.normal.dot(d) >= -kDeeper) continue;
      const auto place = static_cast<int>(&rest - rests_.data());
      if (std::find(held_.begin(), held_.end(), place) == held_.end()) held_.push_back(place);
      set_held(rest, true);
      changed = true;
    }
  }
  return changed;
}

Eigen::Vector3d VertexSlides::left_of(int vertex, const Eigen::Vector3d& force) const {
  constexpr int kSweeps = 32;
  const std::span<const Rest> rests = rests_of(vertex);
  if (rests.empty()) return place_[at(vertex)] < 0 ? force : track(vertex)->along * force;
  const Eigen::Matrix3d& supports = rests.front().supports;
  Eigen::Vector3d left = supports * force;
  std::vector<double> pushes(rests.size(), 0.0);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t k = 0; k < rests.size(); ++k) {
      const Eigen::Vector3d normal = supports * rests[k].point.normal;
      const double square = normal.squaredNorm();
      if (!rests[k].held || square <= 1e-18) continue;
      const double push = std::max(0.0, pushes[k] - left.dot(normal) / square);
      left += (push - pushes[k]) * normal;
      pushes[k] = push;
    }
    if (rests.size() == 1) break;
  }
  return left;
}

/// Lets go of all that are pulled away the first time; then of the one that is pulled most: several
/// that go to and fro together would go on for ever.
bool VertexSlides::release(std::span<const TrackForce> forces, double rest) {
  constexpr int kMostReleases = 4;  // then it is held
  constexpr double kNothing = 1e-5;
  bool changed = false;
  Rest* most_pulled = nullptr;
  double most = kNothing;
  for (const TrackForce& one : forces) {
    const bool moves = one.most <= 0.0 || one.displacement.norm() > rest;
    const Eigen::Vector3d left = left_of(one.vertex, one.force(moves));
    if (!moves && left.norm() <= one.most * (1.0 + kNothing)) continue;
    for (Rest& freed : rests_of(one.vertex)) {
      const double pull = left.dot(freed.point.normal);
      if (!freed.held || freed.releases >= kMostReleases || pull <= kNothing) continue;
      if (freed.releases == 0) {
        freed.releases = 1;
        set_held(freed, false);
        changed = true;
      } else if (pull > most) {
        most = pull;
        most_pulled = &freed;
      }
    }
  }
  if (changed || most_pulled == nullptr) return changed;
  ++most_pulled->releases;
  set_held(*most_pulled, false);
  return true;
}

}  // namespace planish
