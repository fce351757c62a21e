// SPDX-License-Identifier: MIT
#include "io/gltf_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/gltf_accessors.hpp"
#include "io/gltf_axes.hpp"
#include "io/gltf_design.hpp"

namespace planish {
namespace {

/// x y z w as glTF has them.
Eigen::Matrix3d turn_of(const Eigen::Vector4d& xyzw) {
  const Eigen::Quaterniond turn(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  return turn.normalized().toRotationMatrix();
}

Eigen::Matrix4d local_matrix(const tinygltf::Node& node) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (node.matrix.size() == 16) return Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
  if (node.rotation.size() == 4) {
    matrix.topLeftCorner<3, 3>() = turn_of(Eigen::Map<const Eigen::Vector4d>(node.rotation.data()));
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

/// Where a node puts its mesh: once, or as often as EXT_mesh_gpu_instancing says.
std::vector<Eigen::Matrix4d> instances_of(const tinygltf::Model& model, const tinygltf::Node& node,
                                          std::size_t most) {
  const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
  if (extension == node.extensions.end() || !extension->second.Has("attributes")) {
    return {Eigen::Matrix4d::Identity()};
  }
  const tinygltf::Value& attributes = extension->second.Get("attributes");
  const auto read = [&](const char* name, int width) {
    if (!attributes.Has(name)) return Eigen::MatrixXd();
    return read_vectors(model, whole_number(attributes.Get(name)).value_or(-1), width);
  };
  const Eigen::MatrixXd moves = read("TRANSLATION", 3), turns = read("ROTATION", 4),
                        scales = read("SCALE", 3);
  const Eigen::Index count = std::max({moves.cols(), turns.cols(), scales.cols()});
  if (count == 0) return {Eigen::Matrix4d::Identity()};
  if (static_cast<std::size_t>(count) > most) {
    throw ReadError{"the GLB file repeats its meshes too often"};
  }
  std::vector<Eigen::Matrix4d> matrices(static_cast<std::size_t>(count),
                                        Eigen::Matrix4d::Identity());
  for (Eigen::Index k = 0; k < count; ++k) {
    Eigen::Matrix4d& matrix = matrices[static_cast<std::size_t>(k)];
    if (k < turns.cols()) matrix.topLeftCorner<3, 3>() = turn_of(turns.col(k));
    for (int c = 0; c < 3 && k < scales.cols(); ++c) matrix.block<3, 1>(0, c) *= scales(c, k);
    if (k < moves.cols()) matrix.block<3, 1>(0, 3) = moves.col(k);
  }
  return matrices;
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

/// Adds the morph targets of a primitive, each as far as its weight says.
void morph(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
           const std::vector<double>& weights, Positions& points) {
  for (std::size_t k = 0; k < std::min(weights.size(), primitive.targets.size()); ++k) {
    const auto target = primitive.targets[k].find("POSITION");
    if (weights[k] == 0 || target == primitive.targets[k].end()) continue;
    const Eigen::MatrixXd moves = read_vectors(model, target->second, 3);
    if (moves.cols() != points.cols()) {
      throw ReadError{"a morph target has another number of points than its mesh"};
    }
    points += weights[k] * moves;
  }
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

/// What single precision keeps of points that a node places. A node that is far away was not put
/// there in single precision, or nothing would fit.
double rounding_of(const Positions& points, const Eigen::Matrix4d& matrix) {
  if (points.cols() == 0) return 0.0;
  // Half a unit for the number, as much for the product, both at each end of a gap.
  constexpr double kUnits = 4.0, kFar = 100.0;
  const double largest = (matrix.topLeftCorner<3, 3>() * points).cwiseAbs().maxCoeff();
  const double far = matrix.block<3, 1>(0, 3).cwiseAbs().maxCoeff();
  return kUnits * std::numeric_limits<float>::epsilon() * (largest + std::min(far, kFar * largest));
}

/// A node's mesh with what is placed of it.
struct PlacedMesh {
  const tinygltf::Mesh& mesh;
  const std::vector<double>& weights;
  std::vector<Eigen::Matrix4d> matrices;
};

void append_pieces(const tinygltf::Model& model, const PlacedMesh& placed_mesh,
                   Allowance& allowance, std::vector<ScenePiece>& pieces) {
  const tinygltf::Mesh& mesh = placed_mesh.mesh;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
        primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      throw ReadError{"the GLB file holds triangle strips; save it with single triangles"};
    }
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES) continue;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) continue;
    Positions points = read_vectors(model, position->second, 3);
    morph(model, primitive, placed_mesh.weights, points);
    const std::vector<int> triangles = read_indices(model, primitive.indices, points.cols());
    for (const Eigen::Matrix4d& matrix : placed_mesh.matrices) {
      allowance.take(static_cast<std::size_t>(points.cols()) + triangles.size());
      ScenePiece piece{placed(points, matrix), triangles, std::nullopt, false,
                       rounding_of(points, matrix)};
      piece.mirrored = matrix.topLeftCorner<3, 3>().determinant() < 0;
      if (mesh.primitives.size() == 1) piece.sizes = recorded_sizes(mesh);
      pieces.push_back(std::move(piece));
    }
  }
}

}  // namespace

/// A node is entered once, so a cycle ends.
std::vector<ScenePiece> collect_pieces(const tinygltf::Model& model, std::size_t byte_count,
                                       std::vector<std::string>& warnings) {
  std::vector<std::pair<int, Eigen::Matrix4d>> waiting;
  const auto push = [&](const std::vector<int>& nodes, const Eigen::Matrix4d& matrix) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
      waiting.emplace_back(*node, matrix);
  };
  if (model.scenes.empty()) throw ReadError{"the GLB file holds no scene"};
  const auto& scene = element_of(model.scenes, std::max(model.defaultScene, 0), "scene");
  push(scene.nodes, Eigen::Matrix4d::Identity());
  std::vector<char> entered(model.nodes.size(), 0);
  std::vector<ScenePiece> pieces;
  Allowance allowance(byte_count);
  bool has_skin = false;
  while (!waiting.empty()) {
    const auto [index, parent] = waiting.back();
    waiting.pop_back();
    const tinygltf::Node& node = element_of(model.nodes, index, "node");
    if (std::exchange(entered[static_cast<std::size_t>(index)], char{1}) != 0) continue;
    const Eigen::Matrix4d matrix = parent * local_matrix(node);
    if (node.mesh >= 0) {
      const tinygltf::Mesh& mesh = element_of(model.meshes, node.mesh, "mesh");
      if (!mesh.extras.Has(kOffsetLayer)) {
        PlacedMesh placed_mesh{mesh, node.weights.empty() ? mesh.weights : node.weights,
                               instances_of(model, node, byte_count)};
        for (Eigen::Matrix4d& instance : placed_mesh.matrices) instance = matrix * instance;
        append_pieces(model, placed_mesh, allowance, pieces);
        has_skin = has_skin || node.skin >= 0;
      }
    }
    push(node.children, matrix);
  }
  if (pieces.empty()) throw ReadError{"the GLB file holds no triangles"};
  if (has_skin) warnings.push_back("the mesh hangs on a skeleton; it is read as it is without it");
  return pieces;
}

}  // namespace planish
