// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "planish/io/gltf.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

/// 2,000 primitives over one accessor: memory was asked for before it was counted.
TEST(GlbRepeatedPrimitives, AreRefusedBeforeTheyTakeMemory) {
  testing::Chunks chunks = testing::take_apart(write_glb(*make_sample("vault", 40)));
  nlohmann::json& primitives = chunks.json["meshes"][0]["primitives"];
  const nlohmann::json one = primitives[0];
  for (int k = 0; k < 2000; ++k) primitives.push_back(one);
  EXPECT_EQ(testing::error_text(read_glb(testing::put_together(chunks))),
            "the GLB file repeats its meshes too often");
}

}  // namespace
}  // namespace planish
