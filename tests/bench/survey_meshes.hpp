// SPDX-License-Identifier: MIT
/// The meshes that benchmarks go over: samples, and the real ones where they are there.
#pragma once

#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish::bench {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

[[nodiscard]] std::vector<NamedMesh> samples_and_real_meshes();

/// By project_to_planar().
[[nodiscard]] Mesh made_flat(const Mesh& mesh);

}  // namespace planish::bench
