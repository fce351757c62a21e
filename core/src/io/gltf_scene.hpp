// SPDX-License-Identifier: MIT
/// The triangles of a GLB's scene, placed by its nodes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/tinygltf_api.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// One TRIANGLES primitive, placed in the model frame.
struct ScenePiece {
  Positions positions;
  std::vector<int> triangles;  ///< indices into positions, checked
  std::optional<std::vector<int>> sizes;
  bool mirrored = false;  ///< its triangles face the other way (glTF 2.0, 3.7.4)
  double rounding = 0.0;  ///< what the file's numbers keep of the positions, model units
};

/// The meshes of the scene in the order of its nodes, morphed by their weights, once an instance; a
/// warning for what is left out. `byte_count` of the file bounds what all of them may hold. Throws
/// ReadError.
[[nodiscard]] std::vector<ScenePiece> collect_pieces(const tinygltf::Model& model,
                                                     std::size_t byte_count,
                                                     std::vector<std::string>& warnings);

}  // namespace planish
