// SPDX-License-Identifier: MIT
#include "planish/fabrication/remake.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "fabrication/node_remake.hpp"
#include "planish/fabrication/joints.hpp"
#include "planish/fabrication/panel_frame.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

bool same_point(const Mesh& base, int before, const Mesh& mesh, int after) {
  return std::memcmp(base.positions.col(before).data(), mesh.positions.col(after).data(),
                     3 * sizeof(double)) == 0;
}

/// Whether the k-th corner of a face is as wide as 180°.
bool is_straight(const Mesh& mesh, std::span<const int> face, std::size_t k) {
  const Eigen::Vector3d corner = mesh.positions.col(face[k]);
  const Eigen::Vector3d out = mesh.positions.col(face[(k + 1) % face.size()]) - corner;
  const Eigen::Vector3d in = mesh.positions.col(face[(k + face.size() - 1) % face.size()]) - corner;
  return out.dot(in) < 0.0 && out.cross(in).norm() <= kSameAngle * out.norm() * in.norm();
}

/// Where each side of a panel of the base begins among the corners that it has now: those that it
/// had, and on its sides straight ones. Empty if its outline is another.
std::vector<std::size_t> kept_sides(const Mesh& base, const Mesh& mesh, int panel) {
  const auto before = base.face(panel);
  const auto after = mesh.face(panel);
  std::vector<std::size_t> sides;
  for (std::size_t k = 0; k < after.size(); ++k) {
    if (sides.size() < before.size() && same_point(base, before[sides.size()], mesh, after[k])) {
      sides.push_back(k);
    } else if (k == 0 || !is_straight(mesh, after, k)) {
      return {};
    }
  }
  if (sides.size() < before.size()) sides.clear();
  return sides;
}

/// What became of panels, by their outlines alone.
std::vector<PanelChange> compare_outlines(const Mesh& base, const Mesh& mesh) {
  std::vector<PanelChange> changes(at(mesh.face_count()), PanelChange::kNew);
  for (int f = 0; f < std::min(mesh.face_count(), base.face_count()); ++f) {
    if (!kept_sides(base, mesh, f).empty()) {
      changes[at(f)] = PanelChange::kUnchanged;
    } else if (base.face(f).size() == mesh.face(f).size()) {
      changes[at(f)] = PanelChange::kOutline;
    }
  }
  return changes;
}

bool same_joint(const Joint& before, const Joint& after) {
  const bool met = before.second.panel >= 0;
  const bool meets = after.second.panel >= 0;
  return met == meets && std::abs(before.dihedral - after.dihedral) <= kSameAngle;
}

/// Whether every side of a panel that kept its outline meets what it met, at the same angle.
bool same_joints(const Mesh& base, const JointTable& before, const Mesh& mesh,
                 const JointTable& after, int panel) {
  const auto side_before = at(base.face_offsets[at(panel)]);
  const auto side_after = at(mesh.face_offsets[at(panel)]);
  std::vector<std::size_t> sides = kept_sides(base, mesh, panel);
  sides.push_back(mesh.face(panel).size());
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const Joint& was = before.joints[at(before.of_side[side_before + k])];
    for (std::size_t side = sides[k]; side < sides[k + 1]; ++side) {
      if (!same_joint(was, after.joints[at(after.of_side[side_after + side])])) return false;
    }
  }
  return true;
}

/// The panel beyond side `side` of `face`, and whether it runs along that side the same way; −1
/// where there is none.
struct Neighbour {
  int face = -1;
  bool same_way = false;
};

Neighbour beyond(const Mesh& mesh, const Adjacency& adjacency, int face, std::size_t side) {
  const auto corners = mesh.face(face);
  const int a = corners[side];
  const int b = corners[(side + 1) % corners.size()];
  for (const int other : adjacency.faces[a]) {
    if (other == face) continue;
    const auto ring = mesh.face(other);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const int c = ring[k];
      const int d = ring[(k + 1) % ring.size()];
      if ((c == a && d == b) || (c == b && d == a)) return {other, c == a};
    }
  }
  return {};
}

double dihedral_beyond(const Mesh& mesh, const Positions& positions, int face, std::size_t side,
                       const Neighbour& neighbour) {
  const auto corners = mesh.face(face);
  const Eigen::Vector3d edge =
      positions.col(corners[(side + 1) % corners.size()]) - positions.col(corners[side]);
  const Eigen::Vector3d there = panel_normal(positions, mesh.face(neighbour.face));
  return dihedral(edge, panel_normal(positions, corners),
                  neighbour.same_way ? Eigen::Vector3d(-there) : there);
}

}  // namespace

std::vector<PanelChange> panels_to_remake(const Mesh& base, const Adjacency& adjacency,
                                          const Positions& positions, std::span<const int> moved) {
  std::vector<PanelChange> changes(at(base.face_count()), PanelChange::kUnchanged);
  std::vector<int> cut;
  for (const int v : moved) {
    for (const int f : adjacency.faces[v]) {
      if (changes[at(f)] == PanelChange::kUnchanged) cut.push_back(f);
      changes[at(f)] = PanelChange::kOutline;
    }
  }
  for (const int f : cut) {
    for (std::size_t side = 0; side < base.face(f).size(); ++side) {
      const Neighbour there = beyond(base, adjacency, f, side);
      if (there.face < 0 || changes[at(there.face)] != PanelChange::kUnchanged) continue;
      const double before = dihedral_beyond(base, base.positions, f, side, there);
      const double after = dihedral_beyond(base, positions, f, side, there);
      if (std::abs(before - after) > kSameAngle) changes[at(there.face)] = PanelChange::kBevel;
    }
  }
  return changes;
}

int Remake::count(PanelChange change) const {
  return static_cast<int>(std::count(panels.begin(), panels.end(), change));
}

int Remake::count(NodeChange change) const {
  return static_cast<int>(std::count(nodes.begin(), nodes.end(), change));
}

Remake find_remake(const Mesh& base, const Mesh& mesh) {
  Remake remake;
  remake.panels = compare_outlines(base, mesh);
  const JointTable before = joint_table(base);
  const JointTable after = joint_table(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    PanelChange& change = remake.panels[at(f)];
    if (change == PanelChange::kUnchanged && !same_joints(base, before, mesh, after, f)) {
      change = PanelChange::kBevel;
    }
  }
  remake.nodes = compare_nodes(base, mesh, remake.panels);
  return remake;
}

std::string_view change_name(PanelChange change) {
  switch (change) {
    case PanelChange::kUnchanged:
      return "unchanged";
    case PanelChange::kOutline:
      return "outline";
    case PanelChange::kBevel:
      return "bevel";
    case PanelChange::kNew:
      return "new";
  }
  return "unknown";
}

}  // namespace planish
