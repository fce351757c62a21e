// SPDX-License-Identifier: MIT
#include "open_mesh.hpp"

#include <string_view>
#include <utility>
#include <variant>

#include "conversion_run.hpp"
#include "mesh_files.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/mesh/mesh_check.hpp"

namespace planish::library {

namespace {

constexpr const char* kArrayName = "mesh.obj";  ///< of a mesh that came without a file

void check_offsets(const std::vector<int>& offsets, std::size_t corners) {
  if (offsets.empty() || offsets.front() != 0) throw MeshError("offsets must begin with 0");
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
    if (offsets[f + 1] < offsets[f]) {
      throw MeshError("offsets[" + std::to_string(f + 1) + "] is less than the one before");
    }
  }
  if (static_cast<std::size_t>(offsets.back()) != corners) {
    throw MeshError("offsets end with " + std::to_string(offsets.back()) + ", but there are " +
                    std::to_string(corners) + " corners");
  }
}

}  // namespace

OpenMesh mesh_of_lists(Positions positions, std::vector<int> offsets, std::vector<int> corners) {
  check_offsets(offsets, corners.size());
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.face_offsets = std::move(offsets);
  mesh.face_vertices = std::move(corners);
  ReadResult checked = check_mesh(std::move(mesh));
  if (const auto* error = std::get_if<ReadError>(&checked)) throw MeshError(error->message);
  auto& file = std::get<MeshFile>(checked);
  return {std::move(file.mesh), FileSource{kArrayName, {}, "", ""}, std::move(file.warnings),
          "the mesh"};
}

OpenMesh read_mesh_file(const std::string& path) {
  LoadedSource loaded = open_source(path);
  return {std::move(loaded.mesh), std::move(loaded.source), std::move(loaded.warnings), path};
}

OpenMesh read_mesh_bytes(const std::string& name, std::string bytes) {
  LoadedSource loaded = source_of_bytes(name, std::move(bytes));
  return {std::move(loaded.mesh), std::move(loaded.source), std::move(loaded.warnings), name};
}

OpenMesh mesh_with(const Mesh& mesh, const Positions& positions) {
  OpenMesh result{mesh, FileSource{kArrayName, {}, "", ""}, {}, "the mesh"};
  result.mesh.positions = positions;
  return result;
}

OpenMesh make_conversion(const OpenMesh& mesh, const std::string& asked) {
  Converted converted = run_conversion(mesh.mesh, Request(asked, conversion_option_rows()));
  OpenMesh result = mesh_with(converted.mesh, converted.mesh.positions);
  result.warnings = std::move(converted.messages);
  return result;
}

Design complete(Design design, const OpenMesh& open) {
  if (auto* file = std::get_if<FileSource>(&design.source); file && file->bytes.empty()) {
    file->format = "obj";
    file->bytes = write_mesh(open.mesh, MeshFormat::kObj);
  }
  return design;
}

}  // namespace planish::library
