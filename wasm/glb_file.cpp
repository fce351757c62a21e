// SPDX-License-Identifier: MIT
#include "glb_file.hpp"

#include <utility>

#include "planish/io/obj.hpp"
#include "planish/mesh/orientation.hpp"
#include "planish/mesh/point_joining.hpp"
#include "planish/mesh/triangle_pairs.hpp"

namespace planish {

std::variant<OpenedGlb, std::string> open_glb(std::string_view bytes) {
  auto read = read_glb_design(bytes);
  if (auto* error = std::get_if<ReadError>(&read)) return std::move(error->message);
  auto& glb = std::get<GlbFile>(read);
  OpenedGlb opened;
  opened.warnings = std::move(glb.file.warnings);
  Mesh& mesh = glb.file.mesh;
  if (glb.base && !glb.design.empty()) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.positions.col(v) != glb.base->col(v)) opened.moved.push_back(v);
    }
    opened.positions = mesh.positions(Eigen::all, opened.moved);
    opened.design = std::move(glb.design);
    mesh.positions = std::move(*glb.base);
  }
  opened.mesh = write_obj(mesh);
  return opened;
}

std::string assemble_glb(std::string_view mesh, const GlbContent& content) {
  const ReadResult read = read_obj(mesh);
  const auto* file = std::get_if<MeshFile>(&read);
  if (file == nullptr) return "";
  for (const auto& points : {content.base, content.offset}) {
    if (points && points->cols() != file->mesh.positions.cols()) return "";
  }
  return write_glb(file->mesh, content);
}

std::string mended(std::string_view mesh, std::string_view way) {
  const ReadResult read = read_obj(mesh);
  const auto* file = std::get_if<MeshFile>(&read);
  if (file == nullptr) return "";
  if (way == "joinTriangles") return write_obj(join_triangles(file->mesh));
  if (way == "orient") return write_obj(oriented(file->mesh).mesh);
  const ReadResult joined = join_points(file->mesh);
  const auto* whole = std::get_if<MeshFile>(&joined);
  return whole == nullptr ? "" : write_obj(whole->mesh);
}

}  // namespace planish
