// SPDX-License-Identifier: MIT
/// What types of panels promise, measured without the product's code: planes and alignments by
/// singular values, seams by lines in space.
#pragma once

#include "planish/fabrication/panel_types.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish::testing {

/// The panels and joints of a mesh, sorted into types.
[[nodiscard]] PanelTypes types_of(const Mesh& mesh, const TypeOptions& options);

/// At most `share` of the mean edge apart.
[[nodiscard]] PanelTypes types_within(const Mesh& mesh, double share, bool mirrored = false);

/// The largest distance of a corner from the template's after the best motion over all first
/// corners, over all panels; turned over only where the options allow it.
[[nodiscard]] double worst_fit(const Mesh& mesh, const PanelTypes& types);

/// The least and the most that joints are wide, and how far the widths that the types tell of a
/// seam are off, at most.
struct SeamCheck {
  double min = 0.0, max = 0.0, error = 0.0;
  int seams = 0;
};
[[nodiscard]] SeamCheck check_seams(const Mesh& mesh, const PanelTypes& types);

/// Every panel in one type, in order, counted as they say; fails the test where not.
void expect_partition(const Mesh& mesh, const PanelTypes& types);

/// The same mesh with points, panels and first corners in another order.
[[nodiscard]] Mesh renumbered(const Mesh& mesh, unsigned seed);

}  // namespace planish::testing
