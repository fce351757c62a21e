// SPDX-License-Identifier: MIT
#include "bench/survey_meshes.hpp"

#include <algorithm>
#include <filesystem>
#include <variant>

#include "planish/io/obj.hpp"
#include "planish/projection/projection.hpp"
#include "support/mesh_builders.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace planish::bench {

std::vector<NamedMesh> samples_and_real_meshes() {
  std::vector<NamedMesh> meshes;
  for (const char* name : {"vault", "dome", "freeform"}) {
    meshes.push_back({name, testing::sample(name, 32)});
  }
  for (const char* name : {"hex", "trihex"}) meshes.push_back({name, testing::sample(name, 20)});
  const std::filesystem::path folder = testing::in_shared_meshes("");
  std::vector<std::string> files;
  if (std::filesystem::exists(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".obj") files.push_back(entry.path().filename().string());
    }
  }
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) {
    const auto bytes = testing::shared_mesh_bytes(file);
    const auto read = read_obj(bytes.value_or(""));
    if (const auto* found = std::get_if<MeshFile>(&read)) meshes.push_back({file, found->mesh});
  }
  return meshes;
}

Mesh made_flat(const Mesh& mesh) {
  Mesh flat = mesh;
  const ProjectionResult projected = project_to_planar(mesh);
  flat.positions(Eigen::all, projected.moved) = projected.moved_positions;
  return flat;
}

}  // namespace planish::bench
