// SPDX-License-Identifier: MIT
/// Numbers between JavaScript and the core, for all that bind it.
#pragma once

#include <emscripten/val.h>

#include <cstddef>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// A copy that JavaScript owns; a bare view dies when memory grows.
template <class T>
emscripten::val copy(const T* data, std::size_t size) {
  return emscripten::val(emscripten::typed_memory_view(size, data)).call<emscripten::val>("slice");
}

template <class T>
emscripten::val copy(const std::vector<T>& list) {
  return copy(list.data(), list.size());
}

/// 3 numbers a point.
inline emscripten::val copy(const Positions& positions) {
  return copy(positions.data(), static_cast<std::size_t>(positions.size()));
}

/// As a Uint8Array.
inline emscripten::val copy(const std::string& bytes) {
  return copy(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

/// @param numbers 3 a point
inline Positions to_positions(const emscripten::val& numbers) {
  const auto flat = emscripten::convertJSArrayToNumberVector<double>(numbers);
  return Eigen::Map<const Positions>(flat.data(), 3, static_cast<Eigen::Index>(flat.size() / 3));
}

inline std::vector<int> to_indices(const emscripten::val& numbers) {
  return emscripten::convertJSArrayToNumberVector<int>(numbers);
}

/// @param numbers vertex, x, y, z a handle
inline std::vector<Handle> to_handles(const emscripten::val& numbers) {
  const auto flat = emscripten::convertJSArrayToNumberVector<double>(numbers);
  std::vector<Handle> handles;
  for (std::size_t k = 0; k + 3 < flat.size(); k += 4) {
    handles.push_back({static_cast<int>(flat[k]), {flat[k + 1], flat[k + 2], flat[k + 3]}});
  }
  return handles;
}

/// Not checked: the page took the arrays from a session.
inline Mesh to_mesh(const emscripten::val& positions, const emscripten::val& offsets,
                    const emscripten::val& vertices) {
  Mesh mesh;
  mesh.positions = to_positions(positions);
  mesh.face_offsets = to_indices(offsets);
  mesh.face_vertices = to_indices(vertices);
  return mesh;
}

}  // namespace planish
