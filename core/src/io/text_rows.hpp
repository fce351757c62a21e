// SPDX-License-Identifier: MIT
/// A mesh as lines of text, the way OFF and ASCII PLY share it.
#pragma once

#include <string>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Appends "x y z" of every vertex, then the number of corners and the corners of every face,
/// counted from 0; coordinates are the shortest text that reads back as the same bits.
void append_text_rows(const Mesh& mesh, std::string& text);

}  // namespace planish
