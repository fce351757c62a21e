// SPDX-License-Identifier: MIT
/// Stanford PLY: text and both binary byte orders.
#pragma once

#include <string>
#include <string_view>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// How a PLY file stores its values.
enum class PlyEncoding { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

/// Reads element `vertex` (x, y, z of any number type) and element `face` (vertex_indices or
/// vertex_index); all other elements and properties are passed over. A text file whose rows hold
/// more than the header declares is read a row a line, with a warning, as is one whose header
/// begins with a line that is no statement. The result has passed
/// repair_and_check(); an error names the line (header, ASCII) or the element.
/// @param bytes the file, up to 2 GiB; its counts are checked against what is there
[[nodiscard]] ReadResult read_ply(std::string_view bytes);

/// Coordinates as doubles, the same bits in every encoding; groups have no place in the format.
[[nodiscard]] std::string write_ply(const Mesh& mesh,
                                    PlyEncoding encoding = PlyEncoding::kBinaryLittleEndian);

}  // namespace planish
