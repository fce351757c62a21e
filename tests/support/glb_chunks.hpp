// SPDX-License-Identifier: MIT
/// A GLB taken apart and put together again, to damage it on purpose.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace planish::testing {

/// The two chunks of a GLB.
struct Chunks {
  nlohmann::json json;
  std::string binary;
};

/// @param glb as write_glb() gives it
[[nodiscard]] Chunks take_apart(const std::string& glb);
[[nodiscard]] std::string put_together(const Chunks& chunks);

/// Appends 32 bits, little endian.
void append_word(std::string& bytes, std::size_t value);

}  // namespace planish::testing
