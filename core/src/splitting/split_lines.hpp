// SPDX-License-Identifier: MIT
/// Lines along which panels can be parted: between two corners that are no neighbours.
#pragma once

#include <span>
#include <vector>

#include "planish/cuts/cut.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {

/// A line through a panel of a mesh. It stays what it is while other lines part that panel.
struct SplitLine {
  int panel = 0;
  int from = 0, to = 0;  ///< corners

  friend bool operator==(const SplitLine&, const SplitLine&) = default;
};

/// Lines of each of `panels`: all of one with few corners; else those that cut off one corner,
/// those that halve it, and those from a point of `from`. Whether they lie within the panel is not
/// asked.
/// @param from ascending
[[nodiscard]] std::vector<SplitLine> split_lines(const Mesh& mesh, std::span<const int> panels,
                                                 std::span<const int> from);

/// A line and its images under a symmetry; alone where there is none.
using LineImages = std::vector<SplitLine>;

/// `lines` with all their images; of those that are images of each other the first stands for all.
/// @param symmetry of the mesh; null for none
[[nodiscard]] std::vector<LineImages> lines_with_images(const Mesh& mesh,
                                                        const Adjacency& adjacency,
                                                        std::span<const SplitLine> lines,
                                                        const MeshSymmetry* symmetry);

/// `line` as a cut of `mesh`, which other lines parted already: of the part that has both ends.
/// Panel −1 where none has.
/// @param panels before any line parted one
[[nodiscard]] SplitCut split_along(const Mesh& mesh, const SplitLine& line, int panels);

}  // namespace planish
