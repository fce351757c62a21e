// SPDX-License-Identifier: MIT
#include "support/small_files.hpp"

#include <algorithm>
#include <variant>

#include "planish/text/number.hpp"
#include "support/mesh_builders.hpp"

namespace planish::testing {

Mesh four_panels() {
  return make_mesh({{0, 0, 1.5},
                    {2, 0, 1.8},
                    {4, 0, 1.5},
                    {0, 1.5, 1.7},
                    {2, 1.5, 2},
                    {4, 1.5, 1.7},
                    {0, 3, 1.5},
                    {2, 3, 1.8},
                    {4, 3, 1.5}},
                   {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}});
}

Mesh points_apart(const Mesh& mesh) {
  Mesh apart = mesh;
  apart.positions.resize(3, static_cast<Eigen::Index>(mesh.face_vertices.size()));
  for (std::size_t k = 0; k < mesh.face_vertices.size(); ++k) {
    apart.positions.col(static_cast<Eigen::Index>(k)) = mesh.positions.col(mesh.face_vertices[k]);
    apart.face_vertices[k] = static_cast<int>(k);
  }
  return apart;
}

std::string four_panel_vertices() {
  const Mesh mesh = four_panels();
  std::string text;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    text += 'v';
    for (int c = 0; c < 3; ++c) {
      text += ' ';
      append_exact(text, mesh.positions(c, v));
    }
    text += '\n';
  }
  return text;
}

const std::vector<std::string>& four_panel_faces() {
  static const std::vector<std::string> faces = {"1 2 5 4", "2 3 6 5", "4 5 8 7", "5 6 9 8"};
  return faces;
}

std::string outcome(const ReadResult& result) {
  if (const auto* error = std::get_if<ReadError>(&result)) return error->message;
  const auto& file = std::get<MeshFile>(result);
  std::string text = std::to_string(file.mesh.vertex_count()) + " points, " +
                     std::to_string(file.mesh.face_count()) + " faces";
  for (const std::string& warning : file.warnings) text += " | " + warning;
  return text;
}

std::string group_text(const ReadResult& result) {
  std::string text;
  for (const FaceGroup& group : std::get<MeshFile>(result).mesh.groups) {
    std::string name = group.name;
    if (group.one_name) std::replace(name.begin(), name.end(), ' ', '_');
    text += (text.empty() ? "" : " ") + name + ":" + std::to_string(group.first_face);
  }
  return text;
}

}  // namespace planish::testing
