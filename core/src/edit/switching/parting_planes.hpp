// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "engines/active_set.hpp"
#include "planish/constraints/mesh_keep_outs.hpp"

namespace planish {

/// Where a vertex of a design is, in solver units.
using PlacesOf = std::function<std::function<Eigen::Vector3d(int)>(const ExactDesign&)>;

/// The planes between boxes and panels, and between two panels: others where the panels have
/// turned. [KEE-3]
class PartingPlanes : public SwitchingConstraint {
 public:
  PartingPlanes(MeshKeepOuts& keep_outs, PlacesOf places_of)
      : keep_outs_(keep_outs), places_of_(std::move(places_of)) {}

  void reset() override { keep_outs_.open(); }
  /// A drag may have gone back to `last`.
  void resume(const ExactDesign& last) override { (void)update(last); }
  bool update(const ExactDesign& design) override {
    return keep_outs_.choose_planes(design.faces, places_of_(design));
  }
  [[nodiscard]] bool may_switch() const override { return keep_outs_.has_turning_planes(); }
  [[nodiscard]] int most_rounds() const override { return kMostRestTurns; }

 private:
  MeshKeepOuts& keep_outs_;
  PlacesOf places_of_;
};

/// The pairs of panels, and of panels and walls, that have a plane between them: those that touch
/// in the base, and each that an edit was seen to go through. An edit that needs a new one is made
/// again from the base. [KEE-4] [KEE-5]
class PartedPanels : public SwitchingConstraint {
 public:
  PartedPanels(MeshKeepOuts& keep_outs, PlacesOf places_of)
      : keep_outs_(keep_outs), places_of_(std::move(places_of)) {}

  void reset() override { keep_outs_.forget_parted(); }
  /// @returns whether a panel may have gone through another: it has a plane to that one now
  bool update(const ExactDesign& design) override {
    return keep_outs_.part_panels(design.faces, places_of_(design));
  }
  [[nodiscard]] bool may_switch() const override { return true; }
  [[nodiscard]] int most_rounds() const override { return 12; }

 private:
  MeshKeepOuts& keep_outs_;
  PlacesOf places_of_;
};

}  // namespace planish
