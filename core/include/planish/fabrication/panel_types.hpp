// SPDX-License-Identifier: MIT
/// Which panels are alike enough to be cut alike: types, a template for each, and what becomes of
/// the joints when templates are cut instead of panels.
#pragma once

#include <optional>
#include <vector>

#include "planish/fabrication/flat_panel.hpp"
#include "planish/fabrication/joints.hpp"
#include "planish/families/families.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// The widths between which the joint of two panels may vary, ≥ 0.
struct JointRange {
  double min = 0.0, max = 0.0;
};

struct TypeOptions {
  double within = 0.0;              ///< > 0: how far a corner may be from the template's
  std::optional<JointRange> joint;  ///< then `within` is a quarter of what lies between
  bool mirrored = false;            ///< a panel may be its template turned over
  double degrees = 0.5;             ///< > 0: how far angles at nodes and bars of a type differ
};

/// The first rule that `options` breaks, naming its field; nullopt if none.
[[nodiscard]] Refusal find_problem(const TypeOptions& options);

/// Everything cut from one template.
struct PanelType {
  Outline outline;          ///< the template: corner 0 at the origin, x along its longest side
  std::vector<int> panels;  ///< ascending
  double worst = 0.0;       ///< the largest distance of a corner from the template's
};

/// The joint of two panels along their edge, where the templates are cut with half of the designed
/// joint off every side and laid where they fit their panels best.
struct SeamWidth {
  int joint = 0;  ///< of the JointTable
  double min = 0.0, max = 0.0;
};

struct PanelTypes {
  TypeOptions options;
  double within = 0.0;               ///< that the types keep
  double designed = 0.0;             ///< joint, the middle of options.joint; 0 without
  std::vector<PanelType> types;      ///< the one with most panels first
  std::vector<FamilyMember> panels;  ///< how each lies on the template, in its own coordinates
  std::vector<SeamWidth> seams;      ///< one an edge between two panels
  SeamWidth widths;                  ///< of all seams: the least and the most; of `joint` nothing
  long long alignments = 0;          ///< see Families
};

/// Sorts panels into types. No corner is farther than `within` from that of its template, and with
/// options.joint every seam stays in it. [FAM-1, FAM-3]
/// @param joints of the mesh of `panels`; @param options must have no problem
[[nodiscard]] PanelTypes find_panel_types(const std::vector<FlatPanel>& panels,
                                          const JointTable& joints, const TypeOptions& options);

}  // namespace planish
