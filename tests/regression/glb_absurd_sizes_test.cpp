// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdint>

#include "planish/io/gltf.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

/// Panel sizes that are no int (undefined in tinygltf) or whose triangle count wraps in 32 bits,
/// which read behind the end in wasm.
TEST(GlbAbsurdSizes, FallBackToJoiningTriangles) {
  const Mesh mesh = *make_sample("dome", 4);
  const testing::Chunks whole = testing::take_apart(write_glb(mesh));
  for (const nlohmann::json& size :
       {nlohmann::json(1e30), nlohmann::json(-1e30), nlohmann::json(4.5),
        nlohmann::json(1431655768), nlohmann::json("4"), nlohmann::json(2147483647)}) {
    testing::Chunks chunks = whole;
    chunks.json["meshes"][0]["extras"]["polygonSizes"][0] = size;
    EXPECT_NE(testing::error_text(read_glb(testing::put_together(chunks))), "") << size;
    chunks = whole;
    chunks.json["asset"]["extras"]["planish"]["version"] = size;
    EXPECT_EQ(testing::error_text(read_glb(testing::put_together(chunks))), "") << size;
  }
}

}  // namespace
}  // namespace planish
