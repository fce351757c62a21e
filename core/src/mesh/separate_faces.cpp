// SPDX-License-Identifier: MIT
#include "mesh/separate_faces.hpp"

#include <utility>

namespace planish {

SeparateFaces separate_faces(const Mesh& mesh) {
  SeparateFaces faces;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    faces.corners.emplace_back(face.begin(), face.end());
  }
  faces.left_out.resize(faces.corners.size(), 0);
  return faces;
}

Mesh with_faces(Mesh mesh, const SeparateFaces& faces) {
  std::vector<int> new_index;  // of each face; where it is left out, of the next one
  mesh.face_offsets.assign(1, 0);
  mesh.face_vertices.clear();
  for (std::size_t f = 0; f < faces.corners.size(); ++f) {
    new_index.push_back(mesh.face_count());
    if (faces.left_out[f]) continue;
    mesh.face_vertices.insert(mesh.face_vertices.end(), faces.corners[f].begin(),
                              faces.corners[f].end());
    mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  }
  new_index.push_back(mesh.face_count());
  std::vector<FaceGroup> groups;
  for (FaceGroup& group : mesh.groups) {
    group.first_face = new_index[static_cast<std::size_t>(group.first_face)];
    if (!groups.empty() && groups.back().first_face == group.first_face) groups.pop_back();
    if (group.first_face < mesh.face_count()) groups.push_back(std::move(group));
  }
  mesh.groups = std::move(groups);
  return mesh;
}

}  // namespace planish
