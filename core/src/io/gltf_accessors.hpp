// SPDX-License-Identifier: MIT
/// The arrays of a GLB as numbers, each read within the file's data.
#pragma once

#include <vector>

#include "io/tinygltf_api.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// Item `index` of a document's list; throws ReadError where it has none, calling it `what`.
template <class T>
const T& element_of(const std::vector<T>& items, int index, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
    throw ReadError{std::string("the GLB file refers to ") + what + " " + std::to_string(index) +
                    ", which it does not have"};
  }
  return items[static_cast<std::size_t>(index)];
}

/// Points of 3 or rotations of 4 numbers, a column each: floats or, as quantized meshes have them,
/// bytes and shorts, sparse ones too. Throws ReadError naming the accessor.
[[nodiscard]] Eigen::MatrixXd read_vectors(const tinygltf::Model& model, int index, int width);

/// Indices below `vertex_count`, three a triangle; all vertices in order for index −1.
[[nodiscard]] std::vector<int> read_indices(const tinygltf::Model& model, int index,
                                            Eigen::Index vertex_count);

}  // namespace planish
