// SPDX-License-Identifier: MIT
/// From a mesh to a zip for the workshop: tables, drawings, sheets, a map.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/labels.hpp"

namespace planish {

/// What came of a package; faces by their index.
struct CuttingReport : DrawnReport {
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
/// @param code what the labels carry
[[nodiscard]] CuttingPackage write_cutting_package(const Mesh& mesh, const Mesh* base,
                                                   const CuttingOptions& options,
                                                   const LinkCode& code = {});

}  // namespace planish
