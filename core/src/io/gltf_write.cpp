// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <utility>

#include "io/gltf_axes.hpp"
#include "io/gltf_design.hpp"
#include "io/polygon_fans.hpp"
#include "mesh/edge_table.hpp"
#include "planish/io/gltf.hpp"

namespace planish {
namespace {

using tinygltf::Value;

/// Three floats a vertex, y up.
using Points32 = std::vector<std::array<float, 3>>;

enum class ViewUse { kVertices, kIndices, kSparse };

/// Appends `values` to the buffer as a view of its own, 4-byte aligned. Returns the view's index.
template <class T>
int add_view(tinygltf::Model& model, const std::vector<T>& values, ViewUse use) {
  std::vector<unsigned char>& data = model.buffers[0].data;
  data.resize((data.size() + 3) / 4 * 4, 0);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = values.size() * sizeof(T);
  if (use == ViewUse::kVertices) view.target = TINYGLTF_TARGET_ARRAY_BUFFER;
  if (use == ViewUse::kIndices) view.target = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
  data.resize(data.size() + view.byteLength);
  std::memcpy(data.data() + view.byteOffset, values.data(), view.byteLength);
  model.bufferViews.push_back(std::move(view));
  return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_accessor(tinygltf::Model& model, int view, int component, int type, std::size_t count) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

/// Fills min and max, which glTF demands for positions and tinygltf leaves empty.
void set_bounds(tinygltf::Accessor& accessor, const Points32& points) {
  for (std::size_t c = 0; c < 3; ++c) {
    float low = points[0][c], high = points[0][c];
    for (const auto& point : points) {
      low = std::min(low, point[c]);
      high = std::max(high, point[c]);
    }
    accessor.minValues.push_back(static_cast<double>(low));
    accessor.maxValues.push_back(static_cast<double>(high));
  }
}

int add_points(tinygltf::Model& model, const Points32& points) {
  const int view = add_view(model, points, ViewUse::kVertices);
  return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3,
                      points.size());
}

int add_indices(tinygltf::Model& model, const std::vector<std::uint32_t>& indices) {
  const int view = add_view(model, indices, ViewUse::kIndices);
  return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                      indices.size());
}

std::array<float, 3> to_point32(const Eigen::Vector3d& p) {
  const Eigen::Vector3d up = to_y_up(p);
  return {to_float(up.x()), to_float(up.y()), to_float(up.z())};
}

Points32 to_points32(const Positions& positions, const Eigen::Vector3d& origin) {
  Points32 points;
  points.reserve(static_cast<std::size_t>(positions.cols()));
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    points.push_back(to_point32(positions.col(v) - origin));
  }
  return points;
}

/// Panel neutral to deep blue-violet by a share, linear RGB.
std::array<std::uint8_t, 4> heat_colour(double share) {
  constexpr std::array<double, 3> kStill = {0.88, 0.86, 0.81}, kMost = {0.05, 0.02, 0.28};
  std::array<std::uint8_t, 4> colour = {0, 0, 0, 255};
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = kStill[c] + share * (kMost[c] - kStill[c]);
    colour[c] = static_cast<std::uint8_t>(std::lround(255.0 * value));
  }
  return colour;
}

/// COLOR_0 for a share of each vertex.
void add_heat(tinygltf::Model& model, const Eigen::VectorXd& shares,
              std::map<std::string, int>& attributes) {
  std::vector<std::array<std::uint8_t, 4>> colours;
  for (const double share : shares) colours.push_back(heat_colour(share));
  const int view = add_view(model, colours, ViewUse::kVertices);
  attributes["COLOR_0"] = add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                       TINYGLTF_TYPE_VEC4, colours.size());
  model.accessors.back().normalized = true;
}

/// COLOR_0 and _DISPLACEMENT of the moves from the base, or COLOR_0 of the heat that is given.
void add_colours(tinygltf::Model& model, const Mesh& mesh, const GlbContent& content,
                 std::map<std::string, int>& attributes) {
  if (content.heat) add_heat(model, *content.heat, attributes);
  if (!content.base) return;
  const Positions moves = mesh.positions - *content.base;
  const double most = moves.colwise().norm().maxCoeff();
  if (!content.heat) {
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(moves.cols());
    for (Eigen::Index v = 0; v < moves.cols() && most > 0; ++v) {
      shares[v] = moves.col(v).norm() / most;
    }
    add_heat(model, shares, attributes);
  }
  attributes["_DISPLACEMENT"] = add_points(model, to_points32(moves, Eigen::Vector3d::Zero()));
}

/// A sparse accessor over all vertices, zero but on `support`.
int add_sparse_target(tinygltf::Model& model, const Positions& displacement, int support_view,
                      std::size_t support_size, std::size_t vertex_count) {
  Points32 values = to_points32(displacement, Eigen::Vector3d::Zero());
  const int values_view = add_view(model, values, ViewUse::kSparse);
  const int index =
      add_accessor(model, -1, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, vertex_count);
  tinygltf::Accessor& accessor = model.accessors.back();
  if (support_size < vertex_count) values.push_back({0.0f, 0.0f, 0.0f});
  set_bounds(accessor, values);
  accessor.sparse.isSparse = true;
  accessor.sparse.count = static_cast<int>(support_size);
  accessor.sparse.indices.bufferView = support_view;
  accessor.sparse.indices.byteOffset = 0;
  accessor.sparse.indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.sparse.values.bufferView = values_view;
  accessor.sparse.values.byteOffset = 0;
  return index;
}

std::vector<int> add_targets(tinygltf::Model& model, const GlbVariations& variations,
                             std::size_t vertex_count) {
  std::vector<int> targets;
  if (variations.support.empty() || variations.displacements.empty()) return targets;
  const std::vector<std::uint32_t> support(variations.support.begin(), variations.support.end());
  const int support_view = add_view(model, support, ViewUse::kSparse);
  for (const Positions& displacement : variations.displacements) {
    targets.push_back(
        add_sparse_target(model, displacement, support_view, support.size(), vertex_count));
  }
  return targets;
}

int add_material(tinygltf::Model& model, const char* name, std::vector<double> colour,
                 double roughness) {
  tinygltf::Material material;
  material.name = name;
  material.doubleSided = true;
  if (colour[3] < 1.0) material.alphaMode = "BLEND";
  material.pbrMetallicRoughness.baseColorFactor = std::move(colour);
  material.pbrMetallicRoughness.metallicFactor = 0.0;
  material.pbrMetallicRoughness.roughnessFactor = roughness;
  model.materials.push_back(std::move(material));
  return static_cast<int>(model.materials.size()) - 1;
}

Value named(const char* name) { return Value(Value::Object{{"name", Value(std::string(name))}}); }

Value mapping(int material, int variant) {
  return Value(Value::Object{{"material", Value(material)},
                             {"variants", Value(Value::Array{Value(variant)})}});
}

/// Materials "glass" and, with displacements, "heat map" as a second variant.
void add_panel_materials(tinygltf::Model& model, tinygltf::Primitive& primitive, bool heat_map) {
  constexpr const char* kVariants = "KHR_materials_variants";
  const int glass = add_material(model, "glass", {0.62, 0.78, 0.84, 0.82}, 0.15);
  primitive.material = glass;
  if (!heat_map) return;
  const int heat = add_material(model, "heat map", {1.0, 1.0, 1.0, 1.0}, 0.85);
  primitive.material = heat;
  model.extensionsUsed.push_back(kVariants);
  model.extensions[kVariants] =
      Value(Value::Object{{"variants", Value(Value::Array{named("heat map"), named("glass")})}});
  primitive.extensions[kVariants] =
      Value(Value::Object{{"mappings", Value(Value::Array{mapping(heat, 0), mapping(glass, 1)})}});
}

void set_targets(const std::vector<int>& targets, tinygltf::Mesh& mesh, Value::Object& extras) {
  if (targets.empty()) return;
  Value::Array names;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    mesh.primitives[0].targets.push_back({{"POSITION", targets[k]}});
    mesh.weights.push_back(0.0);
    names.push_back(Value("variation " + std::to_string(k + 1)));
  }
  extras["targetNames"] = Value(std::move(names));
}

Value polygon_sizes(const Mesh& mesh) {
  Value::Array sizes;
  sizes.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    sizes.push_back(Value(static_cast<int>(mesh.face(f).size())));
  }
  return Value(std::move(sizes));
}

/// Every edge once, two indices each.
std::vector<std::uint32_t> panel_edges(const Mesh& mesh) {
  std::vector<std::uint32_t> ends;
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (const auto edge : by_edge(uses)) {
    ends.push_back(static_cast<std::uint32_t>(edge[0].low));
    ends.push_back(static_cast<std::uint32_t>(edge[0].high));
  }
  return ends;
}

void add_node(tinygltf::Model& model, const char* name, tinygltf::Mesh mesh,
              const Eigen::Vector3d& origin) {
  mesh.name = name;
  model.meshes.push_back(std::move(mesh));
  tinygltf::Node node;
  node.name = name;
  node.mesh = static_cast<int>(model.meshes.size()) - 1;
  if (!origin.isZero(0.0)) {
    const Eigen::Vector3d up = to_y_up(origin);
    node.translation = {up.x(), up.y(), up.z()};
  }
  model.nodes.push_back(std::move(node));
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()) - 1);
}

/// The panels once more at other points, translucent; readers of ours leave it out.
void add_offset(tinygltf::Model& model, const Positions& positions,
                const tinygltf::Primitive& panels, const tinygltf::Primitive& lines,
                const Eigen::Vector3d& origin) {
  const Points32 points = to_points32(positions, origin);
  const int position = add_points(model, points);
  set_bounds(model.accessors.back(), points);
  tinygltf::Mesh layer;
  for (const tinygltf::Primitive* given : {&panels, &lines}) {
    tinygltf::Primitive& primitive = layer.primitives.emplace_back();
    primitive.mode = given->mode;
    primitive.indices = given->indices;
    primitive.attributes["POSITION"] = position;
    primitive.material = given->material;
  }
  layer.primitives[0].material = add_material(model, kOffsetLayer, {0.62, 0.78, 0.84, 0.35}, 0.15);
  layer.extras = Value(Value::Object{{kOffsetLayer, Value(true)}});
  add_node(model, kOffsetLayer, std::move(layer), origin);
}

tinygltf::Model start_model(const Mesh& mesh, const GlbContent& content) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "Planish";
  model.asset.extras = store_design(mesh, content);
  model.buffers.emplace_back();
  model.scenes.emplace_back();
  model.scenes[0].name = "Planish";
  model.defaultScene = 0;
  return model;
}

}  // namespace

std::string write_glb(const Mesh& mesh, const GlbContent& content) {
  tinygltf::Model model = start_model(mesh, content);
  const Eigen::Vector3d origin = display_origin(mesh.positions);
  const Points32 points = to_points32(mesh.positions, origin);
  const int position = add_points(model, points);
  set_bounds(model.accessors.back(), points);

  tinygltf::Mesh panels;
  panels.primitives.emplace_back();
  tinygltf::Primitive& faces = panels.primitives[0];
  faces.mode = TINYGLTF_MODE_TRIANGLES;
  faces.attributes["POSITION"] = position;
  const std::vector<int> fans = encode_fans(mesh);
  faces.indices = add_indices(model, {fans.begin(), fans.end()});
  add_colours(model, mesh, content, faces.attributes);
  add_panel_materials(model, faces, content.base || content.heat);

  tinygltf::Mesh lines;
  lines.primitives.emplace_back();
  lines.primitives[0].mode = TINYGLTF_MODE_LINE;
  lines.primitives[0].attributes["POSITION"] = position;
  lines.primitives[0].indices = add_indices(model, panel_edges(mesh));
  lines.primitives[0].material = add_material(model, "panel edges", {0.02, 0.02, 0.03, 1.0}, 1.0);

  Value::Object panel_extras, line_extras;
  if (content.variations) {
    const std::vector<int> targets = add_targets(model, *content.variations, points.size());
    set_targets(targets, panels, panel_extras);
    set_targets(targets, lines, line_extras);  // the edges follow the sliders too
  }
  panel_extras["polygonSizes"] = polygon_sizes(mesh);
  panels.extras = Value(std::move(panel_extras));
  if (!line_extras.empty()) lines.extras = Value(std::move(line_extras));
  const tinygltf::Primitive panel_form = panels.primitives[0], line_form = lines.primitives[0];
  add_node(model, "design", std::move(panels), origin);
  add_node(model, "panel edges", std::move(lines), origin);
  if (content.offset) add_offset(model, *content.offset, panel_form, line_form, origin);

  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true);
  return std::move(stream).str();
}

}  // namespace planish
