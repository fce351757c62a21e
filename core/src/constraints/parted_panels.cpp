// SPDX-License-Identifier: MIT
/// A mesh that is a keep-out itself: the planes between its panels. [KEE-4] And those between its
/// panels and walls, which are panels of other models. [KEE-5]
#include <algorithm>
#include <limits>

#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/constraints/panel_contact.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kUnpressed = 0.5;  ///< share of a point: where no barrier acts

/// Bounds of n · p for the first, and of −n · p for the second, with the clearance between the two.
std::array<double, 2> bounds_between(const PanelGap& gap, double clearance, double part) {
  const double room = gap.width() - clearance;
  return {gap.lowest - part * room, -(gap.highest + (1.0 - part) * room)};
}

Eigen::AlignedBox3d box_around(const Positions& shape) {
  return {Eigen::Vector3d(shape.rowwise().minCoeff()), Eigen::Vector3d(shape.rowwise().maxCoeff())};
}

Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box, double by) {
  const Eigen::Vector3d more = Eigen::Vector3d::Constant(by);
  return {box.min() - more, box.max() + more};
}

}  // namespace

/// What the first of two panels gets of the room between them: near all where the other is at rest.
/// The plane follows it there in a turn or two; halves would take ten. A wall needs none.
double MeshKeepOuts::part_of_first(const Pair& pair, const std::array<bool, 2>& moved) const {
  constexpr double kNearAll = 0.9;
  if (is_wall(pair.panels[1])) return 1.0;
  if (moved[0] == moved[1]) return 0.5;
  return moved[0] ? kNearAll : 1.0 - kNearAll;
}

/// Panels near `box`, of the mesh where it is a keep-out itself, and walls; ascending.
std::vector<int> MeshKeepOuts::panels_near(const Eigen::AlignedBox3d& box) const {
  std::vector<int> panels;
  if (reach_ != nullptr) panels = reach_->near(box);
  if (wall_reach_ != nullptr) {
    for (const int wall : wall_reach_->near(box)) panels.push_back(base_.mesh.face_count() + wall);
  }
  std::sort(panels.begin(), panels.end());
  return panels;
}

Positions MeshKeepOuts::base_shape(int face) const {
  return shape(face, [&](int v) -> Eigen::Vector3d { return base_.points.col(v); });
}

Positions MeshKeepOuts::shape(int face, const std::function<Eigen::Vector3d(int)>& point) const {
  if (is_wall(face)) {
    const auto wall = walls_.face(face - base_.mesh.face_count());
    return walls_.positions.middleCols(wall.front(), static_cast<Eigen::Index>(wall.size()));
  }
  const auto panel = base_.mesh.face(face);
  Positions shape(3, static_cast<Eigen::Index>(panel.size()));
  for (std::size_t k = 0; k < panel.size(); ++k) {
    shape.col(static_cast<Eigen::Index>(k)) = point(panel[k]);
  }
  return shape;
}

std::span<KeepOutRow> MeshKeepOuts::rows_of(const Pair& pair, std::size_t which) {
  const int face = pair.panels[which];
  if (is_wall(face)) return {};
  return {rows_[at(face)].data() + pair.first_row[which], base_.mesh.face(face).size()};
}

/// Panels that share a point meet there; a pair that has a plane needs no other.
bool MeshKeepOuts::may_meet(int first, int second) const {
  if (!is_wall(second)) {
    const auto a = base_.mesh.face(first), b = base_.mesh.face(second);
    if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end()) return false;
  }
  const auto& pairs = pairs_of_[at(first)];
  return std::none_of(pairs.begin(), pairs.end(), [&](int k) {
    const auto& panels = pairs_[at(k)].panels;
    return panels[0] == second || panels[1] == second;
  });
}

/// Adds a pair with the plane of the base, in the middle of the room that it leaves, or at the
/// wall.
void MeshKeepOuts::add_pair(int first, int second) {
  const PanelGap gap = widest_gap(base_shape(first), base_shape(second));
  Pair pair{{first, second}, {}};
  const std::array<double, 2> bounds =
      bounds_between(gap, clearance_, part_of_first(pair, {false, false}));
  for (std::size_t which = 0; which < 2; ++which) {
    const int face = pair.panels[which];
    if (is_wall(face)) break;
    const Eigen::Vector3d normal = which == 0 ? gap.normal : Eigen::Vector3d(-gap.normal);
    const double side = mean_side(base_.points, base_.mesh.face(face));
    pair.first_row[which] = rows_[at(face)].size();
    for (const int v : base_.mesh.face(face)) {
      const double room = normal.dot(base_.points.col(v)) - bounds[which];
      rows_[at(face)].push_back(base_row(base_, v, side, normal, room));
    }
    pairs_of_[at(face)].push_back(static_cast<int>(pairs_.size()));
  }
  pairs_.push_back(pair);
}

/// What touches in the base, or is nearer than the clearance, goes no deeper.
void MeshKeepOuts::part_what_touches() {
  for (int f = 0; f < base_.mesh.face_count(); ++f) {
    const Positions here = base_shape(f);
    const double near =
        clearance_ + 2.0 * kRestsWithin * mean_side(base_.points, base_.mesh.face(f));
    for (const int g : panels_near(widened(box_around(here), near))) {
      if (g <= f || !may_meet(f, g)) continue;
      if (widest_gap(here, base_shape(g)).width() <= near) add_pair(f, g);
    }
  }
  base_pairs_ = pairs_.size();
}

void MeshKeepOuts::forget_parted() {
  open();
  if (!parts_panels()) return;
  for (; pairs_.size() > base_pairs_; pairs_.pop_back()) {
    for (std::size_t which = 0; which < 2; ++which) {
      const int face = pairs_.back().panels[which];
      if (is_wall(face)) break;
      rows_[at(face)].resize(pairs_.back().first_row[which]);
      pairs_of_[at(face)].pop_back();
    }
  }
}

bool MeshKeepOuts::part_panels(std::span<const int> faces,
                               const std::function<Eigen::Vector3d(int)>& point) {
  if (!parts_panels()) return false;
  const std::size_t known = pairs_.size();
  const std::vector<Touched> touched = touched_panels(faces, point);
  for (std::size_t k = 0; k < touched.size(); ++k) {
    part_from_all(touched, k);
  }
  const auto acts = [&](const Pair& pair) {
    for (std::size_t which = 0; which < 2; ++which) {
      for (const KeepOutRow& row : rows_of(pair, which)) {
        if (!row.rests && !(row.share(point(row.vertex())) >= kUnpressed)) return true;
      }
    }
    return false;
  };
  return std::any_of(pairs_.begin() + static_cast<std::ptrdiff_t>(known), pairs_.end(), acts);
}

/// The panels among `faces` that are elsewhere than in the base.
std::vector<MeshKeepOuts::Touched> MeshKeepOuts::touched_panels(
    std::span<const int> faces, const std::function<Eigen::Vector3d(int)>& point) const {
  std::vector<Touched> touched;
  for (const int f : faces) {
    PanelPath path{base_shape(f), shape(f, point)};
    if (path.now == path.base) continue;
    const Eigen::AlignedBox3d box = box_around(path.base).merged(box_around(path.now));
    touched.push_back({f, std::move(path), widened(box, clearance_)});
  }
  return touched;
}

/// The panel at `k` from those behind it, and from all that are where they were.
void MeshKeepOuts::part_from_all(const std::vector<Touched>& touched, std::size_t k) {
  const Touched& one = touched[k];
  const auto part = [&](int g, const PanelPath& other) {
    if (may_meet(one.face, g) && !are_parted(one.path, other, clearance_)) add_pair(one.face, g);
  };
  for (std::size_t j = k + 1; j < touched.size() && reach_ != nullptr; ++j) {
    if (one.box.intersects(touched[j].box)) part(touched[j].face, touched[j].path);
  }
  for (const int g : panels_near(one.box)) {
    const bool is_touched = std::any_of(touched.begin(), touched.end(),
                                        [&](const Touched& each) { return each.face == g; });
    if (!is_touched) part(g, {base_shape(g), base_shape(g)});
  }
}

/// Where the barrier acts on one of the two, another plane is taken if it leaves that one more
/// room. What has gone through its plane keeps it: another might be on its other side.
bool MeshKeepOuts::choose_plane(const Pair& pair,
                                const std::function<Eigen::Vector3d(int)>& point) {
  constexpr double kWorth = 1e-3;  // of a side: what another plane must give more
  std::array<double, 2> room{}, side{};
  std::array<bool, 2> pressed{}, moved{};
  std::array<Positions, 2> shapes;
  for (std::size_t which = 0; which < 2; ++which) {
    const int face = pair.panels[which];
    shapes[which] = shape(face, point);
    room[which] = std::numeric_limits<double>::infinity();
    side[which] = room[which];
    if (is_wall(face)) break;
    side[which] = mean_side(base_.points, base_.mesh.face(face));
    moved[which] = shapes[which] != base_shape(face);
    for (const KeepOutRow& row : rows_of(pair, which)) {
      if (row.rests) return false;
      const double share = row.share(point(row.vertex()));
      pressed[which] = pressed[which] || !(share >= kUnpressed);
      room[which] = std::min(room[which], share / row.scale.slope);
    }
  }
  const double worth = kWorth * std::min(side[0], side[1]);
  const double least = std::min(pressed[0] ? room[0] : room[1], pressed[1] ? room[1] : room[0]);
  if (!(pressed[0] || pressed[1]) || least < -worth) return false;
  const PanelGap gap = widest_gap(shapes[0], shapes[1]);
  const double part = part_of_first(pair, moved), all = gap.width() - clearance_;
  const std::array<double, 2> next = {part * all, (1.0 - part) * all};
  const double then = std::min(pressed[0] ? next[0] : next[1], pressed[1] ? next[1] : next[0]);
  if (!(then > least + worth)) return false;
  turn_plane(pair, gap, part, side);
  return true;
}

void MeshKeepOuts::turn_plane(const Pair& pair, const PanelGap& gap, double part,
                              const std::array<double, 2>& side) {
  const std::array<double, 2> bounds = bounds_between(gap, clearance_, part);
  for (std::size_t which = 0; which < 2; ++which) {
    const Eigen::Vector3d normal = which == 0 ? gap.normal : Eigen::Vector3d(-gap.normal);
    for (std::size_t k = 0; k < rows_of(pair, which).size(); ++k) {
      const int v = rows_of(pair, which)[k].vertex();
      take(pair.panels[which], pair.first_row[which] + k,
           plane_row(v, base_.points.col(v), side[which], normal, bounds[which]));
    }
  }
}

}  // namespace planish
