// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_types.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// The side of `outline` that is longest; the first of those that are equal up to rounding.
Eigen::Index longest_side_of(const Outline& outline) {
  Eigen::Index longest = 0;
  for (Eigen::Index k = 1; k < outline.cols(); ++k) {
    if (side_length(outline, k) > (1.0 + 1e-9) * side_length(outline, longest)) longest = k;
  }
  return longest;
}

/// Lays a template with corner 0 at the origin and x along its longest side, and its members with
/// it.
void lay_flat(PanelType& type, std::vector<FamilyMember>& members) {
  const Eigen::Index side = longest_side_of(type.outline);
  const Eigen::Vector2d corner = type.outline.col(0);
  const Eigen::Vector2d along =
      type.outline.col((side + 1) % type.outline.cols()) - type.outline.col(side);
  const double length = along.norm();
  const Eigen::Vector2d x =
      length > 0.0 ? Eigen::Vector2d(along / length) : Eigen::Vector2d::UnitX();
  Eigen::Matrix2d turn;
  turn << x.x(), x.y(), -x.y(), x.x();
  type.outline = turn * (type.outline.colwise() - corner);
  for (const int panel : type.panels) {
    FamilyMember& member = members[at(panel)];
    member.shift += member.rotation * corner;
    member.rotation = member.rotation * turn.transpose();
  }
}

/// A template where it lies on a panel.
class LaidTemplate {
 public:
  LaidTemplate(const FlatPanel& panel, const PanelTypes& types, int number)
      : panel_(panel),
        member_(types.panels[at(number)]),
        outline_(types.types[at(member_.family)].outline) {}

  /// How far the panel's corner at the end of a side is outside that side of the template.
  /// @param end 0 or 1: where the side begins or ends
  [[nodiscard]] double outside(int side, int end) const {
    const int k = static_cast<int>(outline_.cols());
    const Eigen::Vector2d from = corner(side), along = corner((side + 1) % k) - from;
    const Eigen::Vector2d to_point = panel_.outline.col((side + end) % k) - from;
    const double length = along.norm();
    if (!(length > 0.0)) return to_point.norm();
    return (to_point.x() * along.y() - to_point.y() * along.x()) / length;
  }

 private:
  [[nodiscard]] Eigen::Vector2d corner(int k) const {
    const int column = member_.template_column(k, static_cast<int>(outline_.cols()));
    return member_.rotation * outline_.col(column) + member_.shift;
  }

  const FlatPanel& panel_;
  const FamilyMember& member_;
  const Outline& outline_;
};

SeamWidth seam_width(const std::vector<FlatPanel>& panels, const Joint& joint,
                     const PanelTypes& types) {
  const LaidTemplate first(panels[at(joint.first.panel)], types, joint.first.panel);
  const LaidTemplate second(panels[at(joint.second.panel)], types, joint.second.panel);
  SeamWidth seam;
  for (const int end : {0, 1}) {
    const int there = joint.same_way ? end : 1 - end;
    const double width = types.designed + first.outside(joint.first.side, end) +
                         second.outside(joint.second.side, there);
    seam.min = end == 0 ? width : std::min(seam.min, width);
    seam.max = end == 0 ? width : std::max(seam.max, width);
  }
  return seam;
}

/// Both joints of a seam change evenly along it, so that its ends tell all. [FAM-3]
void measure_seams(const std::vector<FlatPanel>& panels, const JointTable& joints,
                   PanelTypes& types) {
  for (std::size_t k = 0; k < joints.joints.size(); ++k) {
    if (joints.joints[k].second.panel < 0) continue;
    SeamWidth seam = seam_width(panels, joints.joints[k], types);
    seam.joint = static_cast<int>(k);
    const bool first = types.seams.empty();
    types.widths.min = first ? seam.min : std::min(types.widths.min, seam.min);
    types.widths.max = first ? seam.max : std::max(types.widths.max, seam.max);
    types.seams.push_back(seam);
  }
}

}  // namespace

Refusal find_problem(const TypeOptions& options) {
  if (options.joint) {
    const auto [min, max] = *options.joint;
    if (!std::isfinite(max) || !(min >= 0.0) || !(max > min)) {
      return "joint must be two widths, the first at least 0, the second greater";
    }
  } else if (!std::isfinite(options.within) || !(options.within > 0.0)) {
    return "within must be greater than 0";
  }
  if (!(options.degrees > 0.0 && options.degrees <= 90.0)) {
    return "angle must be greater than 0 and at most 90";
  }
  return std::nullopt;
}

PanelTypes find_panel_types(const std::vector<FlatPanel>& panels, const JointTable& joints,
                            const TypeOptions& options) {
  PanelTypes types;
  types.options = options;
  types.within = options.within;
  if (options.joint) {
    // Two corners that meet at a seam are each at most this far off their sides.
    types.within = 0.25 * (options.joint->max - options.joint->min);
    types.designed = 0.5 * (options.joint->max + options.joint->min);
  }
  std::vector<FamilyShape> outlines;
  outlines.reserve(panels.size());
  for (const FlatPanel& panel : panels) outlines.push_back(panel.outline);
  Families families =
      find_families(outlines, {ShapeMeasure::kOutline, types.within, options.mirrored});
  types.panels = std::move(families.members);
  types.alignments = families.alignments;
  for (Family& family : families.families) {
    types.types.push_back({std::move(family.shape), std::move(family.members), family.worst});
    lay_flat(types.types.back(), types.panels);
  }
  measure_seams(panels, joints, types);
  return types;
}

}  // namespace planish
