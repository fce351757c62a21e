// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/io/gltf.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

/// Found by fuzz_glb: a mesh so small, or so small for its place, that float32 steps show was taken
/// for one that another program had changed, and its design was dropped.
TEST(GlbTinyMesh, ReopensToTheSameBits) {
  for (const double offset : {0.0, 1.0, 1e7}) {
    for (const double scale : {1e-45, 1e-40, 1e-20, 1e-12, 1e-8, 1e-6}) {
      Mesh mesh = *make_sample("dome", 5);
      mesh.positions *= scale;
      mesh.positions.array() += offset;
      mesh.positions(0, 0) += 1e-8 * (1.0 + offset);  // not all in one point
      const auto result =
          read_glb_design(write_glb(mesh, {.base = {}, .variations = {}, .design = "d"}));
      const auto* glb = std::get_if<GlbFile>(&result);
      ASSERT_NE(glb, nullptr);
      EXPECT_TRUE(testing::same_bits(glb->file.mesh, mesh)) << offset << " " << scale;
      EXPECT_EQ(glb->design, "d") << offset << " " << scale;
    }
  }
}

}  // namespace
}  // namespace planish
