// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/io/gltf.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

/// 900 KB of empty materials took 1.7 GB; what is not read is not handed to tinygltf any more, so
/// that a damaged part of it cannot refuse the mesh either.
TEST(GlbManyMaterials, AreNotEvenLookedAt) {
  const Mesh mesh = *make_sample("vault", 4);
  testing::Chunks chunks = testing::take_apart(write_glb(mesh));
  for (const char* key : {"materials", "textures", "images", "animations", "skins", "cameras"}) {
    chunks.json[key] = nlohmann::json(nlohmann::json::array_t(100000, nlohmann::json::object()));
  }
  const ReadResult result = read_glb(testing::put_together(chunks));
  ASSERT_EQ(testing::error_text(result), "");
  EXPECT_TRUE(testing::same_bits(std::get<MeshFile>(result).mesh, mesh));
}

}  // namespace
}  // namespace planish
