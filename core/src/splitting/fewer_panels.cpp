// SPDX-License-Identifier: MIT
#include "planish/splitting/fewer_panels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <span>
#include <utility>

#include "planish/measures/panel_health.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/numeric/index.hpp"
#include "planish/text/refusal.hpp"
#include "splitting/local_flatness.hpp"

namespace planish {
namespace {

using Outline = std::vector<int>;

/// A mesh whose panels change: an empty outline is a panel that goes.
struct Panels {
  const Mesh& given;
  Positions positions;
  std::vector<Outline> outlines;

  explicit Panels(const Mesh& mesh) : given(mesh), positions(mesh.positions) {
    for (int f = 0; f < mesh.face_count(); ++f) {
      outlines.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    }
  }

  /// Groups keep the panels that are left.
  [[nodiscard]] FewerPanels finished() const {
    FewerPanels fewer;
    fewer.mesh.positions = positions;
    std::vector<int> number(outlines.size() + 1, 0);
    for (std::size_t f = 0; f < outlines.size(); ++f) {
      number[f] = fewer.mesh.face_count();
      if (outlines[f].empty()) continue;
      fewer.mesh.face_vertices.insert(fewer.mesh.face_vertices.end(), outlines[f].begin(),
                                      outlines[f].end());
      fewer.mesh.face_offsets.push_back(static_cast<int>(fewer.mesh.face_vertices.size()));
      fewer.parents.push_back(static_cast<int>(f));
    }
    number.back() = fewer.mesh.face_count();
    for (FaceGroup group : given.groups) {
      group.first_face = number[at(group.first_face)];
      fewer.mesh.groups.push_back(std::move(group));
    }
    return fewer;
  }
};

bool has_side(std::span<const int> outline, int a, int b) {
  for (std::size_t k = 0; k < outline.size(); ++k) {
    if (std::minmax(outline[k], outline[(k + 1) % outline.size()]) == std::minmax(a, b))
      return true;
  }
  return false;
}

/// The corners behind `from` until before `to`, forwards or backwards around.
Outline between(std::span<const int> outline, int from, int to, bool forwards) {
  const std::size_t count = outline.size();
  std::size_t k =
      static_cast<std::size_t>(std::find(outline.begin(), outline.end(), from) - outline.begin());
  Outline corners;
  for (std::size_t step = 0; step < count; ++step) {
    k = (k + (forwards ? 1 : count - 1)) % count;
    if (outline[k] == to) break;
    corners.push_back(outline[k]);
  }
  return corners;
}

/// Both outlines without the run of sides that they share; or why there is not one such run.
std::variant<Outline, std::string> joined_outline(std::span<const int> first,
                                                  std::span<const int> second) {
  const std::size_t count = first.size();
  std::vector<std::size_t> starts;
  std::size_t shared = 0;
  const auto is_shared = [&](std::size_t k) {
    return has_side(second, first[k % count], first[(k + 1) % count]);
  };
  for (std::size_t k = 0; k < count; ++k) {
    if (!is_shared(k)) continue;
    ++shared;
    if (!is_shared(k + count - 1)) starts.push_back(k);
  }
  if (shared == 0) return "the panels have no side in common";
  if (starts.size() != 1) return "the panels have sides in common in more than one place";
  std::size_t last = starts[0];
  while (is_shared(last)) ++last;
  const int from = first[starts[0]], to = first[last % count];
  Outline outline{to};
  const Outline own = between(first, to, from, true);
  outline.insert(outline.end(), own.begin(), own.end());
  outline.push_back(from);
  const Outline backwards = between(second, from, to, false);
  const bool along = std::find(backwards.begin(), backwards.end(),
                               first[(starts[0] + 1) % count]) == backwards.end() &&
                     !(shared == 1 && backwards.empty());
  const Outline others = along ? backwards : between(second, from, to, true);
  outline.insert(outline.end(), others.begin(), others.end());
  if (std::set<int>(outline.begin(), outline.end()).size() != outline.size()) {
    return "the panels touch in another place, too";
  }
  return outline;
}

/// The mesh is as it may be: no side has more panels than before, each panel is as sound as it was.
bool is_sound(const Mesh& before, const FewerPanels& fewer) {
  if (summarize(fewer.mesh).nonmanifold_edges > summarize(before).nonmanifold_edges) return false;
  for (int f = 0; f < fewer.mesh.face_count(); ++f) {
    const auto is = fewer.mesh.face(f);
    const auto was = before.face(fewer.parents[at(f)]);
    if (is.size() != was.size()) {
      const PanelOutline outline = panel_health(fewer.mesh.positions, is).outline;
      if (outline == PanelOutline::kSelfCrossing) return false;
      continue;
    }
    Positions then(3, static_cast<Eigen::Index>(is.size())), now = then;
    Outline corners(is.size());
    for (std::size_t k = 0; k < is.size(); ++k) {
      corners[k] = static_cast<int>(k);
      then.col(static_cast<Eigen::Index>(k)) = before.positions.col(was[k]);
      now.col(static_cast<Eigen::Index>(k)) = fewer.mesh.positions.col(is[k]);
    }
    if (then == now) continue;
    if (panel_damage(then, now, corners) != PanelDamage::kNone) return false;
  }
  return true;
}

std::variant<FewerPanels, std::string> solved(const Panels& panels, std::span<const int> about,
                                              const NearbyOptions& options,
                                              const Progress& progress) {
  FewerPanels fewer = panels.finished();
  auto flat = flat_around(fewer.mesh, about, options, progress);
  if (auto* why = std::get_if<std::string>(&flat)) return std::move(*why);
  fewer.mesh.positions = std::get<Positions>(std::move(flat));
  if (!is_sound(panels.given, fewer)) return "panels around would lose their shape";
  const Positions& before = panels.given.positions;
  for (int v = 0; v < fewer.mesh.vertex_count(); ++v) {
    const double move = (fewer.mesh.positions.col(v) - before.col(v)).norm();
    if (!(move > 0.0)) continue;
    fewer.moved.push_back(v);
    fewer.max_move = std::max(fewer.max_move, move);
  }
  return fewer;
}

/// A side that the strip crosses; `near` stays.
using Crossed = std::array<int, 2>;

/// The other quad at a side; −1 where there is none.
int beyond(const Mesh& mesh, const Adjacency& adjacency, const Crossed& side, int quad) {
  for (const int f : adjacency.faces[side[0]]) {
    if (f != quad && has_side(mesh.face(f), side[0], side[1])) return f;
  }
  return -1;
}

/// Follows the strip from a side through quad f; whether it came back to where it began.
bool follow(const Mesh& mesh, const Adjacency& adjacency, int f, std::vector<int>& quads,
            std::vector<Crossed>& sides) {
  const Crossed first = sides.front();
  Crossed side = first;
  while (f >= 0 && mesh.face(f).size() == 4) {
    const auto quad = mesh.face(f);
    const std::size_t k =
        static_cast<std::size_t>(std::find(quad.begin(), quad.end(), side[0]) - quad.begin());
    const bool forward = quad[(k + 1) % 4] == side[1];
    side = {quad[(k + (forward ? 3 : 1)) % 4], quad[(k + 2) % 4]};
    quads.push_back(f);
    if (side == first) return true;
    sides.push_back(side);
    if (quads.size() > static_cast<std::size_t>(mesh.face_count())) return false;
    f = beyond(mesh, adjacency, side, f);
  }
  return false;
}

/// Where the points of a side meet: in the middle, or on the boundary where one alone is there.
Eigen::Vector3d meeting_place(const Mesh& mesh, const Adjacency& adjacency, const Crossed& side) {
  const bool near = adjacency.boundary[at(side[0])] != 0,
             far = adjacency.boundary[at(side[1])] != 0;
  if (near != far) return mesh.positions.col(side[near ? 0 : 1]);
  return 0.5 * (mesh.positions.col(side[0]) + mesh.positions.col(side[1]));
}

/// Every far point becomes the near one of its side; or why it cannot.
Refusal join_sides(const Adjacency& adjacency, const std::vector<Crossed>& sides, Panels& panels) {
  std::vector<int> name(at(panels.given.vertex_count()));
  for (std::size_t v = 0; v < name.size(); ++v) name[v] = static_cast<int>(v);
  std::set<int> seen;
  for (const Crossed& side : sides) {
    for (const int v : side) {
      if (!seen.insert(v).second) return "the strip meets itself";
    }
    name[at(side[1])] = side[0];
    panels.positions.col(side[0]) = meeting_place(panels.given, adjacency, side);
  }
  for (Outline& outline : panels.outlines) {
    if (outline.empty()) continue;
    for (int& v : outline) v = name[at(v)];
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
    while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
    if (outline.size() < 3)
      return "a triangle at the end of the strip would be left with two corners";
    if (std::set<int>(outline.begin(), outline.end()).size() != outline.size()) {
      return "a panel beside the strip would touch itself";
    }
  }
  return std::nullopt;
}

}  // namespace

std::variant<FewerPanels, std::string> merge_panels(const Mesh& mesh, int panel, int other,
                                                    const NearbyOptions& options,
                                                    const Progress& progress) {
  for (const int f : {panel, other}) {
    if (f < 0 || f >= mesh.face_count()) {
      return "there is no panel " + std::to_string(f) + ": panels are 0 to " +
             std::to_string(mesh.face_count() - 1);
    }
  }
  if (panel == other) return "the panels are the same";
  auto joined = joined_outline(mesh.face(panel), mesh.face(other));
  if (auto* why = std::get_if<std::string>(&joined)) return std::move(*why);
  Panels panels(mesh);
  panels.outlines[at(panel)] = std::get<Outline>(std::move(joined));
  panels.outlines[at(other)].clear();
  const Outline about = panels.outlines[at(panel)];
  return solved(panels, about, options, progress);
}

std::variant<FewerPanels, std::string> collapse_strip(const Mesh& mesh, int from, int to,
                                                      const NearbyOptions& options,
                                                      const Progress& progress) {
  const std::string side_text =
      "the side from " + std::to_string(from) + " to " + std::to_string(to);
  const int most = mesh.vertex_count();
  if (from < 0 || to < 0 || from >= most || to >= most) return "no panel has " + side_text;
  const Adjacency adjacency = build_adjacency(mesh);
  const int first = beyond(mesh, adjacency, {from, to}, -1);
  if (first < 0) return "no panel has " + side_text;
  std::vector<Crossed> sides{{from, to}};
  std::vector<int> quads;
  if (!follow(mesh, adjacency, first, quads, sides)) {
    std::vector<Crossed> back{{from, to}};
    static_cast<void>(
        follow(mesh, adjacency, beyond(mesh, adjacency, {from, to}, first), quads, back));
    sides.insert(sides.end(), back.begin() + 1, back.end());
  }
  if (quads.empty()) return "no quad has " + side_text;
  Panels panels(mesh);
  for (const int f : quads) {
    if (panels.outlines[at(f)].empty()) return "the strip crosses itself";
    panels.outlines[at(f)].clear();
  }
  if (const Refusal why = join_sides(adjacency, sides, panels)) return *why;
  std::vector<int> about;
  about.reserve(sides.size());
  for (const Crossed& side : sides) about.push_back(side[0]);
  return solved(panels, about, options, progress);
}

}  // namespace planish
