// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "io/gltf_axes.hpp"
#include "io/gltf_container.hpp"
#include "io/gltf_design.hpp"
#include "io/polygon_fans.hpp"
#include "planish/io/gltf.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

/// One TRIANGLES primitive, placed in the model frame.
struct Piece {
  Positions positions;
  std::vector<int> triangles;  ///< indices into positions, checked
  std::optional<std::vector<int>> sizes;
};

/// The bytes of an accessor: element k starts at data + k · stride.
struct ElementView {
  const unsigned char* data = nullptr;
  std::size_t stride = 0, count = 0;
};

template <class T>
const T& element_of(const std::vector<T>& items, int index, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
    throw ReadError{std::string("the GLB file refers to ") + what + " " + std::to_string(index) +
                    ", which it does not have"};
  }
  return items[static_cast<std::size_t>(index)];
}

/// Checks that all of the accessor lies inside its view and the view inside the buffer, in 64 bits:
/// every sum below stays far from overflow because each term is compared first.
ElementView view_of(const tinygltf::Model& model, int index, std::uint64_t element_size) {
  const tinygltf::Accessor& accessor = element_of(model.accessors, index, "accessor");
  const std::string name = "accessor " + std::to_string(index);
  if (accessor.sparse.isSparse) throw ReadError{name + " is sparse, which is not supported here"};
  const auto& view = element_of(model.bufferViews, accessor.bufferView, "buffer view");
  const auto& buffer = element_of(model.buffers, view.buffer, "buffer");
  const std::uint64_t size = buffer.data.size(), start = view.byteOffset, length = view.byteLength;
  const std::uint64_t offset = accessor.byteOffset, count = accessor.count;
  const std::uint64_t stride = view.byteStride == 0 ? element_size : view.byteStride;
  const bool view_fits = start <= size && length <= size - start && offset <= length;
  const bool fits = view_fits && count >= 1 && stride >= element_size && count <= size &&
                    stride <= size && element_size <= length - offset &&
                    (count - 1) * stride <= length - offset - element_size;
  if (!fits) throw ReadError{name + " reaches outside of the file's data"};
  return {buffer.data.data() + start + offset, static_cast<std::size_t>(stride),
          static_cast<std::size_t>(count)};
}

Positions read_points(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = element_of(model.accessors, index, "accessor");
  if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT ||
      accessor.type != TINYGLTF_TYPE_VEC3) {
    throw ReadError{"accessor " + std::to_string(index) + " should hold points of 3 floats"};
  }
  const ElementView view = view_of(model, index, 3 * sizeof(float));
  Positions points(3, static_cast<Eigen::Index>(view.count));
  for (std::size_t k = 0; k < view.count; ++k) {
    std::array<float, 3> point;
    std::memcpy(point.data(), view.data + k * view.stride, sizeof point);
    for (std::size_t c = 0; c < 3; ++c) {
      points(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(k)) =
          static_cast<double>(point[c]);
    }
  }
  return points;
}

std::size_t index_size(int component) {
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 1;
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return 2;
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return 4;
  throw ReadError{"a list of indices has a type that glTF does not allow"};
}

std::vector<int> read_indices(const tinygltf::Model& model, int index, Eigen::Index vertex_count) {
  std::vector<int> indices;
  if (index < 0) {
    indices.resize(static_cast<std::size_t>(vertex_count));
    std::iota(indices.begin(), indices.end(), 0);
  } else {
    const tinygltf::Accessor& accessor = element_of(model.accessors, index, "accessor");
    const std::size_t size = index_size(accessor.componentType);
    const ElementView view = view_of(model, index, size);
    indices.reserve(view.count);
    for (std::size_t k = 0; k < view.count; ++k) {
      std::uint32_t value = 0;
      std::memcpy(&value, view.data + k * view.stride, size);
      if (value >= static_cast<std::uint64_t>(vertex_count)) {
        throw ReadError{"triangle " + std::to_string(k / 3) + " uses vertex " +
                        std::to_string(value) + ", but the mesh has " +
                        count_text(static_cast<std::size_t>(vertex_count), "vertex", "vertices")};
      }
      indices.push_back(static_cast<int>(value));
    }
  }
  if (indices.size() % 3 != 0)
    throw ReadError{"the number of triangle corners is not a multiple of 3"};
  return indices;
}

Eigen::Matrix4d local_matrix(const tinygltf::Node& node) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (node.matrix.size() == 16) return Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
  if (node.rotation.size() == 4) {
    const Eigen::Quaterniond turn(node.rotation[3], node.rotation[0], node.rotation[1],
                                  node.rotation[2]);
    matrix.topLeftCorner<3, 3>() = turn.normalized().toRotationMatrix();
  }
  if (node.scale.size() == 3) {
    for (int c = 0; c < 3; ++c) {
      matrix.block<3, 1>(0, c) *= node.scale[static_cast<std::size_t>(c)];
    }
  }
  if (node.translation.size() == 3) {
    matrix.block<3, 1>(0, 3) = Eigen::Map<const Eigen::Vector3d>(node.translation.data());
  }
  return matrix;
}

/// mesh.extras.polygonSizes; nullopt where there is none. What is no whole number becomes 0, which
/// is no size, so that the panels are looked for in another way.
std::optional<std::vector<int>> recorded_sizes(const tinygltf::Mesh& mesh) {
  if (!mesh.extras.Has("polygonSizes")) return std::nullopt;
  const tinygltf::Value& list = mesh.extras.Get("polygonSizes");
  if (!list.IsArray()) return std::nullopt;
  std::vector<int> sizes;
  for (std::size_t k = 0; k < list.ArrayLen(); ++k) {
    sizes.push_back(whole_number(list.Get(static_cast<int>(k))).value_or(0));
  }
  return sizes;
}

Positions placed(const Positions& points, const Eigen::Matrix4d& matrix) {
  Positions result(3, points.cols());
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    // Adding zero products would cost the last bit of a file of ours, so skip the identity.
    Eigen::Vector3d point = points.col(v);
    if (!matrix.topLeftCorner<3, 3>().isIdentity(0.0)) point = matrix.topLeftCorner<3, 3>() * point;
    result.col(v) = to_z_up(point + matrix.block<3, 1>(0, 3));
  }
  return result;
}

/// How many more vertices and corners the pieces of a file may hold. Many primitives may refer to
/// the same data, so a small file could ask for more memory than there is.
class Allowance {
 public:
  explicit Allowance(std::size_t count) : left_(count) {}

  void take(std::size_t count) {
    if (count > left_) throw ReadError{"the GLB file repeats its meshes too often"};
    left_ -= count;
  }

 private:
  std::size_t left_;
};

void append_pieces(const tinygltf::Model& model, const tinygltf::Mesh& mesh,
                   const Eigen::Matrix4d& matrix, Allowance& allowance,
                   std::vector<Piece>& pieces) {
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
        primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      throw ReadError{"the GLB file holds triangle strips; save it with single triangles"};
    }
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES) continue;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) continue;
    Piece piece;
    piece.positions = placed(read_points(model, position->second), matrix);
    piece.triangles = read_indices(model, primitive.indices, piece.positions.cols());
    allowance.take(static_cast<std::size_t>(piece.positions.cols()) + piece.triangles.size());
    if (mesh.primitives.size() == 1) piece.sizes = recorded_sizes(mesh);
    pieces.push_back(std::move(piece));
  }
}

/// All meshes of the scene in the order of its nodes. A node is entered once, so a cycle ends; the
/// vertices of all instances together may not outgrow the file.
std::vector<Piece> collect_pieces(const tinygltf::Model& model, std::size_t byte_count) {
  std::vector<std::pair<int, Eigen::Matrix4d>> waiting;
  const auto push = [&](const std::vector<int>& nodes, const Eigen::Matrix4d& matrix) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
      waiting.emplace_back(*node, matrix);
  };
  if (model.scenes.empty()) throw ReadError{"the GLB file holds no scene"};
  const auto& scene = element_of(model.scenes, std::max(model.defaultScene, 0), "scene");
  push(scene.nodes, Eigen::Matrix4d::Identity());
  std::vector<char> entered(model.nodes.size(), 0);
  std::vector<Piece> pieces;
  Allowance allowance(byte_count);
  while (!waiting.empty()) {
    const auto [index, parent] = waiting.back();
    waiting.pop_back();
    const tinygltf::Node& node = element_of(model.nodes, index, "node");
    if (std::exchange(entered[static_cast<std::size_t>(index)], char{1}) != 0) continue;
    const Eigen::Matrix4d matrix = parent * local_matrix(node);
    if (node.mesh >= 0) {
      const tinygltf::Mesh& mesh = element_of(model.meshes, node.mesh, "mesh");
      if (!mesh.extras.Has(kOffsetLayer)) append_pieces(model, mesh, matrix, allowance, pieces);
    }
    push(node.children, matrix);
  }
  if (pieces.empty()) throw ReadError{"the GLB file holds no triangles"};
  return pieces;
}

/// Whether the file's float32 points are the stored exact ones: nothing moved them since. Apart
/// from rounding to float, they may differ by the float steps next to zero (a tiny mesh), and by
/// the rounding of the sum with the display origin (a tiny mesh far away).
bool still_matches(const Positions& file, const Positions& exact) {
  constexpr double kFloatRounding = 2.5e-7;
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  if (file.cols() != exact.cols()) return false;
  const Eigen::Vector3d origin = display_origin(exact);
  const Positions clamped = exact.cwiseMax(-kLargest).cwiseMin(kLargest);
  const double size = (clamped.colwise() - origin).cwiseAbs().maxCoeff();
  constexpr double kSmallest = std::numeric_limits<float>::denorm_min();
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  const double slack =
      kFloatRounding * size + kSmallest + kRounding * (origin.cwiseAbs().maxCoeff() + size);
  return ((file - clamped).cwiseAbs().array() <= slack).all();
}

FaceList triangle_faces(const std::vector<int>& triangles) {
  FaceList faces;
  faces.vertices = triangles;
  for (std::size_t end = 3; end <= triangles.size(); end += 3) {
    faces.offsets.push_back(static_cast<int>(end));
  }
  return faces;
}

/// Panels of a piece, by the best evidence there is.
FaceList panels_of(const Piece& piece, std::vector<std::string>& warnings) {
  if (!piece.sizes) {
    warnings.push_back(
        "the file records no panels, only triangles; every triangle is read as a panel");
    return triangle_faces(piece.triangles);
  }
  if (auto faces = decode_fans(piece.triangles, *piece.sizes)) return *faces;
  if (auto faces = merge_coplanar(piece.positions, piece.triangles, *piece.sizes)) {
    warnings.push_back(
        "another program reordered the triangles; the panels were recovered by joining coplanar "
        "triangles, so their order may have changed");
    return *faces;
  }
  throw ReadError{
      "another program changed the triangles, and the panels cannot be recovered from them"};
}

/// Other programs store a vertex once per face; faces only hang together once these are joined.
/// Non-finite points have no order; they stay, for check_mesh() to refuse.
void weld(Mesh& mesh, std::vector<std::string>& warnings) {
  if (!mesh.positions.allFinite()) return;
  std::map<std::array<double, 3>, int> seen;
  std::vector<int> target;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index v = 0; v < mesh.positions.cols(); ++v) {
    const std::array<double, 3> key = {mesh.positions(0, v), mesh.positions(1, v),
                                       mesh.positions(2, v)};
    const auto [entry, is_new] = seen.emplace(key, static_cast<int>(kept.size()));
    if (is_new) kept.push_back(v);
    target.push_back(entry->second);
  }
  const std::size_t joined = target.size() - kept.size();
  if (joined == 0) return;
  mesh.positions = Positions(mesh.positions(Eigen::all, kept));
  for (int& v : mesh.face_vertices) v = target[static_cast<std::size_t>(v)];
  warnings.push_back(count_text(joined, "vertex was", "vertices were") +
                     " joined with another one at the same place");
}

Mesh joined_mesh(const std::vector<Piece>& pieces, std::vector<std::string>& warnings) {
  Mesh mesh;
  Eigen::Index vertex_count = 0;
  for (const Piece& piece : pieces) vertex_count += piece.positions.cols();
  mesh.positions.resize(3, vertex_count);
  Eigen::Index next_vertex = 0;
  for (const Piece& piece : pieces) {
    std::vector<std::string> piece_warnings;
    const FaceList faces = panels_of(piece, piece_warnings);
    for (std::string& warning : piece_warnings) {
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) {
        warnings.push_back(std::move(warning));
      }
    }
    const auto first_vertex = static_cast<int>(next_vertex);
    const auto first_corner = static_cast<int>(mesh.face_vertices.size());
    mesh.positions.middleCols(next_vertex, piece.positions.cols()) = piece.positions;
    next_vertex += piece.positions.cols();
    for (const int v : faces.vertices) mesh.face_vertices.push_back(first_vertex + v);
    for (std::size_t f = 1; f < faces.offsets.size(); ++f) {
      mesh.face_offsets.push_back(first_corner + faces.offsets[f]);
    }
  }
  return mesh;
}

/// Puts the stored exact design in place of what the triangles say, where both still agree.
GlbFile restored(std::vector<Piece> pieces, std::optional<StoredDesign> stored) {
  GlbFile glb;
  if (stored && pieces.size() == 1 && pieces[0].sizes &&
      still_matches(pieces[0].positions, stored->positions)) {
    pieces[0].positions = stored->positions;  // exact, even if only the panels fit no more
    const auto faces = decode_fans(pieces[0].triangles, *pieces[0].sizes);
    if (faces && same_up_to_rotation(*faces, stored->faces)) {
      glb.file.mesh = {std::move(stored->positions), std::move(stored->faces.offsets),
                       std::move(stored->faces.vertices), std::move(stored->groups)};
      glb.base = std::move(stored->base);
      glb.design = std::move(stored->design);
      return glb;
    }
  }
  if (stored) {
    glb.file.warnings.push_back(
        "another program changed the mesh since it was saved here; the stored design does not fit "
        "it any more and is left out");
  }
  glb.file.mesh = joined_mesh(pieces, glb.file.warnings);
  if (!pieces[0].sizes) weld(glb.file.mesh, glb.file.warnings);
  return glb;
}

/// A base is a mesh with the same faces; one that is not is left out, and with it the design.
void check_base(GlbFile& glb) {
  if (!glb.base) return;
  Mesh base = glb.file.mesh;
  base.positions = *glb.base;
  if (std::holds_alternative<MeshFile>(check_mesh(std::move(base)))) return;
  glb.base.reset();
  glb.design.clear();
  glb.file.warnings.push_back("the stored design is damaged and is left out");
}

}  // namespace

std::variant<GlbFile, ReadError> read_glb_design(std::string_view bytes) {
  auto loaded = load_glb_model(bytes);
  if (auto* problem = std::get_if<std::string>(&loaded)) return ReadError{std::move(*problem)};
  const auto& model = std::get<tinygltf::Model>(loaded);
  try {
    GlbFile glb = restored(collect_pieces(model, bytes.size()), load_design(model.asset.extras));
    ReadResult checked = check_mesh(std::move(glb.file.mesh));
    if (auto* error = std::get_if<ReadError>(&checked)) return std::move(*error);
    auto& file = std::get<MeshFile>(checked);
    glb.file.mesh = std::move(file.mesh);
    glb.file.warnings.insert(glb.file.warnings.end(), file.warnings.begin(), file.warnings.end());
    check_base(glb);
    return glb;
  } catch (const ReadError& error) {  // thrown inside this file only
    return error;
  }
}

ReadResult read_glb(std::string_view bytes) {
  auto result = read_glb_design(bytes);
  if (auto* error = std::get_if<ReadError>(&result)) return std::move(*error);
  return std::move(std::get<GlbFile>(result).file);
}

}  // namespace planish
