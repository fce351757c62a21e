// SPDX-License-Identifier: MIT
#include "planish/io/gltf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "planish/io/mesh_format.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::append_word;
using testing::Chunks;
using testing::error_text;
using testing::put_together;
using testing::same_bits;
using testing::take_apart;
using testing::warning_text;

Mesh read_mesh_or_fail(const std::string& bytes) {
  ReadResult result = read_glb(bytes);
  EXPECT_EQ(error_text(result), "");
  if (auto* file = std::get_if<MeshFile>(&result)) return file->mesh;
  return {};
}

TEST(Gltf, ReopensToTheSameBits) {
  Mesh mesh = testing::awkward_mesh();
  mesh.groups = {{"north \xFF roof", 1}};
  EXPECT_TRUE(same_bits(mesh, read_mesh_or_fail(write_glb(mesh))));
  for (const std::string_view name : sample_names()) {
    const Mesh sample = *make_sample(name, 12);
    EXPECT_TRUE(same_bits(sample, read_mesh_or_fail(write_glb(sample)))) << name;
  }
}

GlbContent full_content(const Mesh& mesh) {
  GlbContent content;
  content.base = mesh.positions;
  content.base->col(3).z() -= 0.7;
  GlbVariations variations;
  variations.support = {2, 3, 5};
  variations.displacements = {Positions::Constant(3, 3, 0.25), Positions::Identity(3, 3)};
  content.variations = variations;
  content.design = "{\"recipe\":\"Größe 0.1\"}";
  return content;
}

TEST(Gltf, ASecondLayerIsShownAndNotRead) {
  const Mesh mesh = *make_sample("dome", 8);
  GlbContent content = full_content(mesh);
  content.offset = mesh.positions.array() + 0.5;
  const std::string bytes = write_glb(mesh, content);
  const nlohmann::json json = take_apart(bytes).json;
  ASSERT_EQ(json["nodes"].size(), 3U);
  EXPECT_EQ(json["nodes"][2]["name"], "planish offset");
  const auto& layer = json["meshes"][2]["primitives"][0];
  EXPECT_EQ(json["materials"][layer["material"].get<std::size_t>()]["alphaMode"], "BLEND");
  const auto& first = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(layer["indices"], first["indices"]);
  for (const char* end : {"min", "max"}) {
    const auto corner = [&](const nlohmann::json& primitive) {
      const auto accessor = primitive["attributes"]["POSITION"].get<std::size_t>();
      return json["accessors"][accessor][end][0].get<double>();
    };
    EXPECT_NEAR(corner(layer) - corner(first), 0.5, 1e-6);
  }
  const auto opened = read_glb_design(bytes);
  const auto* glb = std::get_if<GlbFile>(&opened);
  ASSERT_NE(glb, nullptr);
  EXPECT_TRUE(same_bits(mesh, glb->file.mesh));
  EXPECT_EQ(glb->design, content.design);
}

TEST(Gltf, KeepsBaseAndDesign) {
  const Mesh mesh = *make_sample("trihex", 8);
  const GlbContent content = full_content(mesh);
  const auto result = read_glb_design(write_glb(mesh, content));
  const auto& glb = std::get<GlbFile>(result);
  EXPECT_TRUE(same_bits(glb.file.mesh, mesh));
  EXPECT_EQ(glb.file.warnings.size(), 0u);
  ASSERT_TRUE(glb.base);
  EXPECT_TRUE(same_bits(*glb.base, *content.base));
  EXPECT_EQ(glb.design, content.design);
}

TEST(Gltf, HoldsWhatViewersNeed) {
  const Mesh mesh = *make_sample("freeform", 6);
  const nlohmann::json json = take_apart(write_glb(mesh, full_content(mesh))).json;
  EXPECT_EQ(json["nodes"][0]["name"], "design");
  EXPECT_EQ(json["nodes"][1]["name"], "panel edges");
  const auto& panels = json["meshes"][0];
  const auto& primitive = panels["primitives"][0];
  EXPECT_EQ(primitive["mode"], 4);
  EXPECT_FALSE(primitive["attributes"].contains("NORMAL"));
  EXPECT_TRUE(primitive["attributes"].contains("COLOR_0"));
  EXPECT_TRUE(primitive["attributes"].contains("_DISPLACEMENT"));
  EXPECT_EQ(primitive["attributes"]["POSITION"],
            json["meshes"][1]["primitives"][0]["attributes"]["POSITION"]);
  EXPECT_EQ(panels["extras"]["targetNames"].size(), 2u);
  EXPECT_EQ(panels["extras"]["polygonSizes"].size(), static_cast<std::size_t>(mesh.face_count()));
  const auto& target = json["accessors"][primitive["targets"][1]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(target["sparse"]["count"], 3);
  EXPECT_EQ(target["count"], mesh.vertex_count());
  EXPECT_EQ(json["extensionsUsed"][0], "KHR_materials_variants");
}

/// Far from the origin float32 alone would keep half metres only.
TEST(Gltf, ASiteInNationalCoordinatesIsShownNearAnOrigin) {
  Mesh mesh = *make_sample("vault", 6);
  mesh.positions.colwise() += Eigen::Vector3d(500000.25, 5400000.5, 300);
  const std::string glb = write_glb(mesh);
  EXPECT_TRUE(same_bits(mesh, read_mesh_or_fail(glb)));
  Chunks chunks = take_apart(glb);
  const double reach = chunks.json["accessors"][0]["max"][2].get<double>();
  EXPECT_LT(reach, 10.0);
  chunks.json["asset"].erase("extras");
  const Mesh shown = read_mesh_or_fail(put_together(chunks));
  EXPECT_LT((shown.positions - mesh.positions).cwiseAbs().maxCoeff(), 1e-6);
}

/// Without our float64 copy the panels still come back, in float32.
TEST(Gltf, PolygonSizesAloneGiveThePanels) {
  const Mesh mesh = *make_sample("hex", 9);
  Chunks chunks = take_apart(write_glb(mesh));
  chunks.json["asset"].erase("extras");
  const Mesh read = read_mesh_or_fail(put_together(chunks));
  EXPECT_EQ(read.face_offsets, mesh.face_offsets);
  EXPECT_LT((read.positions - mesh.positions).cwiseAbs().maxCoeff(), 1e-5);
}

/// Reverses the order of the triangles in the index buffer (accessor 1).
void reverse_triangles(Chunks& chunks) {
  const auto& view = chunks.json["bufferViews"][1];
  const std::size_t start = view["byteOffset"], length = view["byteLength"];
  std::string reversed;
  for (std::size_t at = length; at >= 12; at -= 12) {
    reversed += chunks.binary.substr(start + at - 12, 12);
  }
  chunks.binary.replace(start, length, reversed);
}

TEST(Gltf, ReorderedTrianglesAreMergedBackOrRefused) {
  const Mesh mesh = *make_sample("hex", 9);
  Chunks chunks = take_apart(write_glb(mesh, {.base = {}, .variations = {}, .design = "x"}));
  reverse_triangles(chunks);
  const auto result = read_glb_design(put_together(chunks));
  const auto& glb = std::get<GlbFile>(result);
  EXPECT_EQ(glb.design, "");
  EXPECT_EQ(glb.file.warnings.size(), 2u);
  EXPECT_EQ(glb.file.mesh.face_count(), mesh.face_count());
  EXPECT_EQ(glb.file.mesh.face_vertices.size(), mesh.face_vertices.size());
  EXPECT_TRUE(same_bits(glb.file.mesh.positions, mesh.positions));

  // A flat grid: every panel lies in the plane of the next, so nothing tells them apart.
  Mesh flat = *make_sample("vault", 5);
  flat.positions.row(2).setZero();
  chunks = take_apart(write_glb(flat));
  reverse_triangles(chunks);
  EXPECT_NE(error_text(read_glb(put_together(chunks))).find("cannot be recovered"),
            std::string::npos);
}

TEST(Gltf, ForeignTrianglesAreReadAsSuchAndJoined) {
  const Mesh mesh = *make_sample("vault", 4);
  Chunks chunks = take_apart(write_glb(mesh));
  chunks.json["asset"].erase("extras");
  chunks.json["meshes"][0].erase("extras");
  chunks.json["nodes"][0]["scale"] = {2, 2, 2};
  const ReadResult result = read_glb(put_together(chunks));
  EXPECT_NE(warning_text(result).find("every triangle is read as a panel"), std::string::npos);
  const Mesh& read = std::get<MeshFile>(result).mesh;
  EXPECT_EQ(read.face_count(), 2 * mesh.face_count());
  EXPECT_LT((read.positions - 2.0 * mesh.positions).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Gltf, AMovedVertexDropsTheStoredDesign) {
  const Mesh mesh = *make_sample("vault", 5);
  Chunks chunks = take_apart(write_glb(mesh, {.base = {}, .variations = {}, .design = "x"}));
  const float moved = 9.0f;
  std::memcpy(chunks.binary.data() + 12, &moved, 4);
  const auto result = read_glb_design(put_together(chunks));
  const auto& glb = std::get<GlbFile>(result);
  EXPECT_EQ(glb.design, "");
  EXPECT_EQ(glb.file.mesh.positions(0, 1), 9.0);
  EXPECT_EQ(glb.file.warnings.size(), 1u);
}

TEST(Gltf, EveryAccessorIsRangeChecked) {
  const Chunks whole = take_apart(write_glb(*make_sample("vault", 4)));
  const auto refusal = [&](const char* path, const nlohmann::json& value) {
    Chunks chunks = whole;
    chunks.json[nlohmann::json::json_pointer(path)] = value;
    return error_text(read_glb(put_together(chunks)));
  };
  for (const char* path :
       {"/accessors/0/count", "/accessors/0/byteOffset", "/bufferViews/0/byteLength",
        "/bufferViews/0/byteOffset", "/accessors/1/count", "/accessors/1/byteOffset",
        "/bufferViews/1/byteOffset"}) {
    for (const std::uint64_t value : {1000000u, 2147483647u, 4294967295u}) {
      EXPECT_NE(refusal(path, value), "") << path << " = " << value;
    }
    EXPECT_NE(refusal(path, 18446744073709551615u), "") << path;
  }
  EXPECT_NE(refusal("/bufferViews/0/byteStride", 252), "");
  EXPECT_NE(refusal("/accessors/0/bufferView", 17), "");
  EXPECT_NE(refusal("/bufferViews/0/buffer", 3), "");
  EXPECT_NE(refusal("/meshes/0/primitives/0/indices", 0), "");
  EXPECT_NE(refusal("/meshes/0/primitives/0/attributes/POSITION", 99), "");
  EXPECT_NE(refusal("/nodes/0/mesh", 5), "");
  EXPECT_NE(refusal("/scenes/0/nodes", {0, 7}), "");
  EXPECT_NE(refusal("/buffers/0/uri", "other.bin"), "");
  EXPECT_NE(refusal("/extensionsRequired", {"KHR_draco_mesh_compression"}), "");
}

TEST(Gltf, DeepOrCircularFilesEnd) {
  Chunks chunks = take_apart(write_glb(*make_sample("vault", 4)));
  chunks.json["nodes"][0]["children"] = {0, 1};
  EXPECT_EQ(read_mesh_or_fail(put_together(chunks)).face_count(), 9);
  std::string deep = "glTF";
  const std::string json = "{\"a\":" + std::string(99994, '[');
  append_word(deep, 2);
  append_word(deep, 20 + json.size());
  append_word(deep, json.size());
  EXPECT_EQ(error_text(read_glb(deep + "JSON" + json)), "the GLB file's JSON is nested too deeply");
}

/// Neither a cut nor flipped bytes may do more than give a mesh or a sentence.
TEST(Gltf, SurvivesDamage) {
  const std::string whole = write_glb(*make_sample("trihex", 4));
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    EXPECT_NE(error_text(read_glb(std::string_view(whole).substr(0, length))), "") << length;
  }
  std::mt19937 random(5);
  for (int k = 0; k < 3000; ++k) {
    std::string damaged = whole;
    for (int n = 0; n < 3; ++n) {
      damaged[random() % damaged.size()] = static_cast<char>(random() & 0xff);
    }
    const ReadResult result = read_glb(damaged);
    if (std::holds_alternative<ReadError>(result)) {
      EXPECT_NE(error_text(result), "");
    }
  }
}

TEST(MeshFormat, GoesByTheExtension) {
  EXPECT_EQ(format_from_name("roof.OBJ"), MeshFormat::kObj);
  EXPECT_EQ(format_from_name("a.b/roof.off"), MeshFormat::kOff);
  EXPECT_EQ(format_from_name("roof.ply"), MeshFormat::kPly);
  EXPECT_EQ(format_from_name("roof.glb"), MeshFormat::kGlb);
  for (const char* name : {"", "obj", "roof.stl", "roof.obj.gz", "roof.gltf"}) {
    EXPECT_FALSE(format_from_name(name)) << name;
  }
}

TEST(MeshFormat, EveryFormatHoldsTheBits) {
  const Mesh mesh = testing::awkward_mesh();
  for (const auto format :
       {MeshFormat::kObj, MeshFormat::kOff, MeshFormat::kPly, MeshFormat::kGlb}) {
    const ReadResult result = read_mesh(write_mesh(mesh, format), format);
    ASSERT_EQ(error_text(result), "");
    EXPECT_TRUE(same_bits(std::get<MeshFile>(result).mesh, mesh));
  }
}

}  // namespace
}  // namespace planish
