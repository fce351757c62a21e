// SPDX-License-Identifier: MIT
/// Object File Format: counts, points, faces, as text.
#pragma once

#include <string>
#include <string_view>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// Reads ASCII OFF and its variants with colours, normals or texture coordinates (COFF, NOFF,
/// STOFF …), which are passed over. Comments, blank lines, the keyword in small letters, counts on
/// its line or glued to it are accepted; faces may go on in the next line, and a file without
/// colours may be broken into lines anywhere. A file whose indices run from 1 to the number of
/// vertices is read as counting from 1, with a warning. The result has passed repair_and_check();
/// an error names the line.
/// @param bytes the file, up to 2 GiB
[[nodiscard]] ReadResult read_off(std::string_view bytes);

/// Coordinates read back to the same bits; groups have no place in the format.
[[nodiscard]] std::string write_off(const Mesh& mesh);

}  // namespace planish
