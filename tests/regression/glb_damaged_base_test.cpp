// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "planish/io/gltf.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

/// Found by fuzz_glb: a stored base was handed out unchecked, NaN included.
TEST(GlbDamagedBase, IsLeftOutWithTheDesign) {
  const Mesh mesh = *make_sample("vault", 4);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e200}) {
    GlbContent content;
    content.base = mesh.positions;
    (*content.base)(1, 5) = bad;
    content.design = "recipe";
    const auto result = read_glb_design(write_glb(mesh, content));
    const auto& glb = std::get<GlbFile>(result);
    EXPECT_TRUE(testing::same_bits(glb.file.mesh, mesh));
    EXPECT_FALSE(glb.base);
    EXPECT_EQ(glb.design, "");
    ASSERT_EQ(glb.file.warnings.size(), 1u);
    EXPECT_EQ(glb.file.warnings[0], "the stored design is damaged and is left out");
  }
}

}  // namespace
}  // namespace planish
