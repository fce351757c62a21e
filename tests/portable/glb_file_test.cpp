// SPDX-License-Identifier: MIT
#include "glb_file.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "planish/io/obj.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/mesh_builders.hpp"
#include "support/small_files.hpp"

namespace planish {
namespace {

using testing::same_bits;

struct Made {
  Mesh shown;
  Positions base;
  std::string bytes;
};

Made make_glb(const std::string& design) {
  Made made{*make_sample("trihex", 7), {}, {}};
  made.base = made.shown.positions;
  made.shown.positions.col(5) += Eigen::Vector3d(0.1, 0.0, 1.0 / 3.0);
  made.bytes = assemble_glb(write_obj(made.shown), {made.base, std::nullopt, design});
  return made;
}

OpenedGlb open_or_fail(const std::string& bytes) {
  auto opened = open_glb(bytes);
  EXPECT_TRUE(std::holds_alternative<OpenedGlb>(opened));
  if (auto* glb = std::get_if<OpenedGlb>(&opened)) return std::move(*glb);
  return {};
}

TEST(GlbFile, ADesignOpensAsItsBaseAndWhatMoved) {
  const Made made = make_glb("{}");
  const OpenedGlb opened = open_or_fail(made.bytes);
  EXPECT_EQ(opened.design, "{}");
  EXPECT_EQ(opened.moved, std::vector<int>{5});
  EXPECT_EQ(opened.positions.col(0), made.shown.positions.col(5));
  const ReadResult mesh = read_obj(opened.mesh);
  EXPECT_TRUE(same_bits(std::get<MeshFile>(mesh).mesh.positions, made.base));
}

TEST(GlbFile, WithoutADesignTheMeshItselfOpens) {
  const Made made = make_glb("");
  const OpenedGlb opened = open_or_fail(made.bytes);
  EXPECT_TRUE(opened.moved.empty());
  const ReadResult mesh = read_obj(opened.mesh);
  EXPECT_TRUE(same_bits(std::get<MeshFile>(mesh).mesh, made.shown));
}

TEST(GlbFile, MendsWhatAProgramTook) {
  const std::string apart = write_obj(testing::points_apart(testing::four_panels()));
  const ReadResult whole = read_obj(mended(apart, "joinPoints"));
  EXPECT_EQ(testing::outcome(whole), "9 points, 4 faces");
  const std::string turned =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 3 6 5\n";
  EXPECT_EQ(testing::outcome(read_obj(mended(turned, "orient"))), "6 points, 2 faces");
  EXPECT_EQ(mended("v 0 0", "joinPoints"), "");
  EXPECT_EQ(mended("v 0 0", "orient"), "");
}

TEST(GlbFile, SaysWhatIsWrong) {
  const auto opened = open_glb("no GLB");
  ASSERT_TRUE(std::holds_alternative<std::string>(opened));
  EXPECT_NE(std::get<std::string>(opened), "");
  EXPECT_EQ(mended("v 0 0", "joinTriangles"), "");
  EXPECT_EQ(assemble_glb("v 0 0", {}), "");
  EXPECT_EQ(assemble_glb(write_obj(*make_sample("hex", 5)), {Positions::Zero(3, 1), {}, ""}), "");
}

}  // namespace
}  // namespace planish
