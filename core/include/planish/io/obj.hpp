// SPDX-License-Identifier: MIT
/// Wavefront OBJ: polygons of any size, as text.
#pragma once

#include <string>
#include <string_view>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// Reads `v` and `f` (with or without /vt/vn, negative indices too) and keeps `g` and `o` as
/// groups; colours after the coordinates and every other statement are passed over. A backslash at
/// the end of a line joins the next one to it, except in a comment or before a statement. Faces may
/// stand before their vertices. The result has passed repair_and_check(); an error names the line.
/// @param bytes the file, up to 2 GiB
[[nodiscard]] ReadResult read_obj(std::string_view bytes);

/// `v`, `g` and `f` lines, `o` for a name with blanks; coordinates read back to the same bits.
[[nodiscard]] std::string write_obj(const Mesh& mesh);

}  // namespace planish
