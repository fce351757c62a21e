// SPDX-License-Identifier: MIT
#include "planish/io/off.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::error_text;
using testing::shared_mesh_bytes;
using testing::warning_text;

constexpr const char* kSquarePoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Mesh off_mesh(const std::string& text) {
  ReadResult result = read_off(text);
  EXPECT_EQ(error_text(result), "");
  if (auto* file = std::get_if<MeshFile>(&result)) return file->mesh;
  return {};
}

TEST(Off, WritesWhatReadsBackToTheSameBits) {
  const Mesh mesh = testing::awkward_mesh();
  EXPECT_TRUE(testing::same_bits(mesh, off_mesh(write_off(mesh))));
}

TEST(Off, ReadsEveryHeader) {
  for (const char* header : {"OFF\n4 1 0\n", "OFF 4 1 0\n", "# hi\n\nOFF # x\n# y\n4 1\n",
                             "COFF\r\n4 1 4\r\n", "STNOFF 4 1 0\n", "4 1 0\n"}) {
    const Mesh mesh = off_mesh(header + std::string(kSquarePoints) + "\n4 0 1 2 3 255 0 0");
    EXPECT_EQ(mesh.face_vertices, (std::vector<int>{0, 1, 2, 3})) << header;
  }
}

TEST(Off, RecognisesIndicesFromOne) {
  const ReadResult result = read_off("OFF 4 1 0\n" + std::string(kSquarePoints) + "4 1 2 3 4");
  EXPECT_EQ(warning_text(result),
            "the faces count vertices from 1, OFF counts from 0; read as from 1\n");
  EXPECT_EQ(std::get<MeshFile>(result).mesh.face_vertices, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Off, EveryRefusalNamesThePlace) {
  const auto refusal = [](const std::string& text) { return error_text(read_off(text)); };
  const std::string points = kSquarePoints;
  EXPECT_EQ(refusal(""), "the file is empty");
  EXPECT_EQ(refusal("hello world"),
            "line 1: here should be the numbers of vertices and faces (OFF)");
  EXPECT_EQ(refusal("OFF BINARY"), "line 1: binary OFF is not supported");
  EXPECT_EQ(refusal("OFF 4 0 0\n" + points), "the file holds no faces");
  EXPECT_EQ(refusal("OFF 999999999999 1 0\n0 0 0\n"),
            "the file ends after 1 vertex, but promises 999999999999");
  EXPECT_EQ(refusal("OFF 4 7 0\n" + points + "4 0 1 2 3"),
            "the file ends after 1 face, but promises 7");
  EXPECT_EQ(refusal("OFF 4 1 0\n" + points + "4 0 1 2"),
            "line 6: the face has 4 vertices, but the line holds 3");
  EXPECT_EQ(refusal("OFF 4 1 0\n" + points + "3 0 1 9"),
            "line 6: face 0 uses vertex 9, but the mesh has 4 vertices (from 0)");
  EXPECT_EQ(refusal("OFF 4 1 0\n" + points + "x"), "line 6: \"x\" is not a number of vertices");
  EXPECT_EQ(refusal("OFF 1 1 0\n0,5 0 0\n"),
            "line 2: the coordinate \"0,5\" has a comma; coordinates need a decimal point and "
            "spaces between them");
}

TEST(Off, SharedFilesLoad) {
  struct Expected {
    const char* name;
    int vertices, faces;
  };
  for (const Expected& expected :
       {Expected{"real_L_single_face", 6, 1}, Expected{"real_off_1based", 96, 75},
        Expected{"real_stray_vertex", 13, 14}, Expected{"off_comments_one_line_header", 4, 1}}) {
    const auto bytes = shared_mesh_bytes(std::string("nasty/") + expected.name + ".off");
    if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
    const Mesh mesh = off_mesh(*bytes);
    EXPECT_EQ(mesh.vertex_count(), expected.vertices) << expected.name;
    EXPECT_EQ(mesh.face_count(), expected.faces) << expected.name;
  }
}

}  // namespace
}  // namespace planish
