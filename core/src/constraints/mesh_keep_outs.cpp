// SPDX-License-Identifier: MIT
#include "planish/constraints/mesh_keep_outs.hpp"

#include <algorithm>
#include <limits>

#include "planish/constraints/mesh_limits.hpp"
#include "planish/numeric/index.hpp"

namespace planish {

MeshKeepOuts::MeshKeepOuts(const LimitBase& base, const FreeSpace& free)
    : base_(base), rows_(at(base.mesh.face_count())), has_sides_(!free.sides.empty()) {
  for (const KeptBox& box : free.boxes) boxes_.push_back(in_points(base, box));
  for (int f = 0; f < base.mesh.face_count(); ++f) append_rows(base, free, f, rows_[at(f)]);
  if (!free.apart && free.walls.empty()) return;
  clearance_ = free.apart.value_or(free.wall_clearance) / base.unit;
  if (free.apart) reach_ = std::make_shared<PanelBoxes>(base.mesh, base.points);
  if (!free.walls.empty()) take_walls(free);
  pairs_of_.resize(rows_.size());
  part_what_touches();
}

void MeshKeepOuts::take_walls(const FreeSpace& free) {
  Eigen::Index corners = 0;
  for (const Positions& wall : free.walls) corners += wall.cols();
  walls_.positions.resize(3, corners);
  corners = 0;
  const Eigen::Vector3d from = base_.mesh.positions.col(0), to = base_.points.col(0);
  for (const Positions& wall : free.walls) {
    walls_.positions.middleCols(corners, wall.cols()) =
        ((wall.colwise() - from) / base_.unit).colwise() + to;
    corners += wall.cols();
    walls_.face_offsets.push_back(static_cast<int>(corners));
  }
  for (int v = 0; v < walls_.vertex_count(); ++v) walls_.face_vertices.push_back(v);
  wall_reach_ = std::make_shared<PanelBoxes>(walls_, walls_.positions);
}

std::vector<RestingPoint> MeshKeepOuts::resting_points() const {
  std::vector<RestingPoint> points;
  for (const auto& rows : rows_) {
    for (const KeepOutRow& row : rows) {
      if (row.rests) points.push_back({row.vertex(), row.normal});
    }
  }
  return points;
}

void MeshKeepOuts::open() {
  for (auto one = changed_.rbegin(); one != changed_.rend(); ++one) {
    rows_[at(one->face)][one->row] = one->was;
  }
  changed_.clear();
}

void MeshKeepOuts::take(int face, std::size_t row, const KeepOutRow& other) {
  KeepOutRow& here = rows_[at(face)][row];
  changed_.push_back({face, row, here});
  here = other;
}

/// @param rows of one panel and one box
bool MeshKeepOuts::choose_plane(std::span<KeepOutRow> rows,
                                const std::function<Eigen::Vector3d(int)>& point) {
  constexpr double kNear = 0.5;    // share of a point: where a plane acts
  constexpr double kWorth = 1e-3;  // of a side: what another plane must give more
  Positions panel(3, static_cast<Eigen::Index>(rows.size()));
  double gap = std::numeric_limits<double>::infinity();
  bool near = false;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const KeepOutRow& row = rows[k];
    if (row.rests) return false;
    const Eigen::Vector3d here = point(row.vertex());
    panel.col(static_cast<Eigen::Index>(k)) = here;
    const double share = row.share(here);
    near = near || share < kNear;
    gap = std::min(gap, share / row.scale.slope);
  }
  if (!near) return false;
  const int face = rows[0].panel, box = rows[0].box;
  const double side = mean_side(base_.points, base_.mesh.face(face));
  const BoxPlane plane = widest_plane(boxes_[at(box)], panel);
  if (!(plane.gap > gap + kWorth * side)) return false;
  const auto first = static_cast<std::size_t>(rows.data() - rows_[at(face)].data());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const int v = rows[k].vertex();
    KeepOutRow turned = plane_row(v, base_.points.col(v), side, plane.normal, plane.bound);
    turned.panel = face;
    turned.box = box;
    take(face, first + k, turned);
  }
  return true;
}

bool MeshKeepOuts::choose_planes(std::span<const int> faces,
                                 const std::function<Eigen::Vector3d(int)>& point) {
  bool changed = false;
  for (const int face : faces) {
    std::vector<KeepOutRow>& rows = rows_[at(face)];
    const auto box =
        std::find_if(rows.begin(), rows.end(), [](const KeepOutRow& row) { return row.box >= 0; });
    const std::size_t corners = base_.mesh.face(face).size();
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      changed = choose_plane({&*box + b * corners, corners}, point) || changed;
    }
    if (!parts_panels()) continue;
    for (const int pair : pairs_of_[at(face)]) {
      changed = choose_plane(pairs_[at(pair)], point) || changed;
    }
  }
  return changed;
}

namespace {

/// Whether a row of that share holds something back. A point that rests has no room to begin with.
bool binds(const KeepOutRow& row, double share) {
  constexpr double kTouches = 1e-6;
  constexpr double kPressed = 0.1;  // there the barrier's force is 5 to 1 of what it is at 1/4
  return !(share >= (row.rests ? kTouches : kPressed));
}

}  // namespace

LimitStanding MeshKeepOuts::standing(std::span<const int> faces,
                                     const std::function<Eigen::Vector3d(int)>& point) const {
  LimitStanding standing{.name = "keep-out", .binding = {}};
  for (const int face : faces) {
    for (const KeepOutRow& row : of(face)) {
      const double share = row.share(point(row.vertex()));
      // Not a number is no share that holds.
      if (!(share >= standing.least_share)) standing.least_share = share;
      if (binds(row, share)) standing.binding.push_back(row.vertex());
    }
  }
  std::vector<int>& points = standing.binding;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return standing;
}

void MeshLimits::keep_out(const LimitBase& base, const FreeSpace& free) {
  keep_outs_ = std::make_shared<MeshKeepOuts>(base, free);
}

void MeshLimits::keep_out(const LimitBase& base, const std::vector<KeepOut>& keep_outs,
                          double clearance) {
  keep_out(base, free_space(keep_outs, clearance));
}

}  // namespace planish
