// SPDX-License-Identifier: MIT
/// Numbers, lists and answers between JavaScript and the core, for all that bind it.
#pragma once

#include <emscripten/val.h>

#include <cstddef>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/text/refusal.hpp"

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

/// Bytes as a Uint8Array.
inline emscripten::val copy(const std::string& bytes) {
  return copy(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

/// What `value_of` makes of each, as an Array.
template <class List, class Make>
emscripten::val list_of(const List& items, const Make& value_of) {
  emscripten::val list = emscripten::val::array();
  for (std::size_t k = 0; k < items.size(); ++k) list.set(k, value_of(items[k]));
  return list;
}

/// An answer with its `problem`; "" for none.
inline emscripten::val refused(const std::string& sentence) {
  emscripten::val answer = emscripten::val::object();
  answer.set("problem", sentence);
  return answer;
}

/// @returns "" when `operation` is done, else one sentence that says why it is not
template <class Operation>
std::string attempt(const Operation& operation) {
  try {
    return Refusal(operation()).value_or("");
  } catch (const std::bad_alloc&) {
    return "There is not enough memory for this mesh in the browser.";
  } catch (const std::exception& error) {
    return std::string("Internal error: ") + error.what();
  }
}

/// @param numbers 3 a point
inline Positions to_positions(const emscripten::val& numbers) {
  const auto flat = emscripten::convertJSArrayToNumberVector<double>(numbers);
  return Eigen::Map<const Positions>(flat.data(), 3, static_cast<Eigen::Index>(flat.size() / 3));
}

inline Eigen::VectorXd to_vector(const emscripten::val& numbers) {
  const auto flat = emscripten::convertJSArrayToNumberVector<double>(numbers);
  return Eigen::Map<const Eigen::VectorXd>(flat.data(), static_cast<Eigen::Index>(flat.size()));
}

/// Copied in one go: a std::string parameter would be filled byte by byte. @param array Uint8Array
inline std::string to_bytes(const emscripten::val& array) {
  std::string bytes(array["length"].as<std::size_t>(), '\0');
  emscripten::val(
      emscripten::typed_memory_view(bytes.size(), reinterpret_cast<unsigned char*>(bytes.data())))
      .call<void>("set", array);
  return bytes;
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

inline EditTargets to_targets(const emscripten::val& handles, const emscripten::val& pins,
                              int continuation = 0) {
  return {.handles = to_handles(handles),
          .pins = to_indices(pins),
          .supports = {},
          .continuation = continuation};
}

/// A mesh that is not checked: the page took the arrays from a session.
inline Mesh to_mesh(const emscripten::val& positions, const emscripten::val& offsets,
                    const emscripten::val& vertices) {
  Mesh mesh;
  mesh.positions = to_positions(positions);
  mesh.face_offsets = to_indices(offsets);
  mesh.face_vertices = to_indices(vertices);
  return mesh;
}

}  // namespace planish
