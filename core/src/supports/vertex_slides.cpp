// SPDX-License-Identifier: MIT
#include "planish/supports/vertex_slides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "planish/numeric/index.hpp"
#include "supports/guide_lines.hpp"

namespace planish {
namespace {

constexpr double kOnTrack = 1e-9;  ///< mean edges: what counts as on it

/// An orthonormal pair across a line.
std::array<Eigen::Vector3d, 2> across(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d along = direction.normalized();
  Eigen::Index least = 0;
  along.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d first = along.cross(Eigen::Vector3d::Unit(least)).normalized();
  return {first, along.cross(first)};
}

std::vector<Eigen::Vector3d> forbidden(const PointSupport& support) {
  if (support.kind == PointSupport::Kind::kLevel) return {Eigen::Vector3d::Unit(support.axis)};
  const Eigen::Map<const Eigen::Vector3d> first(support.numbers.data());
  if (support.kind == PointSupport::Kind::kPlane) return {first.normalized()};
  const auto pair = across(Eigen::Map<const Eigen::Vector3d>(support.numbers.data() + 3));
  return {pair[0], pair[1]};
}

/// Takes one more direction out of a projection. A direction along an axis leaves exact zeros.
void forbid(const Eigen::Vector3d& direction, Eigen::Matrix3d& along) {
  constexpr double kSame = 1e-9;  // what two supports forbid twice
  const Eigen::Vector3d left = along * direction;
  const double length = left.norm();
  if (length <= kSame) return;
  const Eigen::Vector3d unit = left / length;
  along -= unit * unit.transpose();
  if (along.trace() < 0.5) along.setZero();  // its rank is whole in exact numbers
}

/// The projection onto a line, or onto nothing where `others` do not leave it.
Eigen::Matrix3d line_within(const Eigen::Vector3d& direction, const SlideTrack& others) {
  constexpr double kAligned = 1e-9;
  const Eigen::Vector3d unit = direction.normalized();
  const bool left = (others.along * unit - unit).norm() <= kAligned;
  return left ? Eigen::Matrix3d(unit * unit.transpose()) : Eigen::Matrix3d::Zero();
}

}  // namespace

VertexSlides::VertexSlides(const Mesh& mesh, const std::vector<PointSupport>& supports, double unit)
    : mesh_(mesh), unit_(unit), place_(at(mesh.vertex_count()), -1) {
  std::vector<int> on_lines;
  for (const PointSupport& support : supports) {
    if (support.kind == PointSupport::Kind::kSurface || is_spring(support)) continue;
    const std::vector<int> points = points_of(support, mesh);
    if (is_line_of_mesh(support)) {
      on_lines.insert(on_lines.end(), points.begin(), points.end());
      continue;
    }
    const std::vector<Eigen::Vector3d> directions = forbidden(support);
    for (const int v : points) {
      SlideTrack& track = track_of(v);
      for (const Eigen::Vector3d& direction : directions) forbid(direction, track.along);
    }
  }
  for (const PointSupport& support : supports) {
    if (support.kind == PointSupport::Kind::kSurface) add_feet(support, points_of(support, mesh));
  }
  order_feet();
  if (on_lines.empty()) return;
  lines_ = std::make_unique<GuideLines>(mesh, supports);
  std::sort(on_lines.begin(), on_lines.end());
  on_lines.erase(std::unique(on_lines.begin(), on_lines.end()), on_lines.end());
  for (const int v : on_lines) add_runner(v);
}

VertexSlides::~VertexSlides() = default;

SlideTrack& VertexSlides::track_of(int vertex) {
  int& place = place_[at(vertex)];
  if (place < 0) {
    place = static_cast<int>(tracks_.size());
    tracks_.emplace_back();
  }
  return tracks_[at(place)];
}

const SlideTrack* VertexSlides::track(int vertex) const {
  const int place = place_[at(vertex)];
  return place < 0 ? nullptr : &tracks_[at(place)];
}

void VertexSlides::add_runner(int vertex) {
  Runner runner;
  runner.vertex = vertex;
  runner.others = track_of(vertex);
  runner.place = place_[at(vertex)];
  open(runner);
  runner_of_.resize(tracks_.size(), -1);
  runner_of_[at(runner.place)] = static_cast<int>(runners_.size());
  runners_.push_back(runner);
}

/// The way from one vertex of the base to another, solver units.
Eigen::Vector3d VertexSlides::way(int from, int to) const {
  return (mesh_.positions.col(to) - mesh_.positions.col(from)) / unit_;
}

void VertexSlides::open(Runner& runner) {
  runner.turns = 0;
  runner.state = Runner::State::kOpen;
  runner.corner = runner.vertex;
  if (lines_->is_corner(runner.vertex)) return rest_at(runner.vertex, runner);
  const Eigen::Vector3d mean = way(lines_->beside(runner.vertex, 0), runner.vertex).normalized() +
                               way(runner.vertex, lines_->beside(runner.vertex, 1)).normalized();
  tracks_[at(runner.place)] = {line_within(mean, runner.others), Eigen::Vector3d::Zero()};
}

void VertexSlides::rest_at(int corner, Runner& runner) {
  runner.state = Runner::State::kCorner;
  runner.corner = corner;
  tracks_[at(runner.place)] = {Eigen::Matrix3d::Zero(), way(runner.vertex, corner)};
}

void VertexSlides::take_side(int corner, int side, Runner& runner) {
  const Eigen::Vector3d along = way(corner, lines_->beside(corner, side));
  runner.state = Runner::State::kSide;
  runner.corner = corner;
  runner.side = side;
  runner.length = along.norm();
  tracks_[at(runner.place)] = {line_within(along, runner.others), way(runner.vertex, corner)};
}

void VertexSlides::open() {
  for (Runner& runner : runners_) open(runner);
  open_feet();
  if (has_rests()) let_all_go();
}

/// Goes on where `d` leaves the side at one of its ends: across the corner there, or to rest at it.
bool VertexSlides::follow(Runner& runner, const Eigen::Vector3d& d) {
  constexpr int kMostTurns = 6;  // then it rests: it may go to and fro
  constexpr double kNothing = 1e-12;
  if (runner.state == Runner::State::kCorner) return false;
  if (runner.state == Runner::State::kOpen) {
    const double forth = d.dot(way(runner.vertex, lines_->beside(runner.vertex, 1)));
    if (std::abs(forth) <= kNothing) return false;
    take_side(runner.vertex, forth > 0.0 ? 1 : 0, runner);
    return true;
  }
  const int end = lines_->beside(runner.corner, runner.side);
  const Eigen::Vector3d along = way(runner.corner, end) / runner.length;
  const double place = along.dot(d - way(runner.vertex, runner.corner));
  if (place >= 0.0 && place <= runner.length) return false;
  const int corner = place < 0.0 ? runner.corner : end;
  const int onward = place < 0.0 ? 1 - runner.side : runner.side;
  const bool came_from_there = place < 0.0 && runner.turns == 0;
  if (came_from_there || ++runner.turns >= kMostTurns || lines_->is_corner(corner)) {
    rest_at(corner, runner);
  } else {
    take_side(corner, onward, runner);
  }
  return true;
}

bool VertexSlides::follow(std::span<const int> vertices, const Eigen::Matrix3Xd& displacement) {
  bool changed = false;
  for (Runner& runner : runners_) {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), runner.vertex);
    if (found == vertices.end() || *found != runner.vertex) continue;
    changed = follow(runner, displacement.col(found - vertices.begin())) || changed;
  }
  for (std::size_t k = 0; k < vertices.size() && !feet_.empty(); ++k) {
    const Eigen::Vector3d d = displacement.col(static_cast<Eigen::Index>(k));
    changed = follow_surfaces(vertices[k], d) || changed;
  }
  return changed;
}

void VertexSlides::stand(const Eigen::Matrix3Xd& displacement) {
  for (Runner& runner : runners_) {
    const Eigen::Vector3d d = displacement.col(runner.vertex);
    while (follow(runner, d)) continue;
    runner.turns = 0;
  }
  stand_on_surfaces(displacement);
}

void VertexSlides::release_corners() {
  for (Runner& runner : runners_) {
    runner.turns = 0;
    if (runner.state == Runner::State::kCorner && runner.corner == runner.vertex) open(runner);
  }
  for (Foot& foot : feet_) foot.turns = 0;
  if (has_rests()) forget_releases();
}

bool VertexSlides::is_within_side(const Runner& runner, const Eigen::Vector3d& d) const {
  if (runner.state == Runner::State::kCorner) return true;
  if (runner.state == Runner::State::kOpen) return d.norm() <= kOnTrack;
  const Eigen::Vector3d along = way(runner.corner, lines_->beside(runner.corner, runner.side));
  const double place = along.dot(d - way(runner.vertex, runner.corner)) / runner.length;
  return place >= -kOnTrack && place <= runner.length + kOnTrack;
}

bool VertexSlides::rests(int vertex) const {
  const int place = place_[at(vertex)];
  if (place < 0) return false;
  const int runner = at(place) < runner_of_.size() ? runner_of_[at(place)] : -1;
  if (runner >= 0) return runners_[at(runner)].state != Runner::State::kSide;
  return tracks_[at(place)].along.isZero(0.0);
}

bool VertexSlides::holds(int vertex, const Eigen::Vector3d& d) const {
  const int place = place_[at(vertex)];
  if (has_feet() && !is_at_heights(vertex, d)) return false;
  if (place < 0) return true;
  if (!((d - tracks_[at(place)].nearest(d)).norm() <= kOnTrack)) return false;
  const int runner = at(place) < runner_of_.size() ? runner_of_[at(place)] : -1;
  return runner < 0 || is_within_side(runners_[at(runner)], d);
}

}  // namespace planish
