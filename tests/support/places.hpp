// SPDX-License-Identifier: MIT
/// Where the tests find what they read.
#pragma once

#include <string>

namespace planish::testing {

/// A file or folder of the project, by its path in the tree.
[[nodiscard]] std::string in_tree(const std::string& path);

/// One of the meshes that nobody here made; "" names their folder. May be absent.
[[nodiscard]] std::string in_shared_meshes(const std::string& path);

}  // namespace planish::testing
