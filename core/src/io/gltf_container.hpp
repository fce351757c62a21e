// SPDX-License-Identifier: MIT
/// The first look at a GLB: everything that tinygltf takes on trust.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "io/tinygltf_api.hpp"

namespace planish {

/// Parses `bytes` after checking the container, the depth of its JSON (tinygltf recurses) and that
/// it refers to its own data only. The sentence says what is wrong. Accessors are not checked yet.
[[nodiscard]] std::variant<tinygltf::Model, std::string> load_glb_model(std::string_view bytes);

}  // namespace planish
