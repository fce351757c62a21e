// SPDX-License-Identifier: MIT
#include "planish/io/obj.hpp"

#include <gtest/gtest.h>

#include <string>

#include "planish/mesh/mesh_check.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::error_text;
using testing::same_bits;
using testing::shared_mesh_bytes;
using testing::warning_text;

constexpr const char* kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh obj_mesh(const std::string& text) {
  ReadResult result = read_obj(text);
  EXPECT_EQ(error_text(result), "");
  if (auto* file = std::get_if<MeshFile>(&result)) return file->mesh;
  return {};
}

TEST(Obj, WritesWhatReadsBackToTheSameBits) {
  Mesh mesh = testing::awkward_mesh();
  mesh.groups = {{"north roof", 1}, {"", 2}};
  EXPECT_TRUE(same_bits(mesh, obj_mesh(write_obj(mesh))));
}

TEST(Obj, WritesTheShortestFormThatKeepsTheBits) {
  const Mesh mesh = testing::make_mesh({{0.1, 2, 0}, {1.5, 0, 0}, {0, 1e-9, 0}}, {{0, 1, 2}});
  const std::string text = write_obj(mesh);
  EXPECT_NE(text.find("v 0.1 2 0\nv 1.5 0 0\nv 0 1e-09 0\nf 1 2 3\n"), std::string::npos) << text;
}

TEST(Obj, ReadsEveryWayToWriteACorner) {
  for (const char* face : {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1",
                           "f 1/1/1 2/2/1 3/3/1 4/4/1", "f 1// 2// 3// 4//", "f -4 -3 -2 -1",
                           "f 1 2 \\\n3 4", "f +1 2 3 4 # a comment", "\tf  1\t2 3 4  \r"}) {
    const Mesh mesh = obj_mesh(kQuad + std::string(face));
    EXPECT_EQ(mesh.face_vertices, (std::vector<int>{0, 1, 2, 3})) << face;
  }
}

TEST(Obj, ReadsNumbersExactly) {
  const Mesh mesh = obj_mesh(
      "v +1.0000E+03 .5 -7.\nv 0.1000000000000000055511151231257827 9007199254740993 1e-400 0.3 .2 "
      "1\nv 8.98846567431158e29 4.9406564584124654e-324 0 1.0\nf 1 2 3");
  EXPECT_EQ(mesh.positions.col(0), Eigen::Vector3d(1000, 0.5, -7));
  EXPECT_EQ(mesh.positions.col(1), Eigen::Vector3d(0.1, 9007199254740992.0, 0));
  EXPECT_EQ(mesh.positions.col(2), Eigen::Vector3d(8.98846567431158e29, 5e-324, 0));
}

TEST(Obj, KeepsGroupsThatHaveFaces) {
  const Mesh mesh = obj_mesh(std::string("o house\n") + kQuad +
                             "g gone\ng roof west#2\nf 1 2 3\ng wall\nf 1 3 4\ng end\n");
  ASSERT_EQ(mesh.groups.size(), 2u);
  EXPECT_EQ(mesh.groups[0].name, "roof west#2");
  EXPECT_EQ(mesh.groups[1].first_face, 1);
  EXPECT_TRUE(same_bits(mesh, obj_mesh(write_obj(mesh))));
}

TEST(Obj, FacesMayStandBeforeTheirVertices) {
  EXPECT_EQ(obj_mesh(std::string("f 1 2 3 4\n") + kQuad).face_count(), 1);
}

TEST(Obj, EveryRefusalNamesTheLine) {
  const auto refusal = [](const std::string& text) { return error_text(read_obj(text)); };
  EXPECT_EQ(refusal("# a\nv 1,5 0 0"),
            "line 2: the coordinate \"1,5\" has a comma; coordinates need a decimal point and "
            "spaces between them");
  EXPECT_EQ(refusal("v 0 nan 0"), "line 1: the coordinate \"nan\" is not finite");
  EXPECT_EQ(refusal("v 0 1e999 0"), "line 1: the coordinate \"1e999\" is not finite");
  EXPECT_EQ(refusal("v 0 1"), "line 1: a vertex needs 3 coordinates, here are 2");
  EXPECT_EQ(refusal("v 0 0x10 1"), "line 1: \"0x10\" is not a coordinate");
  const std::string quad = kQuad;
  EXPECT_EQ(refusal(quad + "f 0 1 2"), "line 5: a face uses index 0, but OBJ counts from 1");
  EXPECT_EQ(refusal(quad + "f 1 2 9"),
            "line 5: a face uses vertex 9 (from 1), but the file has 4 vertices");
  EXPECT_EQ(refusal(quad + "f 1 2 -5"),
            "line 5: the relative index -5 points before the first vertex");
  EXPECT_EQ(refusal(quad + "f 1 2 99999999999"), "line 5: the index \"99999999999\" is too large");
  EXPECT_EQ(refusal(quad + "f 1 2 a"), "line 5: \"a\" is not a face corner");
  EXPECT_EQ(refusal(quad + "f"), "line 5: face 1 has 0 vertices; it needs 3 or more");
  EXPECT_EQ(refusal(quad + "f 1 2 3 1 4 3"), "line 5: face 1 uses vertex 1 twice (from 1)");
  EXPECT_EQ(refusal(quad + std::string("\x01", 1)), "line 5: the file is not text");
  EXPECT_EQ(refusal("v 1e120 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3"),
            "line 1: vertex 1 (from 1) has the coordinate 1e+120, which is larger than 1e100");
}

TEST(Obj, FilesWithoutAMeshAreRefused) {
  EXPECT_EQ(error_text(read_obj("")), "the file is empty");
  EXPECT_EQ(error_text(read_obj("# hello\n")), "the file holds no vertices (no \"v\" lines)");
  EXPECT_EQ(error_text(read_obj(kQuad)), "the file holds no faces (no \"f\" lines)");
}

/// What each shared nasty file must give: vertices and faces, or a piece of the refusal.
struct NastyCase {
  const char* name;
  int vertices, faces;  ///< 0 if refused
  const char* words;    ///< in the refusal, or in a warning; "" for none at all
};

class NastyObj : public ::testing::TestWithParam<NastyCase> {};

TEST_P(NastyObj, LoadsOrIsRefusedInOneSentence) {
  const NastyCase& expected = GetParam();
  const auto bytes = shared_mesh_bytes(std::string("nasty/") + expected.name + ".obj");
  if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
  const ReadResult result = read_obj(*bytes);
  if (expected.faces == 0) {
    EXPECT_NE(error_text(result).find(expected.words), std::string::npos) << error_text(result);
    return;
  }
  ASSERT_EQ(error_text(result), "");
  const Mesh& mesh = std::get<MeshFile>(result).mesh;
  EXPECT_EQ(mesh.vertex_count(), expected.vertices);
  EXPECT_EQ(mesh.face_count(), expected.faces);
  if (std::string(expected.words).empty()) {
    EXPECT_EQ(warning_text(result), "");
  } else {
    EXPECT_NE(warning_text(result).find(expected.words), std::string::npos) << warning_text(result);
  }
  EXPECT_TRUE(same_bits(mesh, obj_mesh(write_obj(mesh))));
}

INSTANTIATE_TEST_SUITE_P(
    Files, NastyObj,
    ::testing::Values(
        NastyCase{"real_crlf_normals", 1369, 1296, ""},
        NastyCase{"real_crlf_trailing_slashes", 209, 188, ""},
        NastyCase{"real_lines_only", 0, 0, "no faces"},
        NastyCase{"real_nonmanifold_edge_fan", 0, 0, "is shared by 3 faces, among them"},
        NastyCase{"binary_junk", 0, 0, "line 1: the file is not text"},
        NastyCase{"bowtie_quad", 4, 1, "face encloses no area"},
        NastyCase{"comma_decimals", 0, 0, "line 1: the coordinate \"0,000000\" has a comma"},
        NastyCase{"comments_only", 0, 0, "no vertices"}, NastyCase{"crlf", 25, 16, ""},
        NastyCase{"duplicate_vertices", 64, 16, "39 vertices lie exactly where"},
        NastyCase{"empty", 0, 0, "empty"}, NastyCase{"exponents", 25, 16, ""},
        NastyCase{"faces_before_vertices", 25, 16, ""}, NastyCase{"folded_flat", 6, 2, ""},
        NastyCase{"inconsistent_orientation", 25, 16, "opposite orientation"},
        NastyCase{"isolated_vertices", 27, 16, "2 vertices belong to no face (first: vertex 0)"},
        NastyCase{"moebius_quads", 36, 24, "the surface has one side only"},
        NastyCase{"nan_coord", 0, 0, "line 7: the coordinate \"nan\" is not finite"},
        NastyCase{"no_final_newline", 25, 16, ""},
        NastyCase{"nonmanifold_edge", 0, 0, "shared by 3 faces"},
        NastyCase{"relative_indices", 64, 16, "39 vertices"},
        NastyCase{"repeated_index_face", 25, 17, "twice"}, NastyCase{"tiny_scale", 25, 16, ""},
        NastyCase{"vertex_colours", 25, 16, ""}, NastyCase{"vertices_only", 0, 0, "no faces"},
        NastyCase{"vt_vn", 25, 16, ""}, NastyCase{"zero_area_quad", 6, 2, "encloses no area"},
        NastyCase{"zero_index", 0, 0, "uses index 0"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Obj, EverySharedMeshSurvivesTheRoundTrip) {
  for (const char* name : {"pq_conical_saddle", "mixed345_airport", "hex_minsurface_messy",
                           "kagome_from_tri_mesh", "polyhedron_truncated_cuboct", "quad_heart",
                           "nasty/utm_offset_conical", "nasty/real_selfcrossing_quads"}) {
    const auto bytes = shared_mesh_bytes(std::string(name) + ".obj");
    if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
    const Mesh mesh = obj_mesh(*bytes);
    EXPECT_GT(mesh.face_count(), 0) << name;
    EXPECT_TRUE(same_bits(mesh, obj_mesh(write_obj(mesh)))) << name;
  }
}

/// Any cut of a file gives a mesh or a sentence; nothing else may happen.
TEST(Obj, EveryTruncationIsAMeshOrASentence) {
  const std::string whole = "o a\n" + std::string(kQuad) + "f 1/1/1 2//3 -2 4 \\\n # x\nf 1 3 4\n";
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    const ReadResult result = read_obj(std::string_view(whole).substr(0, length));
    if (std::holds_alternative<ReadError>(result)) {
      EXPECT_NE(error_text(result), "");
    }
  }
}

}  // namespace
}  // namespace planish
