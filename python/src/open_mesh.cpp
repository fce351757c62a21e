// SPDX-License-Identifier: MIT
#include "open_mesh.hpp"

#include <limits>
#include <utility>
#include <variant>

#include "arguments.hpp"
#include "files.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/mesh_check.hpp"

namespace planish::python {

namespace py = pybind11;
using cli::CommandError;

namespace {

constexpr const char* kArrayName = "mesh.obj";  ///< of a mesh that came without a file

/// Offsets and corners within int and in order; what the corners mean is check_mesh()'s.
std::vector<int> whole_numbers(const Indices& values, const char* what) {
  std::vector<int> result(static_cast<std::size_t>(values.size()));
  for (py::ssize_t k = 0; k < values.size(); ++k) {
    const long long value = values.data()[k];
    if (value < 0 || value > std::numeric_limits<int>::max()) {
      throw CommandError(cli::kInvalidMesh, std::string(what) + "[" + std::to_string(k) + "] is " +
                                                std::to_string(value) + ", no index from 0");
    }
    result[static_cast<std::size_t>(k)] = static_cast<int>(value);
  }
  return result;
}

void check_offsets(const std::vector<int>& offsets, std::size_t corners) {
  if (offsets.empty() || offsets.front() != 0) {
    throw CommandError(cli::kInvalidMesh, "offsets must begin with 0");
  }
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
    if (offsets[f + 1] < offsets[f]) {
      throw CommandError(cli::kInvalidMesh,
                         "offsets[" + std::to_string(f + 1) + "] is less than the one before");
    }
  }
  if (static_cast<std::size_t>(offsets.back()) != corners) {
    throw CommandError(cli::kInvalidMesh, "offsets end with " + std::to_string(offsets.back()) +
                                              ", but there are " + std::to_string(corners) +
                                              " corners");
  }
}

}  // namespace

OpenMesh mesh_of_arrays(const Points& points, const Indices& offsets, const Indices& corners) {
  if (points.ndim() != 2 || points.shape(1) != 3) {
    throw CommandError(cli::kInvalidMesh, "points must be an array of shape (n, 3)");
  }
  Mesh mesh;
  mesh.positions = Eigen::Map<const Positions>(points.data(), 3, points.shape(0));
  mesh.face_offsets = whole_numbers(offsets, "offsets");
  mesh.face_vertices = whole_numbers(corners, "corners");
  check_offsets(mesh.face_offsets, mesh.face_vertices.size());
  ReadResult checked = check_mesh(std::move(mesh));
  if (const auto* error = std::get_if<ReadError>(&checked)) {
    throw CommandError(cli::kInvalidMesh, error->message);
  }
  auto& file = std::get<MeshFile>(checked);
  return {std::move(file.mesh), FileSource{kArrayName, 0, "", ""}, std::move(file.warnings),
          "the mesh"};
}

OpenMesh read_mesh_file(const std::string& path) {
  cli::LoadedSource loaded = cli::open_source(path);
  return {std::move(loaded.mesh), std::move(loaded.source), std::move(loaded.warnings), path};
}

OpenMesh mesh_with(const Mesh& mesh, const Positions& positions) {
  OpenMesh result{mesh, FileSource{kArrayName, 0, "", ""}, {}, "the mesh"};
  result.mesh.positions = positions;
  return result;
}

Points points_array(const Positions& positions) {
  return Points(std::vector<py::ssize_t>{positions.cols(), 3}, positions.data());
}

Indices moved_array(const Positions& before, const Positions& after) {
  std::vector<long long> moved;
  for (Eigen::Index v = 0; v < before.cols(); ++v) {
    if (before.col(v) != after.col(v)) moved.push_back(v);
  }
  return Indices(static_cast<py::ssize_t>(moved.size()), moved.data());
}

DesignSource complete_source(const OpenMesh& open) {
  DesignSource source = open.source;
  if (auto* file = std::get_if<FileSource>(&source); file && file->bytes.empty()) {
    file->format = "obj";
    file->bytes = write_mesh(open.mesh, MeshFormat::kObj);
  }
  return source;
}

}  // namespace planish::python
