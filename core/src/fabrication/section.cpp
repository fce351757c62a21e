// SPDX-License-Identifier: MIT
#include "planish/fabrication/section.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "planish/fabrication/panel_frame.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A stretch of the section across one panel, from edge to edge.
struct Crossing {
  int panel = 0;
  std::array<int, 2> joints = {0, 0};
};

class SectionCut {
 public:
  SectionCut(const Mesh& mesh, const JointTable& joints, const SectionPlane& plane)
      : mesh_(mesh),
        joints_(joints),
        plane_(plane),
        heights_((plane.normal.transpose() * mesh.positions).array() - plane.offset),
        points_(Positions::Zero(3, static_cast<Eigen::Index>(joints.joints.size()))) {
    for (std::size_t k = 0; k < joints.joints.size(); ++k) {
      if (is_cut(joints.joints[k]))
        points_.col(static_cast<Eigen::Index>(k)) = point_on(joints.joints[k]);
    }
    for (int f = 0; f < mesh.face_count(); ++f) cross_panel(f);
    crossings_at_.resize(joints.joints.size());
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      for (const int joint : crossings_[k].joints) crossings_at_[at(joint)].push_back(k);
    }
  }

  /// First the lines that end somewhere, then the rings.
  std::vector<SectionLine> lines() {
    used_.assign(crossings_.size(), 0);
    std::vector<SectionLine> lines;
    for (std::size_t joint = 0; joint < crossings_at_.size(); ++joint) {
      if (crossings_at_[joint].size() == 2) continue;
      for (const std::size_t k : crossings_at_[joint]) {
        if (used_[k] == 0) add_line(lines, static_cast<int>(joint), k);
      }
    }
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      if (used_[k] == 0) add_line(lines, crossings_[k].joints[0], k);
    }
    return lines;
  }

 private:
  bool is_above(int vertex) const { return heights_[vertex] >= 0.0; }
  bool is_cut(const Joint& joint) const { return is_above(joint.from) != is_above(joint.to); }

  /// Where the plane meets a joint: one point for every panel there, to the bit.
  Eigen::Vector3d point_on(const Joint& joint) const {
    const double a = heights_[joint.from];
    const double t = a / (a - heights_[joint.to]);
    const Eigen::Vector3d start = mesh_.positions.col(joint.from);
    const Eigen::Vector3d end = mesh_.positions.col(joint.to);
    return t <= 0.5 ? Eigen::Vector3d(start + t * (end - start))
                    : Eigen::Vector3d(end + (1.0 - t) * (start - end));
  }

  /// The cut sides of a panel, sorted along the plane: the section is inside between the first two,
  /// the next two, and so on.
  void cross_panel(int face) {
    std::vector<int> cut;
    const auto first_side = at(mesh_.face_offsets[at(face)]);
    for (std::size_t k = 0; k < mesh_.face(face).size(); ++k) {
      const int joint = joints_.of_side[first_side + k];
      if (is_cut(joints_.joints[at(joint)])) cut.push_back(joint);
    }
    if (cut.size() > 2) {
      const Eigen::Vector3d along =
          panel_normal(mesh_.positions, mesh_.face(face)).cross(plane_.normal);
      std::stable_sort(cut.begin(), cut.end(), [&](int a, int b) {
        return along.dot(points_.col(a)) < along.dot(points_.col(b));
      });
    }
    for (std::size_t k = 0; k + 1 < cut.size(); k += 2) {
      crossings_.push_back({face, {cut[k], cut[k + 1]}});
    }
  }

  void add_line(std::vector<SectionLine>& lines, int joint, std::size_t crossing) {
    std::vector<Eigen::Vector3d> points{points_.col(joint)};
    SectionLine line;
    const int start = joint;
    while (true) {
      used_[crossing] = 1;
      const Crossing& stretch = crossings_[crossing];
      joint = stretch.joints[0] == joint ? stretch.joints[1] : stretch.joints[0];
      if (points_.col(joint) != points.back()) {
        points.emplace_back(points_.col(joint));
        line.panels.push_back(stretch.panel);
      }
      const std::vector<std::size_t>& here = crossings_at_[at(joint)];
      if (joint == start || here.size() != 2) break;
      crossing = here[0] == crossing ? here[1] : here[0];
      if (used_[crossing] != 0) break;
    }
    line.closed = joint == start && crossings_at_[at(joint)].size() == 2;
    if (line.closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
    if (points.size() < 2) return;  // it touches a corner
    line.points.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t k = 0; k < points.size(); ++k) {
      line.points.col(static_cast<Eigen::Index>(k)) = points[k];
    }
    lines.push_back(std::move(line));
  }

  const Mesh& mesh_;
  const JointTable& joints_;
  const SectionPlane& plane_;
  Eigen::RowVectorXd heights_;  ///< of vertices above the plane
  Positions points_;            ///< one a joint; meaningful where it is cut
  std::vector<Crossing> crossings_;
  std::vector<std::vector<std::size_t>> crossings_at_;  ///< by joint
  std::vector<char> used_;                              ///< by crossing
};

}  // namespace

std::vector<SectionLine> cut_by(const Mesh& mesh, const JointTable& joints,
                                const SectionPlane& plane) {
  return SectionCut(mesh, joints, plane).lines();
}

}  // namespace planish
