// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <string>

#include "planish/io/gltf.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

/// NaN has no order, so joining equal points could swap a NaN point for another one and accept it.
TEST(GlbNanWeld, ANanInForeignTrianglesIsRefused) {
  const testing::Chunks whole = testing::take_apart(write_glb(*make_sample("vault", 4)));
  for (std::size_t v = 0; v < 16; ++v) {
    testing::Chunks chunks = whole;
    chunks.json["asset"].erase("extras");
    chunks.json["meshes"][0].erase("extras");
    constexpr float kBad = std::numeric_limits<float>::quiet_NaN();
    const std::array<float, 3> bad{kBad, kBad, kBad};
    std::memcpy(chunks.binary.data() + 12 * v, bad.data(), sizeof bad);
    EXPECT_EQ(testing::error_text(read_glb(testing::put_together(chunks))),
              "vertex " + std::to_string(v) + " has the coordinate nan, which is not finite");
  }
}

}  // namespace
}  // namespace planish
