// SPDX-License-Identifier: MIT
// The one file that knows where the tree lies: all others compile alike in every clone, so that
// ccache knows them there.
#include "support/places.hpp"

namespace planish::testing {

std::string in_tree(const std::string& path) { return std::string(PLANISH_TREE) + "/" + path; }

std::string in_shared_meshes(const std::string& path) {
  return in_tree("../shared/meshes/" + path);
}

}  // namespace planish::testing
