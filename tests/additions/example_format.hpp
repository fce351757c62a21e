// SPDX-License-Identifier: MIT
/// The format that additions.json adds: an OBJ behind a line of its own.
#pragma once

#include <string>
#include <string_view>

#include "planish/io/obj.hpp"

namespace planish {

inline constexpr std::string_view kExampleHead = "example\n";

inline ReadResult read_example(std::string_view bytes) {
  if (!bytes.starts_with(kExampleHead)) return ReadError{"the first line is not \"example\""};
  return read_obj(bytes.substr(kExampleHead.size()));
}

inline std::string write_example(const Mesh& mesh) {
  return std::string(kExampleHead) + write_obj(mesh);
}

}  // namespace planish
