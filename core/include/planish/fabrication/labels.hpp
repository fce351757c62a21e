// SPDX-License-Identifier: MIT
/// Labels to print and stick on the panels: name, neighbours, and a code that opens the design.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

/// A link and its QR code. The core draws no codes: a library on either side of it does, from these
/// settings, which leave one answer only (ISO/IEC 18004).
struct LinkCode {
  std::string link;        ///< "": there is none
  int size = 0;            ///< modules along a side; 0: the link is too long for a code
  std::vector<char> dark;  ///< size², row by row from the top left: 1 is black

  static constexpr int kMaskPattern = 2;      ///< bytes, error correction M, nothing chosen freely
  static constexpr int kLargestVersion = 30;  ///< 137 modules, 1,370 bytes: 0.34 mm each in print
};

/// Labels on one sheet of A4, 105 × 74 mm each.
inline constexpr int kLabelsPerPage = 8;

/// An HTML page to print at 100 %, one label for each of `faces` in their order; nothing in it
/// runs, and it loads nothing.
[[nodiscard]] std::string write_labels(const CuttingPlan& plan, const std::vector<int>& faces,
                                       const LinkCode& code);

}  // namespace planish
