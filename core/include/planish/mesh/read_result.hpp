// SPDX-License-Identifier: MIT
/// What a reader returns: a mesh with its warnings, or one sentence that names the place.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

struct MeshFile {
  Mesh mesh;
  std::vector<std::string> warnings;  ///< one sentence each: what was found, what was done about it
};

/// One clear sentence with the line or face, for example "line 7: the coordinate "nan" is not
/// finite".
struct ReadError {
  std::string message;
};

using ReadResult = std::variant<MeshFile, ReadError>;

}  // namespace planish
