// SPDX-License-Identifier: MIT
/// The structure for a building model: IFC4, a curtain wall of plates.
#pragma once

#include <string>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

struct IfcModel {
  std::string text;
  std::string header;  ///< JSON: what a package's header says of panels
  DrawnReport report;
};

/// An IFC4 file (ISO 10303-21): one IfcCurtainWall that holds one IfcPlate for each panel that
/// `plan` draws, named as in the package. Without gap and thickness a plate is the panel itself,
/// one IfcPolygonalFaceSet with as many corners as the panel has, all over one list of points:
/// panels share them. With a gap the plate's outline is the one that is cut; with a thickness it is
/// extruded inwards, its outside face being the panel. A panel that the gap leaves nothing of is
/// left out; its number stays. Where `plan` has types, each is an IfcPlateType of that name, to
/// which its plates belong. Identifiers follow from the hash of the base and the panel's, or the
/// type's, number alone: an edit of the same base, exported again, has the same ones.
[[nodiscard]] IfcModel write_ifc(const CuttingPlan& plan);

}  // namespace planish
