// SPDX-License-Identifier: MIT
/// The indices of a mesh are int, as in its file formats; those of the containers are std::size_t.
#pragma once

#include <cassert>
#include <cstddef>

namespace planish {

/// A vertex, face or row as the index of a container. `index` is not negative.
constexpr std::size_t at(int index) {
  assert(index >= 0);
  return static_cast<std::size_t>(index);
}

/// A column or row of an Eigen matrix as an index of a list.
constexpr std::size_t at(std::ptrdiff_t index) {
  assert(index >= 0);
  return static_cast<std::size_t>(index);
}

}  // namespace planish
