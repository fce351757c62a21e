// SPDX-License-Identifier: MIT
#include "support/mesh_builders.hpp"

#include <cstring>
#include <fstream>
#include <iterator>

#include "support/places.hpp"

namespace planish::testing {

Mesh make_mesh(const std::vector<Eigen::Vector3d>& points,
               const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  mesh.positions.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v) {
    mesh.positions.col(static_cast<Eigen::Index>(v)) = points[v];
  }
  for (const std::vector<int>& face : faces) {
    mesh.face_vertices.insert(mesh.face_vertices.end(), face.begin(), face.end());
    mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  }
  return mesh;
}

Mesh awkward_mesh() {
  return make_mesh({{0.1, 1.0 / 3.0, -0.0},
                    {1e-9, 123456.789012345678, 5e-324},
                    {-1e30, 2.2250738585072014e-308, 4503599627370497.5},
                    {0.30000000000000004, 1.7976931348623157e90, 9007199254740993.0},
                    {1, 2, 3},
                    {-4.35, 0.000123, 7e22}},
                   {{0, 1, 2, 3}, {2, 1, 4}, {4, 1, 0, 5}});
}

Mesh three_panels() {
  return make_mesh({{0.0, 0.0, 0.3},
                    {1.1, 0.1, 0.0},
                    {1.0, 1.2, 0.1},
                    {-0.2, 1.0, 0.0},
                    {-1.2, 0.4, -0.1},
                    {-1.0, -0.7, 0.0},
                    {0.3, -1.1, 0.1}},
                   {{0, 1, 2, 3}, {0, 3, 4, 5, 6}, {0, 6, 1}});
}

bool same_bits(const Positions& a, const Positions& b) {
  if (a.cols() != b.cols()) return false;
  if (a.size() == 0) return true;  // data() may then be null, which memcmp() does not take
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

bool same_bits(const Mesh& a, const Mesh& b) {
  if (!same_bits(a.positions, b.positions)) return false;
  if (a.face_offsets != b.face_offsets || a.face_vertices != b.face_vertices) return false;
  if (a.groups.size() != b.groups.size()) return false;
  for (std::size_t k = 0; k < a.groups.size(); ++k) {
    if (a.groups[k].name != b.groups[k].name) return false;
    if (a.groups[k].one_name != b.groups[k].one_name) return false;
    if (a.groups[k].first_face != b.groups[k].first_face) return false;
  }
  return true;
}

std::optional<std::string> shared_mesh_bytes(const std::string& name) {
  std::ifstream file(in_shared_meshes(name), std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::string error_text(const ReadResult& result) {
  const auto* error = std::get_if<ReadError>(&result);
  return error ? error->message : "";
}

std::string warning_text(const ReadResult& result) {
  const auto* file = std::get_if<MeshFile>(&result);
  if (!file) return "refused: " + error_text(result);
  std::string text;
  for (const std::string& warning : file->warnings) text += warning + "\n";
  return text;
}

}  // namespace planish::testing
