// SPDX-License-Identifier: MIT
/// The faces of a mesh by themselves, so that one can change its corners or go.
#pragma once

#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

struct SeparateFaces {
  std::vector<std::vector<int>> corners;
  std::vector<char> left_out;  ///< one a face
};

[[nodiscard]] SeparateFaces separate_faces(const Mesh& mesh);

/// The faces that are left, in their order, over all points; a group without faces goes.
[[nodiscard]] Mesh with_faces(Mesh mesh, const SeparateFaces& faces);

}  // namespace planish
