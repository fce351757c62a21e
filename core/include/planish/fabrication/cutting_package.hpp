// SPDX-License-Identifier: MIT
/// From a mesh to a zip for the workshop: tables, drawings, sheets, a map.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

/// What came of a package; faces by their index.
struct CuttingReport {
  int panels = 0, edges = 0, nodes = 0;
  int drawn = 0;              ///< panels that the drawings show
  double flatness = 0.0;      ///< of the worst panel, mm/m
  double excess = 0.0;        ///< the same, less what rounding accounts for: see FacePlanarity
  std::vector<int> vanished;  ///< the gap leaves nothing of them, or they cross themselves
  std::vector<int> oversize;  ///< larger than a sheet either way
  int sheets = 0;
  double used_fraction = 0.0;  ///< cut area over the area of all sheets; 0 without sheets
};

struct CuttingPackage {
  std::string zip;     ///< see docs/fabrication.md
  std::string header;  ///< package.json without its tables
  CuttingReport report;
};

/// Faces that a package holds at most: one drawing each, in an archive of at most 65,535 files.
inline constexpr int kMostPackagePanels = 60000;

/// @param mesh at most kMostPackagePanels faces; otherwise as for make_cutting_plan()
[[nodiscard]] CuttingPackage write_cutting_package(const Mesh& mesh, const Mesh* base,
                                                   const CuttingOptions& options);

}  // namespace planish
