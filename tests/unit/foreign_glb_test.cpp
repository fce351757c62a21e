// SPDX-License-Identifier: MIT
// GLB as other programs write it: each kind of fault, and its relatives.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "io/base64.hpp"
#include "planish/io/gltf.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"
#include "support/small_files.hpp"

namespace planish {
namespace {

using nlohmann::json;
using testing::Chunks;
using testing::four_panels;
using testing::outcome;
using testing::put_together;
using Corners = std::vector<std::uint16_t>;

/// A GLB of one mesh, with its accessors in the order in which they are added.
class GlbBuilder {
 public:
  explicit GlbBuilder(const Positions& points, const Corners& corners) {
    chunks_.json = {{"asset", {{"version", "2.0"}}},   {"scene", 0},
                    {"scenes", {{{"nodes", {0}}}}},    {"nodes", {{{"mesh", 0}}}},
                    {"accessors", json::array()},      {"bufferViews", json::array()},
                    {"buffers", {{{"byteLength", 0}}}}};
    add_vectors(points);
    add(corners, 5123, "SCALAR", corners.size());
    chunks_.json["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
  }

  /// z up becomes y up, as floats.
  int add_vectors(const Eigen::MatrixXd& columns, bool turn = true) {
    std::vector<float> values;
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
      const Eigen::VectorXd c = columns.col(k);
      if (turn) {
        for (const double x : {c[0], c[2], -c[1]}) values.push_back(static_cast<float>(x));
      } else {
        for (const double x : c) values.push_back(static_cast<float>(x));
      }
    }
    return add(values, 5126, columns.rows() == 4 ? "VEC4" : "VEC3",
               static_cast<std::size_t>(columns.cols()));
  }

  template <class T>
  int add(const std::vector<T>& values, int component, const char* type, std::size_t count) {
    chunks_.binary.resize((chunks_.binary.size() + 3) / 4 * 4, '\0');
    const std::size_t bytes = values.size() * sizeof(T), at = chunks_.binary.size();
    json& views = chunks_.json["bufferViews"];
    views.push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes}});
    chunks_.binary.resize(at + bytes);
    std::memcpy(chunks_.binary.data() + at, values.data(), bytes);
    chunks_.json["buffers"][0]["byteLength"] = chunks_.binary.size();
    json& accessors = chunks_.json["accessors"];
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", component},
                         {"count", count},
                         {"type", type}});
    return static_cast<int>(accessors.size()) - 1;
  }

  [[nodiscard]] json& document() { return chunks_.json; }
  [[nodiscard]] json& node(std::size_t k) { return chunks_.json["nodes"][k]; }
  [[nodiscard]] json& primitive() { return chunks_.json["meshes"][0]["primitives"][0]; }
  [[nodiscard]] Chunks& chunks() { return chunks_; }
  [[nodiscard]] ReadResult read() const {
    Chunks padded = chunks_;
    padded.binary.resize((padded.binary.size() + 3) / 4 * 4, '\0');
    return read_glb(put_together(padded));
  }

 private:
  Chunks chunks_;
};

const Corners kEightTriangles = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4,
                                 3, 4, 7, 3, 7, 6, 4, 5, 8, 4, 8, 7};

GlbBuilder eight_triangles() { return GlbBuilder(four_panels().positions, kEightTriangles); }

constexpr const char* kTriangles =
    "9 points, 8 faces | the file records no panels, only triangles; every triangle is read as a "
    "panel";

/// How many faces have their outside up, and all of them.
std::pair<int, int> facing_up(const ReadResult& result) {
  const Mesh& mesh = std::get<MeshFile>(result).mesh;
  int up = 0;
  for (int f = 0; f < mesh.face_count(); ++f)
    up += area_vector(mesh.positions, mesh.face(f)).z() > 0;
  return {up, mesh.face_count()};
}

MeshSummary summary(const ReadResult& result) {
  EXPECT_EQ(testing::error_text(result), "");
  if (const auto* file = std::get_if<MeshFile>(&result)) return summarize(file->mesh);
  return {};
}

TEST(ForeignGlb, MirroredNodesTurnTheirTriangles) {
  const std::vector<json> mirrors = {
      {{"mesh", 0}, {"scale", {-1, 1, 1}}},
      {{"mesh", 0}, {"scale", {-1, 1, 1}}, {"translation", {0, 0, 0}}},
      {{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}},
      {{"mesh", 0}, {"scale", {1, 1, -1}}, {"rotation", {0, 1, 0, 0}}}};
  for (const json& mirror : mirrors) {
    GlbBuilder file = eight_triangles();
    file.document()["nodes"].push_back(mirror);
    file.document()["scenes"][0]["nodes"] = {0, 1};
    const ReadResult result = file.read();
    EXPECT_EQ(facing_up(result), std::pair(16, 16)) << mirror;
    EXPECT_EQ(testing::warning_text(result).find("orientation"), std::string::npos) << mirror;
  }
}

TEST(ForeignGlb, AMirrorInAParentAnInstanceOrUnderPanelsCounts) {
  GlbBuilder parent = eight_triangles();
  parent.node(0)["scale"] = {2, 2, -2};
  parent.document()["nodes"].push_back({{"children", {0}}, {"scale", {1, 1, 3}}});
  parent.document()["scenes"][0]["nodes"] = {1};
  EXPECT_EQ(facing_up(parent.read()), std::pair(8, 8));
  parent.node(1)["scale"] = {-1, 1, 1};  // mirrored twice is not mirrored
  EXPECT_EQ(facing_up(parent.read()), std::pair(8, 8));
  GlbBuilder instance = eight_triangles();
  Eigen::MatrixXd scales(3, 2);
  scales << 1, -1, 1, 1, 1, 1;
  instance.node(0)["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
      instance.add_vectors(scales, false);
  EXPECT_EQ(facing_up(instance.read()), std::pair(16, 16));
  GlbBuilder panels = eight_triangles();
  panels.document()["meshes"][0]["extras"]["polygonSizes"] = {4, 4, 4, 4};
  panels.node(0)["scale"] = {-1, 1, 1};
  EXPECT_EQ(facing_up(panels.read()), std::pair(4, 4));
}

TEST(ForeignGlb, PanelsWithPointsOfTheirOwnAreJoined) {
  const Mesh apart = testing::points_apart(four_panels());
  Corners by_panel, by_triangle;
  std::vector<Eigen::Index> columns;
  for (std::uint16_t k = 0; k < 16; k = static_cast<std::uint16_t>(k + 4)) {
    for (const int c : {0, 1, 2, 0, 2, 3}) {
      by_panel.push_back(static_cast<std::uint16_t>(k + c));
      by_triangle.push_back(static_cast<std::uint16_t>(by_triangle.size()));
      columns.push_back(k + c);
    }
  }
  const Positions flat = apart.positions(Eigen::all, columns);
  for (GlbBuilder file : {GlbBuilder(apart.positions, by_panel), GlbBuilder(flat, by_triangle)}) {
    file.document()["meshes"][0]["extras"]["polygonSizes"] = {4, 4, 4, 4};
    const MeshSummary figures = summary(file.read());
    EXPECT_EQ(figures.vertices, 9);
    EXPECT_EQ(figures.face_sizes, (std::map<int, int>{{4, 4}}));
    EXPECT_EQ(figures.components, 1);
  }
}

TEST(ForeignGlb, APanelOnTopOfAnotherStaysApart) {
  const Mesh pane = testing::make_mesh({{0, 0, 0},
                                        {1, 0, 0},
                                        {0, 1, 0},
                                        {0, 0, 0},
                                        {1, 0, 0},
                                        {0, 1, 0},
                                        {0, 0, 0},
                                        {1, 0, 0},
                                        {0, 1, 0}},
                                       {{0, 1, 2}});
  GlbBuilder file(pane.positions, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  file.document()["meshes"][0]["extras"]["polygonSizes"] = {3, 3, 3};
  EXPECT_EQ(summary(file.read()).components, 3);
}

/// Bays turned about the vertical axis, that meet to rounding.
GlbBuilder turned_bays(int count, double scale, const Eigen::Vector3d& move) {
  const double pi = std::acos(-1.0), half = pi / count;
  Positions points(3, 4);
  points << scale * 0.5, scale * 4, scale * 0.5 * std::cos(2 * half),
      scale * 4 * std::cos(2 * half), 0, 0, scale * 0.5 * std::sin(2 * half),
      scale * 4 * std::sin(2 * half), -scale, -1.5 * scale, -scale, -1.5 * scale;
  GlbBuilder file(points, {0, 1, 3, 0, 3, 2});
  file.document()["nodes"] = json::array();
  file.document()["scenes"][0]["nodes"] = json::array();
  for (int k = 0; k < count; ++k) {
    file.document()["nodes"].push_back(
        {{"mesh", 0},
         {"rotation", {0, std::sin(half * k), 0, std::cos(half * k)}},
         {"translation", {move.x(), move.y(), move.z()}}});
    file.document()["scenes"][0]["nodes"].push_back(k);
  }
  return file;
}

TEST(ForeignGlb, PointsThatDifferByRoundingAreJoined) {
  for (const int count : {5, 6, 7, 12}) {
    for (const double scale : {1.0, 1e-3, 1e4}) {
      for (const Eigen::Vector3d& move : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 7)}) {
        const MeshSummary figures = summary(turned_bays(count, scale, scale * move).read());
        EXPECT_EQ(figures.vertices, 2 * count) << scale;
        EXPECT_EQ(figures.components, 1) << scale;
        EXPECT_EQ(figures.boundary_loops, 2) << scale;
      }
    }
  }
}

TEST(ForeignGlb, GapsStayOpen) {
  GlbBuilder file = eight_triangles();
  file.document()["nodes"].push_back({{"mesh", 0}, {"translation", {4.001, 0, 0}}});
  file.document()["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(summary(file.read()).components, 2);
}

TEST(ForeignGlb, TrianglesWithoutThreeCornersAreLeftOut) {
  Corners twice = kEightTriangles;
  twice.insert(twice.end(), {0, 1, 1});
  EXPECT_EQ(outcome(GlbBuilder(four_panels().positions, twice).read()),
            std::string(kTriangles) +
                " | 1 face has fewer than 3 different corners (first: face 8); left out");
  Corners first = {4, 4, 4};
  first.insert(first.end(), kEightTriangles.begin(), kEightTriangles.end());
  EXPECT_NE(outcome(GlbBuilder(four_panels().positions, first).read()).find("one lower"),
            std::string::npos);
  // A pole whose points of their own lie at one place to rounding.
  Positions cap(3, 6);
  cap << 0, 3e-16, -3e-16, 1, 0, -1, 0, 1e-16, 0, 0, 1, 0, 1, 1, 1, 0, 0, 0;
  const MeshSummary figures = summary(GlbBuilder(cap, {0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 2, 0}).read());
  EXPECT_EQ(figures.vertices, 4);
  EXPECT_EQ(figures.faces, 2);
}

TEST(ForeignGlb, OnlyExtensionsOfTheGeometryAreRefused) {
  const auto with = [](const json& required) {
    GlbBuilder file = eight_triangles();
    file.document()["extensionsRequired"] = required;
    return outcome(file.read());
  };
  for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu", "KHR_materials_unlit",
                           "KHR_materials_transmission", "KHR_lights_punctual",
                           "KHR_texture_transform", "KHR_mesh_quantization"}) {
    EXPECT_EQ(with({name}), kTriangles);
  }
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "VENDOR_x"}) {
    EXPECT_EQ(
        with({"KHR_materials_unlit", name}),
        "the GLB file requires the extension " + std::string(name) + ", which is not supported");
  }
}

template <class T>
ReadResult quantized(int component, bool normalized) {
  const double most = std::numeric_limits<T>::max(), unit = normalized ? 4.0 / most : 0.25;
  const Positions points = four_panels().positions;
  std::vector<T> values;
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    // Behind each point glTF has padding to 4 bytes.
    for (const double x : {points(0, v), points(2, v), 3 - points(1, v), 0.0}) {
      values.push_back(static_cast<T>(std::lround(x / unit)));
    }
  }
  GlbBuilder file = eight_triangles();
  const int accessor = file.add(values, component, "VEC3", 9);
  file.document()["bufferViews"].back()["byteStride"] = 4 * sizeof(T);
  file.document()["accessors"].back()["normalized"] = normalized;
  file.primitive()["attributes"]["POSITION"] = accessor;
  const double scale = normalized ? 4.0 : 0.25;
  file.node(0)["scale"] = {scale, scale, scale};
  file.node(0)["translation"] = {0, 0, -3};
  file.document()["extensionsRequired"] = {"KHR_mesh_quantization"};
  return file.read();
}

TEST(ForeignGlb, QuantizedPointsAreRead) {
  const auto error = [](const ReadResult& result) {
    EXPECT_EQ(outcome(result), kTriangles);
    return (std::get<MeshFile>(result).mesh.positions - four_panels().positions)
        .cwiseAbs()
        .maxCoeff();
  };
  EXPECT_LT(error(quantized<std::uint16_t>(5123, true)), 4.0 / 65535);
  EXPECT_LT(error(quantized<std::int16_t>(5122, true)), 4.0 / 32767);
  EXPECT_LT(error(quantized<std::uint8_t>(5121, true)), 4.0 / 255);
  EXPECT_LT(error(quantized<std::int8_t>(5120, true)), 4.0 / 127);
  EXPECT_LT(error(quantized<std::uint16_t>(5123, false)), 0.13);
}

TEST(ForeignGlb, DataInTheJsonIsRead) {
  for (const char* media : {"application/octet-stream", "application/gltf-buffer", ""}) {
    GlbBuilder file = eight_triangles();
    Chunks& chunks = file.chunks();
    chunks.json["buffers"][0]["uri"] =
        "data:" + std::string(media) + ";base64," + encode_base64(chunks.binary);
    chunks.binary.clear();
    EXPECT_EQ(outcome(file.read()), kTriangles);
  }
  GlbBuilder file = eight_triangles();
  const auto with = [&](const json& buffers) {
    file.document()["buffers"] = buffers;
    return outcome(file.read());
  };
  EXPECT_EQ(with({{{"byteLength", 4}, {"uri", "data:,abcd"}}}),
            "the GLB file holds its data as text that is not base64");
  EXPECT_EQ(with({{{"byteLength", 4}, {"uri", "roof.bin"}}}),
            "the GLB file refers to data outside of itself");
  EXPECT_EQ(with({{{"byteLength", 4}}, {{"byteLength", 4}}}),
            "the GLB file holds its data in several buffers; it can have one");
}

TEST(ForeignGlb, InstancesAreRead) {
  GlbBuilder file = eight_triangles();
  Eigen::MatrixXd moves(3, 2), turns(4, 2);
  moves << 0, 10, 0, 0, 0, 0;
  turns << 0, 0, 0, 1, 0, 0, 1, 0;
  json& attributes = file.node(0)["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes["TRANSLATION"] = file.add_vectors(moves, false);
  const MeshSummary bays = summary(file.read());
  EXPECT_EQ(bays.vertices, 18);
  EXPECT_EQ(bays.components, 2);
  attributes["ROTATION"] = file.add_vectors(turns, false);
  EXPECT_EQ(facing_up(file.read()), std::pair(16, 16));
  attributes["TRANSLATION"] = 99;
  EXPECT_EQ(outcome(file.read()), "the GLB file refers to accessor 99, which it does not have");
  attributes["TRANSLATION"] = 1;
  EXPECT_EQ(outcome(file.read()), "accessor 1 should hold points of 3 floats");
}

TEST(ForeignGlb, MorphTargetsCountAsTheirWeightsSay) {
  const auto middle = [](const json& mesh_weights, const json& node_weights, bool sparse) {
    GlbBuilder file = eight_triangles();
    Positions moves = Positions::Zero(3, 9);
    moves(2, 4) = 1;
    int target = 0;
    if (sparse) {
      const int columns = file.add(Corners{4}, 5123, "SCALAR", 1);
      target = file.add_vectors(moves.col(4));
      json& accessor = file.document()["accessors"][static_cast<std::size_t>(target)];
      accessor["sparse"] = {{"count", 1},
                            {"indices", {{"bufferView", columns}, {"componentType", 5123}}},
                            {"values", {{"bufferView", target}}}};
      accessor["count"] = 9;
      accessor.erase("bufferView");
    } else {
      target = file.add_vectors(moves);
    }
    file.primitive()["targets"] = {{{"POSITION", target}}};
    if (!mesh_weights.is_null()) file.document()["meshes"][0]["weights"] = mesh_weights;
    if (!node_weights.is_null()) file.node(0)["weights"] = node_weights;
    const ReadResult result = file.read();
    EXPECT_EQ(outcome(result), kTriangles);
    return std::get<MeshFile>(result).mesh.positions(2, 4);
  };
  for (const bool sparse : {false, true}) {
    EXPECT_EQ(middle({1.0}, nullptr, sparse), 3.0);
    EXPECT_EQ(middle({0.0}, {0.5}, sparse), 2.5);
    EXPECT_EQ(middle({1.0}, {0.0}, sparse), 2.0);
    EXPECT_EQ(middle(nullptr, nullptr, sparse), 2.0);
  }
}

TEST(ForeignGlb, ASkeletonIsNamed) {
  GlbBuilder file = eight_triangles();
  file.node(0)["skin"] = 0;
  EXPECT_NE(outcome(file.read()).find("skeleton"), std::string::npos);
}

}  // namespace
}  // namespace planish
