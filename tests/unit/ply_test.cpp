// SPDX-License-Identifier: MIT
#include "planish/io/ply.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::error_text;

Mesh ply_mesh(const std::string& bytes) {
  ReadResult result = read_ply(bytes);
  EXPECT_EQ(error_text(result), "");
  if (auto* file = std::get_if<MeshFile>(&result)) return file->mesh;
  return {};
}

class PlyEncodings : public ::testing::TestWithParam<PlyEncoding> {};

TEST_P(PlyEncodings, WriteWhatReadsBackToTheSameBits) {
  const Mesh mesh = testing::awkward_mesh();
  EXPECT_TRUE(testing::same_bits(mesh, ply_mesh(write_ply(mesh, GetParam()))));
}

/// A list length of one byte cannot hold a face of 300 vertices.
TEST_P(PlyEncodings, KeepHugeFaces) {
  std::vector<Eigen::Vector3d> points;
  std::vector<int> face;
  for (int k = 0; k < 300; ++k) {
    points.emplace_back(k, k * (300 - k), 0);
    face.push_back(k);
  }
  const Mesh mesh = testing::make_mesh(points, {face});
  EXPECT_TRUE(testing::same_bits(mesh, ply_mesh(write_ply(mesh, GetParam()))));
}

/// Neither a cut nor a flipped byte may do more than give a mesh or a sentence.
TEST_P(PlyEncodings, SurviveDamage) {
  const std::string whole = write_ply(testing::awkward_mesh(), GetParam());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    // A text file without its final newline is still whole.
    if (GetParam() == PlyEncoding::kAscii && length + 1 == whole.size()) continue;
    const ReadResult result = read_ply(std::string_view(whole).substr(0, length));
    EXPECT_NE(error_text(result), "") << "cut at " << length;
  }
  std::mt19937 random(3);
  for (int k = 0; k < 5000; ++k) {
    std::string damaged = whole;
    damaged[random() % damaged.size()] = static_cast<char>(random() & 0xff);
    const ReadResult result = read_ply(damaged);
    if (std::holds_alternative<ReadError>(result)) {
      EXPECT_NE(error_text(result), "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PlyEncodings,
                         ::testing::Values(PlyEncoding::kAscii, PlyEncoding::kBinaryLittleEndian,
                                           PlyEncoding::kBinaryBigEndian));

constexpr const char* kHeader =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty uchar red\n"
    "property list uchar float weights\nproperty float x\nproperty float y\nproperty int z\n"
    "element material 1\nproperty list int double data\nproperty short kind\n"
    "element nothing 99999999999999\n"
    "element face 1\nproperty uchar flags\nproperty list uchar uint vertex_index\nend_header\n";

TEST(Ply, PassesOverWhatItDoesNotKnow) {
  const Mesh mesh = ply_mesh(std::string(kHeader) +
                             "255 2 .5 .5 0 0 7\n0 0 1 0 7\n0 1 9 0 1 7\n3 1 2 3 8\n"
                             "1 3 0 1 2\n");
  EXPECT_EQ(mesh.positions.col(1), Eigen::Vector3d(1, 0, 7));
  EXPECT_EQ(mesh.face_vertices, (std::vector<int>{0, 1, 2}));
}

TEST(Ply, EveryRefusalNamesThePlace) {
  const auto refusal = [](const std::string& bytes) { return error_text(read_ply(bytes)); };
  EXPECT_EQ(refusal(""), "line 1: a PLY file starts with \"ply\"");
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\n"),
            "the header does not end: \"end_header\" is missing");
  EXPECT_EQ(refusal("ply\nformat ebcdic 1.0\n"), "line 2: the format \"ebcdic\" is not known");
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement vertex -3\n"),
            "line 3: \"-3\" is not a number of elements");
  EXPECT_EQ(refusal("ply\nelement face 1\nproperty list float int vertex_index\n"),
            "line 3: \"float\" is not a type for the length of a list");
  EXPECT_EQ(refusal("ply\nelement vertex 1\nproperty float x\nend_header\n"),
            "line 2: element vertex has no x, y and z");
  EXPECT_EQ(refusal(std::string(kHeader) + "255 2 .5 .5 0 0 7\n0 0 1 x 7"),
            "line 19: vertex 1: \"x\" is not a number");
  EXPECT_EQ(refusal(std::string(kHeader) + "255 -1"),
            "line 18: vertex 0: the length of a list is negative");
  EXPECT_EQ(refusal(std::string(kHeader) + "0 0 0 0 0\n0 0 1 0 0\n0 0 0 1 0\n0 0\n0 3 0 1 3"),
            "line 22: face 0 uses vertex 3, but the mesh has 3 vertices (from 0)");
}

/// The counts in a header must never size an allocation.
TEST(Ply, AClaimedCountIsNotBelieved) {
  std::string bytes = write_ply(testing::awkward_mesh());
  const std::string claim = "element vertex 6";
  bytes.replace(bytes.find(claim), claim.size(), "element vertex 4000000000000000000");
  EXPECT_NE(error_text(read_ply(bytes)).find("the file ends early"), std::string::npos);
}

}  // namespace
}  // namespace planish
