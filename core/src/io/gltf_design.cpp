// SPDX-License-Identifier: MIT
#include "io/gltf_design.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "io/base64.hpp"
#include "planish/io/face_groups.hpp"
#include "planish/text/utf8.hpp"

namespace planish {
namespace {

constexpr int kVersion = 1;

template <class T>
tinygltf::Value pack(const T* values, std::size_t count) {
  static_assert(sizeof(T) == 8 || sizeof(T) == 4);
  const std::string_view bytes(reinterpret_cast<const char*>(values), count * sizeof(T));
  return tinygltf::Value(encode_base64(bytes));
}

tinygltf::Value pack_positions(const Positions& positions) {
  return pack(positions.data(), static_cast<std::size_t>(positions.size()));
}

std::optional<std::string> bytes_of(const tinygltf::Value& object, const char* key) {
  if (!object.Has(key) || !object.Get(key).IsString()) return std::nullopt;
  return decode_base64(object.Get(key).Get<std::string>());
}

template <class T>
std::optional<std::vector<T>> unpack(const tinygltf::Value& object, const char* key) {
  const std::optional<std::string> bytes = bytes_of(object, key);
  if (!bytes || bytes->size() % sizeof(T) != 0) return std::nullopt;
  std::vector<T> values(bytes->size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes->data(), bytes->size());
  return values;
}

std::optional<Positions> unpack_positions(const tinygltf::Value& object, const char* key) {
  const std::optional<std::vector<double>> values = unpack<double>(object, key);
  if (!values || values->size() % 3 != 0) return std::nullopt;
  return Positions(Eigen::Map<const Positions>(values->data(), 3,
                                               static_cast<Eigen::Index>(values->size() / 3)));
}

std::optional<FaceList> unpack_faces(const tinygltf::Value& object, Eigen::Index vertex_count) {
  const auto sizes = unpack<std::int32_t>(object, "faceSizes");
  const auto vertices = unpack<std::int32_t>(object, "faceVertices");
  if (!sizes || !vertices) return std::nullopt;
  FaceList faces;
  faces.vertices.assign(vertices->begin(), vertices->end());
  std::int64_t end = 0;
  for (const std::int32_t size : *sizes) {
    end += size;
    if (size < 3 || end > static_cast<std::int64_t>(vertices->size())) return std::nullopt;
    faces.offsets.push_back(static_cast<int>(end));
  }
  if (end != static_cast<std::int64_t>(vertices->size())) return std::nullopt;
  for (const int v : faces.vertices) {
    if (v < 0 || v >= vertex_count) return std::nullopt;
  }
  return faces;
}

}  // namespace

std::optional<int> whole_number(const tinygltf::Value& value) {
  if (!value.IsNumber()) return std::nullopt;
  const double number = value.GetNumberAsDouble();
  constexpr double kLimit = std::numeric_limits<int>::max();
  if (!(std::abs(number) <= kLimit) || std::floor(number) != number) return std::nullopt;
  return static_cast<int>(number);
}

tinygltf::Value store_design(const Mesh& mesh, const GlbContent& content) {
  std::vector<std::int32_t> sizes;
  sizes.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    sizes.push_back(static_cast<std::int32_t>(mesh.face(f).size()));
  }
  tinygltf::Value::Object stored;
  stored["version"] = tinygltf::Value(kVersion);
  stored["positions"] = pack_positions(mesh.positions);
  stored["faceSizes"] = pack(sizes.data(), sizes.size());
  stored["faceVertices"] = pack(mesh.face_vertices.data(), mesh.face_vertices.size());
  if (!mesh.groups.empty()) {
    stored["groups"] = tinygltf::Value(encode_base64(face_groups_text(mesh.groups)));
  }
  if (content.base) stored["base"] = pack_positions(*content.base);
  if (!content.design.empty()) stored["design"] = tinygltf::Value(as_utf8(content.design));
  tinygltf::Value::Object extras;
  extras["planish"] = tinygltf::Value(std::move(stored));
  return tinygltf::Value(std::move(extras));
}

std::optional<StoredDesign> load_design(const tinygltf::Value& extras) {
  if (!extras.Has("planish")) return std::nullopt;
  const tinygltf::Value& stored = extras.Get("planish");
  if (!stored.Has("version") || whole_number(stored.Get("version")) != kVersion) {
    return std::nullopt;
  }
  std::optional<Positions> positions = unpack_positions(stored, "positions");
  if (!positions) return std::nullopt;
  std::optional<FaceList> faces = unpack_faces(stored, positions->cols());
  if (!faces) return std::nullopt;
  StoredDesign design{std::move(*positions), std::move(*faces), {}, std::nullopt, ""};
  const int face_count = static_cast<int>(design.faces.offsets.size()) - 1;
  design.groups = parse_face_groups(bytes_of(stored, "groups").value_or(""), face_count)
                      .value_or(std::vector<FaceGroup>());
  design.base = unpack_positions(stored, "base");
  if (design.base && design.base->cols() != design.positions.cols()) design.base.reset();
  if (stored.Has("design") && stored.Get("design").IsString()) {
    design.design = stored.Get("design").Get<std::string>();
  }
  return design;
}

}  // namespace planish
