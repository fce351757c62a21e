// SPDX-License-Identifier: MIT
#include "edit/edit_reach.hpp"

#include <algorithm>
#include <limits>

#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/edit/kept_by_variations.hpp"
#include "planish/numeric/index.hpp"

namespace planish {

bool has_reach(const HandleEditOptions& options) {
  return options.reach > 0 || options.reach_length > 0.0;
}

void EditReach::add(int vertex, std::vector<int>& found) {
  if (vertex_mark_[at(vertex)] == stamp_) return;
  vertex_mark_[at(vertex)] = stamp_;
  found.push_back(vertex);
}

/// Whether any handle is within `length`; only those that are as near along x are looked at.
bool EditReach::is_near(int vertex, double length) const {
  if (!(length > 0.0)) return true;
  const Eigen::Vector3d here = mesh_.positions.col(vertex);
  auto centre = std::lower_bound(centres_.begin(), centres_.end(), here.x() - length,
                                 [](const Eigen::Vector3d& c, double x) { return c.x() < x; });
  for (; centre != centres_.end() && centre->x() <= here.x() + length; ++centre) {
    if ((*centre - here).norm() <= length) return true;
  }
  return false;
}

/// The corners of every face at found[begin, end). A face is walked once, however many of its
/// corners are found.
void EditReach::add_ring(std::size_t begin, std::size_t end, double length,
                         std::vector<int>& found) {
  for (std::size_t k = begin; k < end; ++k) {
    for (const int f : adjacency_.faces[found[k]]) {
      if (face_mark_[at(f)] == stamp_) continue;
      face_mark_[at(f)] = stamp_;
      for (const int v : mesh_.face(f)) {
        if (is_near(v, length)) add(v, found);
      }
    }
  }
}

std::vector<int> EditReach::within(std::span<const Handle> handles,
                                   const HandleEditOptions& options) {
  vertex_mark_.resize(at(mesh_.vertex_count()), 0);
  face_mark_.resize(at(mesh_.face_count()), 0);
  ++stamp_;
  centres_.clear();
  std::vector<int> found;
  for (const Handle& handle : handles) {
    centres_.emplace_back(mesh_.positions.col(handle.vertex));
    add(handle.vertex, found);
  }
  std::sort(centres_.begin(), centres_.end(),
            [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.x() < b.x(); });
  const int rings = options.reach > 0 ? options.reach : std::numeric_limits<int>::max();
  std::size_t begin = 0;
  for (int ring = 0; ring < rings && begin < found.size(); ++ring) {
    const std::size_t end = found.size();
    add_ring(begin, end, options.reach_length, found);
    begin = end;
  }
  return found;
}

std::vector<int> held_vertices(const Mesh& mesh, const EditTargets& targets,
                               const HandleEditOptions& options) {
  std::vector<int> held = targets.pins;
  const bool confined = has_reach(options);
  if (confined || options.keep_boundary) {
    const Adjacency adjacency = build_adjacency(mesh);
    std::vector<char> free(at(mesh.vertex_count()), confined ? 0 : 1);
    if (confined) {
      EditReach reach(mesh, adjacency);
      for (const int v : reach.within(targets.handles, options)) free[at(v)] = 1;
    }
    for (std::size_t v = 0; options.keep_boundary && v < free.size(); ++v) {
      if (adjacency.boundary[v]) free[v] = 0;
    }
    for (const Handle& handle : targets.handles) free[at(handle.vertex)] = 1;
    for (const int pin : targets.pins) free[at(pin)] = 0;
    held.clear();
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (!free[at(v)]) held.push_back(v);
    }
  }
  std::sort(held.begin(), held.end());
  return held;
}

void hold_resting(const Mesh& mesh, const HandleEditOptions& options, std::vector<int>& held) {
  const Adjacency adjacency = build_adjacency(mesh);
  const MeshKeepOuts keep_outs({mesh, adjacency, mesh.positions, 1.0},
                               free_space(options.keep_outs, options.clearance));
  for (const RestingPoint& point : keep_outs.resting_points()) held.push_back(point.vertex);
}

KeptByVariations kept_by_variations(const Mesh& mesh, const EditTargets& targets,
                                    const HandleEditOptions& options,
                                    std::shared_ptr<const MeshSymmetry> symmetry) {
  std::vector<int> held = held_vertices(mesh, targets, options);
  if (!options.keep_outs.empty()) hold_resting(mesh, options, held);
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return {std::move(held), kept_kinds(options.tolerance, options.constraints), targets.supports,
          std::move(symmetry)};
}

}  // namespace planish
