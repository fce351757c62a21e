// SPDX-License-Identifier: MIT
/// From a mesh to a zip for the workshop: tables, drawings, sheets, a map.
#pragma once

#include <string>

#include "planish/fabrication/cut_items.hpp"
#include "planish/fabrication/labels.hpp"
#include "planish/io/zip.hpp"

namespace planish {

struct CuttingPackage {
  std::string header;  ///< package.json without its tables
  CuttingReport report;
};

/// Faces that a package holds at most: one drawing each, in an archive of at most 65,535 files.
inline constexpr int kMostPackagePanels = 60000;

/// Writes a zip, see docs/fabrication.md, and says what it holds.
/// @param mesh at most kMostPackagePanels faces; otherwise as for make_cutting_plan()
/// @param zip gets the archive in pieces of about a MiB
/// @param code what the labels carry
CuttingPackage write_cutting_package(const Mesh& mesh, const Mesh* base,
                                     const CuttingOptions& options, const ByteSink& zip,
                                     const LinkCode& code = {});

}  // namespace planish
