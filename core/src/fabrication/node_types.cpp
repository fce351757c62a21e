// SPDX-License-Identifier: MIT
#include "planish/fabrication/node_types.hpp"

#include <Eigen/Geometry>

#include "numeric/trigonometry.hpp"
#include "planish/fabrication/panel_frame.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// In place of a panel's angle where the surface is open: farther from all of them than any
/// tolerance.
constexpr double kOpen = -4.0 * kPi;

/// The panels around one vertex after the other, over the sides that they share.
class NodeWalk {
 public:
  NodeWalk(const Mesh& mesh, const JointTable& joints)
      : mesh_(mesh), joints_(joints), seen_(mesh.face_vertices.size(), 0) {
    normals_.resize(3, mesh.face_count());
    for (int f = 0; f < mesh.face_count(); ++f) {
      normals_.col(f) = panel_normal(mesh.positions, mesh.face(f));
      for (int k = mesh.face_offsets[at(f)]; k < mesh.face_offsets[at(f) + 1]; ++k) {
        face_of_.push_back(f);
      }
    }
  }

  /// @param corners of all panels at the vertex
  [[nodiscard]] FamilyShape cycle(const std::vector<int>& corners) {
    columns_.clear();
    for (const int corner : corners) {
      const bool begins = joint_of(corner).second.panel < 0;  // the boundary lies before it
      if (begins && seen_[at(corner)] == 0) follow(corner);
    }
    for (const int corner : corners) {
      if (seen_[at(corner)] == 0) follow(corner);
    }
    FamilyShape shape(2, static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      shape.col(static_cast<Eigen::Index>(k)) = columns_[k];
    }
    return shape;
  }

 private:
  [[nodiscard]] const Joint& joint_of(int side) const {
    return joints_.joints[at(joints_.of_side[at(side)])];
  }
  [[nodiscard]] int before(int corner) const {
    const int begin = mesh_.face_offsets[at(face_of_[at(corner)])];
    const int end = mesh_.face_offsets[at(face_of_[at(corner)]) + 1];
    return corner > begin ? corner - 1 : end - 1;
  }
  [[nodiscard]] int after(int corner) const {
    const int begin = mesh_.face_offsets[at(face_of_[at(corner)])];
    const int end = mesh_.face_offsets[at(face_of_[at(corner)]) + 1];
    return corner + 1 < end ? corner + 1 : begin;
  }

  /// The angle between the sides at a corner, inside the panel, 0 … 2π.
  [[nodiscard]] double angle(int corner) const {
    const Eigen::Vector3d here = mesh_.positions.col(mesh_.face_vertices[at(corner)]);
    const Eigen::Vector3d in = here - mesh_.positions.col(mesh_.face_vertices[at(before(corner))]);
    const Eigen::Vector3d out = mesh_.positions.col(mesh_.face_vertices[at(after(corner))]) - here;
    const Eigen::Vector3d u = in.stableNormalized(), v = out.stableNormalized();
    return kPi - arctangent(u.cross(v).dot(normals_.col(face_of_[at(corner)])), u.dot(v));
  }

  /// The corner of the next panel anticlockwise: over the side that ends at `corner`; −1 where
  /// there is none, or one that is oriented the other way.
  [[nodiscard]] int next(int corner) const {
    const int side = before(corner);
    const Joint& joint = joint_of(side);
    if (joint.second.panel < 0 || joint.same_way) return -1;
    const int face = face_of_[at(side)];
    const bool is_first =
        joint.first.panel == face && side - mesh_.face_offsets[at(face)] == joint.first.side;
    const PanelSide& other = is_first ? joint.second : joint.first;
    return mesh_.face_offsets[at(other.panel)] + other.side;
  }

  void follow(int start) {
    int corner = start;
    while (corner >= 0 && seen_[at(corner)] == 0) {
      seen_[at(corner)] = 1;
      columns_.emplace_back(angle(corner), joint_of(corner).dihedral);
      const int beyond = next(corner);
      if (beyond < 0) columns_.emplace_back(kOpen, joint_of(before(corner)).dihedral);
      corner = beyond;
    }
  }

  const Mesh& mesh_;
  const JointTable& joints_;
  Positions normals_;
  std::vector<int> face_of_;  ///< of each corner
  std::vector<char> seen_;    ///< 1 for a corner that belongs to a cycle
  std::vector<Eigen::Vector2d> columns_;
};

}  // namespace

std::vector<FamilyShape> node_cycles(const Mesh& mesh, const JointTable& joints) {
  std::vector<std::vector<int>> corners(at(mesh.vertex_count()));
  for (std::size_t k = 0; k < mesh.face_vertices.size(); ++k) {
    corners[at(mesh.face_vertices[k])].push_back(static_cast<int>(k));
  }
  NodeWalk walk(mesh, joints);
  std::vector<FamilyShape> cycles;
  cycles.reserve(corners.size());
  for (const std::vector<int>& around : corners) cycles.push_back(walk.cycle(around));
  return cycles;
}

NodeTypes find_node_types(const Mesh& mesh, const JointTable& joints, double degrees,
                          bool mirrored) {
  NodeTypes types;
  types.of_vertex.assign(at(mesh.vertex_count()), -1);
  std::vector<FamilyShape> shapes;
  std::vector<int> vertices;
  const std::vector<FamilyShape> cycles = node_cycles(mesh, joints);
  for (std::size_t v = 0; v < cycles.size(); ++v) {
    if (cycles[v].cols() == 0) continue;
    shapes.push_back(cycles[v]);
    vertices.push_back(static_cast<int>(v));
  }
  const Families families =
      find_families(shapes, {ShapeMeasure::kCycle, degrees * kPi / 180.0, mirrored});
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    types.of_vertex[at(vertices[k])] = families.members[k].family;
  }
  types.sizes = families.sizes();
  return types;
}

}  // namespace planish
