// SPDX-License-Identifier: MIT
/// Four panels around a point, as the files of others have them.
#pragma once

#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish::testing {

/// 9 points in 3 rows, 4 quads, folded.
[[nodiscard]] Mesh four_panels();

/// Each face of `mesh` with points of its own, in the order of its corners.
[[nodiscard]] Mesh points_apart(const Mesh& mesh);

/// `v` lines of four_panels(), and its faces as "1 2 5 4".
[[nodiscard]] std::string four_panel_vertices();
[[nodiscard]] const std::vector<std::string>& four_panel_faces();

/// "9 points, 4 faces", and the warnings, each behind " | "; the sentence of a refusal.
[[nodiscard]] std::string outcome(const ReadResult& result);

/// "a:0 b:2" of a mesh that was read: names with '_' for blanks and first faces of its groups.
[[nodiscard]] std::string group_text(const ReadResult& result);

}  // namespace planish::testing
