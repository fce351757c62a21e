// SPDX-License-Identifier: MIT
/// What every reader promises for every input; a broken promise aborts, and libFuzzer keeps the
/// input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planish/io/mesh_format.hpp"

namespace planish::fuzz {

/// The memory that reading may take: `fixed` bytes and `multiple` times the input.
struct MemoryBound {
  std::size_t fixed, multiple;
};

/// Reads `bytes` and checks:
///  - a refusal is one sentence, without line ends;
///  - an accepted mesh passes check_mesh() again, unchanged;
///  - it comes back from every format to the same bits (every eighth input);
///  - reading held no more memory than the bound.
void check_reader(std::string_view bytes, MeshFormat format, MemoryBound bound);

/// The same for read_glb_design(): the base and the design string survive as well (every eighth).
void check_glb(std::string_view bytes, MemoryBound bound);

/// The same for read_design(): an accepted design keeps its rules, and its text comes back letter
/// for letter once it has been written.
void check_design(std::string_view text, MemoryBound bound);

}  // namespace planish::fuzz
