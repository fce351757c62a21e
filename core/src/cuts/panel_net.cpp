// SPDX-License-Identifier: MIT
#include "cuts/panel_net.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "planish/mesh/area_vector.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Which group each panel belongs to; -1: none.
std::vector<int> groups_of_panels(const Mesh& mesh) {
  std::vector<int> groups(at(mesh.face_count()), -1);
  for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
    std::fill(groups.begin() + mesh.groups[g].first_face, groups.end(), static_cast<int>(g));
  }
  return groups;
}

/// Runs of panels of one group each; those of none behind others are a group without a name.
std::vector<FaceGroup> runs_of(const std::vector<int>& groups, const Mesh& given) {
  std::vector<FaceGroup> runs;
  for (std::size_t f = 0; f < groups.size(); ++f) {
    const int before = f > 0 ? groups[f - 1] : -1;
    if (groups[f] == before) continue;
    FaceGroup run = groups[f] < 0 ? FaceGroup() : given.groups[at(groups[f])];
    run.first_face = static_cast<int>(f);
    runs.push_back(std::move(run));
  }
  return runs;
}

/// Replaces numbers of panels by those after some went; those that went are left out.
void renumber(const std::vector<int>& new_number, std::vector<int>& panels) {
  for (int& f : panels) f = new_number[at(f)];
  panels.erase(std::remove(panels.begin(), panels.end(), -1), panels.end());
}

/// The panels of each point, by counting.
RaggedRows panels_of_points(const Mesh& mesh) {
  RaggedRows rows;
  rows.offsets.assign(at(mesh.vertex_count()) + 1, 0);
  for (const int v : mesh.face_vertices) ++rows.offsets[at(v) + 1];
  for (std::size_t v = 1; v < rows.offsets.size(); ++v) rows.offsets[v] += rows.offsets[v - 1];
  rows.values.resize(mesh.face_vertices.size());
  std::vector<int> next = rows.offsets;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) rows.values[at(next[at(v)]++)] = f;
  }
  return rows;
}

}  // namespace

PanelNet::PanelNet(const Mesh& mesh)
    : given_(mesh),
      corners_({mesh.face_offsets, mesh.face_vertices}),
      panels_of_(panels_of_points(mesh)),
      parents_(at(mesh.face_count())),
      groups_(groups_of_panels(mesh)),
      parted_in_(at(mesh.face_count()), 0) {
  std::iota(parents_.begin(), parents_.end(), 0);
}

Eigen::Vector3d PanelNet::point(int v) const {
  if (v < given_.vertex_count()) return given_.positions.col(v);
  return places_[at(v - given_.vertex_count())];
}

Eigen::Vector3d PanelNet::area_vector(int f) const {
  Positions outline(3, static_cast<Eigen::Index>(panel(f).size()));
  std::vector<int> order;
  for (const int v : panel(f)) {
    outline.col(static_cast<Eigen::Index>(order.size())) = point(v);
    order.push_back(static_cast<int>(order.size()));
  }
  return planish::area_vector(outline, order);
}

int PanelNet::corner_of(int f, int vertex) const {
  const auto corners = panel(f);
  const auto found = std::find(corners.begin(), corners.end(), vertex);
  return found == corners.end() ? -1 : static_cast<int>(found - corners.begin());
}

bool PanelNet::has_side(int f, int from, int to) const {
  const int first = corner_of(f, from), second = corner_of(f, to);
  if (first < 0 || second < 0) return false;
  const int count = static_cast<int>(panel(f).size());
  return (first + 1) % count == second || (second + 1) % count == first;
}

std::array<int, 2> PanelNet::panels_at(int from, int to) const {
  std::array<int, 2> found{-1, -1};
  if (std::max(from, to) >= point_count()) return found;
  std::size_t count = 0;
  for (const int f : panels_of_[from]) {
    if (count < found.size() && has_side(f, from, to)) found[count++] = f;
  }
  return found;
}

int PanelNet::add_point(const Eigen::Vector3d& place, const AddedPoint& where) {
  added_.push_back(where);
  added_.back().vertex = point_count() - 1;
  places_.push_back(place);
  panels_of_.add({});
  records_.back().points.push_back(added_.back().vertex);
  return added_.back().vertex;
}

std::array<int, 2> PanelNet::given_side(int from, int to, int f) const {
  constexpr std::array<int, 2> kNone{-1, -1};
  const int given = given_.vertex_count(), first = std::min(from, to), last = std::max(from, to);
  if (last < given) {
    const auto face = given_.face(parents_[at(f)]);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto ends = std::minmax(face[k], face[(k + 1) % face.size()]);
      if (ends.first == first && ends.second == last) return {first, last};
    }
    return kNone;
  }
  const AddedPoint& newer = added_[at(last - given)];
  if (first < given) {
    return newer.from == first || newer.to == first ? std::array{newer.from, newer.to} : kNone;
  }
  const AddedPoint& older = added_[at(first - given)];
  const bool is_same = older.from == newer.from && older.to == newer.to;
  return is_same ? std::array{newer.from, newer.to} : kNone;
}

int PanelNet::add_on_edge(int from, int to, double share) {
  const auto panels = panels_at(from, to);
  const auto side = given_side(from, to, panels[0]);
  const Eigen::Vector3d start = point(from);
  const int added = add_point(start + share * (point(to) - start),
                              {0, side[0], side[1], side[0] < 0 ? parents_[at(panels[0])] : -1});
  for (const int f : panels) {
    if (f < 0) continue;
    std::vector<int> corners(panel(f).begin(), panel(f).end());
    const int first = corner_of(f, from), count = static_cast<int>(corners.size());
    const bool forward = corners[at((first + 1) % count)] == to;
    corners.insert(corners.begin() + (forward ? first + 1 : corner_of(f, to) + 1), added);
    corners_.set(f, corners);
    add_panel_at(added, f);
  }
  return added;
}

int PanelNet::add_inside(int f, const Eigen::Vector3d& place) {
  return add_point(place, {0, -1, -1, parents_[at(f)]});
}

void PanelNet::add_panel_at(int v, int f) {
  std::vector<int> panels(panels_of_[v].begin(), panels_of_[v].end());
  panels.push_back(f);
  panels_of_.set(v, panels);
}

void PanelNet::take_from_corners(int f) {
  for (const int v : panel(f)) {
    std::vector<int> panels(panels_of_[v].begin(), panels_of_[v].end());
    panels.erase(std::find(panels.begin(), panels.end(), f));
    panels_of_.set(v, panels);
  }
}

void PanelNet::add_to_corners(int f) {
  for (const int v : panel(f)) add_panel_at(v, f);
}

void PanelNet::part(int f, const std::vector<std::vector<int>>& parts) {
  take_from_corners(f);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const int number = k == 0 ? f : panel_count();
    if (k == 0) {
      corners_.set(f, parts[k]);
    } else {
      corners_.add(parts[k]);
      parents_.push_back(parents_[at(f)]);
      groups_.push_back(groups_[at(f)]);
      parted_in_.push_back(0);
    }
    add_to_corners(number);
    if (!is_parted(number)) records_.back().panels.push_back(number);
    parted_in_[at(number)] = records_.size();
  }
}

void PanelNet::remove(const std::vector<char>& gone) {
  std::vector<int> new_number(gone.size(), -1);
  std::size_t count = 0;
  for (std::size_t f = 0; f < gone.size(); ++f) {
    if (gone[f]) continue;
    new_number[f] = static_cast<int>(count);
    parents_[count] = parents_[f];
    parted_in_[count] = parted_in_[f];
    groups_[count++] = groups_[f];
  }
  corners_.remove(gone);
  parents_.resize(count);
  groups_.resize(count);
  parted_in_.resize(count);
  for (int v = 0; v < point_count(); ++v) {
    std::vector<int> panels(panels_of_[v].begin(), panels_of_[v].end());
    renumber(new_number, panels);
    panels_of_.set(v, panels);
  }
  for (CutRecord& record : records_) {
    renumber(new_number, record.panels);
    renumber(new_number, record.straight);
  }
}

void PanelNet::start(const Cut& cut) {
  if (!records_.empty()) records_.back().straight = panels_with_new_points();
  records_.push_back({cut, {}, {}, {}});
  first_new_point_ = point_count();
}

std::vector<int> PanelNet::panels_with_new_points() const {
  std::vector<int> panels;
  for (int v = first_new_point_; v < point_count(); ++v) {
    for (const int f : panels_of_[v]) {
      if (!is_parted(f)) panels.push_back(f);
    }
  }
  std::sort(panels.begin(), panels.end());
  panels.erase(std::unique(panels.begin(), panels.end()), panels.end());
  return panels;
}

std::vector<int> PanelNet::new_points_of(int f) const {
  std::vector<int> points;
  for (const int v : panel(f)) {
    if (v >= first_new_point_) points.push_back(v);
  }
  return points;
}

CutMesh PanelNet::finished() const {
  CutMesh result;
  result.mesh.positions.resize(3, point_count());
  result.mesh.positions.leftCols(given_.vertex_count()) = given_.positions;
  for (int v = given_.vertex_count(); v < point_count(); ++v) {
    result.mesh.positions.col(v) = point(v);
  }
  for (int f = 0; f < panel_count(); ++f) {
    auto& vertices = result.mesh.face_vertices;
    vertices.insert(vertices.end(), panel(f).begin(), panel(f).end());
    result.mesh.face_offsets.push_back(static_cast<int>(vertices.size()));
  }
  result.mesh.groups = runs_of(groups_, given_);
  result.parents = parents_;
  result.added = added_;
  result.records = records_;
  if (!records_.empty()) result.records.back().straight = panels_with_new_points();
  return result;
}

}  // namespace planish
