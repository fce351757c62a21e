// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/gltf_axes.hpp"
#include "io/gltf_container.hpp"
#include "io/gltf_design.hpp"
#include "io/gltf_scene.hpp"
#include "io/polygon_fans.hpp"
#include "planish/io/gltf.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/mesh/mesh_repair.hpp"
#include "planish/mesh/point_joining.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

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

/// The faces with their outside on the other side, each from the same corner.
FaceList turned_over(FaceList faces) {
  for (std::size_t f = 1; f < faces.offsets.size(); ++f) {
    std::reverse(faces.vertices.begin() + faces.offsets[f - 1] + 1,
                 faces.vertices.begin() + faces.offsets[f]);
  }
  return faces;
}

/// Panels of a piece with recorded sizes, by the best evidence there is. Programs that shade panels
/// flat give each its own points, or each triangle: these are taken as one to find the panels.
FaceList recorded_panels(const ScenePiece& piece, std::vector<std::string>& warnings) {
  if (auto faces = decode_fans(piece.triangles, *piece.sizes)) return *faces;
  std::vector<int> triangles = piece.triangles;
  const JoinedPoints joined = find_joined_points(piece.positions, 0.0);
  for (int& v : triangles) {
    const int target = joined.target[static_cast<std::size_t>(v)];
    v = joined.kept[static_cast<std::size_t>(target)];
  }
  if (auto faces = decode_fans(triangles, *piece.sizes)) return *faces;
  if (auto faces = merge_coplanar(piece.positions, triangles, *piece.sizes)) {
    warnings.push_back(
        "another program reordered the triangles; the panels were recovered by joining coplanar "
        "triangles, so their order may have changed");
    return *faces;
  }
  throw ReadError{
      "another program changed the triangles, and the panels cannot be recovered from them"};
}

FaceList panels_of(const ScenePiece& piece, std::vector<std::string>& warnings) {
  FaceList faces;
  if (piece.sizes) {
    faces = recorded_panels(piece, warnings);
  } else {
    warnings.push_back(
        "the file records no panels, only triangles; every triangle is read as a panel");
    faces = triangle_faces(piece.triangles);
  }
  return piece.mirrored ? turned_over(std::move(faces)) : faces;
}

Mesh joined_mesh(const std::vector<ScenePiece>& pieces, std::vector<std::string>& warnings) {
  Mesh mesh;
  Eigen::Index vertex_count = 0;
  for (const ScenePiece& piece : pieces) vertex_count += piece.positions.cols();
  mesh.positions.resize(3, vertex_count);
  Eigen::Index next_vertex = 0;
  for (const ScenePiece& piece : pieces) {
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

/// How far apart points of all pieces may be that are one. Where the file records panels, points at
/// one place may have been two on purpose, so that they may also stay apart.
std::vector<double> joining_reaches(const Mesh& mesh, const std::vector<ScenePiece>& pieces) {
  double rounding = 0.0;
  for (const ScenePiece& piece : pieces) rounding = std::max(rounding, piece.rounding);
  return {safe_joining(mesh, std::isfinite(rounding) ? rounding : 0.0), 0.0};
}

/// The checked mesh with its points joined; throws ReadError. Other programs store a vertex once
/// per face, and each instance has points of its own: faces only hang together once these are
/// joined. Where that gives no mesh, points within rounding stay apart, then all points of panels.
MeshFile checked(const Mesh& mesh, const std::vector<ScenePiece>& pieces,
                 std::vector<std::string> warnings) {
  ReadResult result = ReadError{};
  for (const double reach : joining_reaches(mesh, pieces)) {
    const JoinedPoints joined = find_joined_points(mesh.positions, reach);
    result = repair_and_check(with_joined_points(mesh, joined));
    if (!std::holds_alternative<MeshFile>(result)) continue;
    if (joined.joined() > 0) warnings.push_back(joined_text(joined));
    break;
  }
  if (std::holds_alternative<ReadError>(result) && pieces[0].sizes) {
    result = repair_and_check(mesh);
  }
  if (auto* error = std::get_if<ReadError>(&result)) throw std::move(*error);
  MeshFile file = std::get<MeshFile>(std::move(result));
  file.warnings.insert(file.warnings.begin(), warnings.begin(), warnings.end());
  return file;
}

/// A mesh to which nothing is done: it was whole when it was saved. Throws ReadError.
MeshFile checked_as_stored(Mesh mesh, std::vector<std::string> warnings) {
  ReadResult result = check_mesh(std::move(mesh));
  if (auto* error = std::get_if<ReadError>(&result)) throw std::move(*error);
  MeshFile file = std::get<MeshFile>(std::move(result));
  file.warnings.insert(file.warnings.begin(), warnings.begin(), warnings.end());
  return file;
}

/// Puts the stored exact design in place of what the triangles say, where both still agree.
GlbFile restored(std::vector<ScenePiece> pieces, std::optional<StoredDesign> stored,
                 std::vector<std::string> warnings) {
  GlbFile glb;
  glb.file.warnings = std::move(warnings);
  if (stored && pieces.size() == 1 && pieces[0].sizes &&
      still_matches(pieces[0].positions, stored->positions)) {
    pieces[0].positions = stored->positions;  // exact, even if only the panels fit no more
    const auto faces = decode_fans(pieces[0].triangles, *pieces[0].sizes);
    if (faces && same_up_to_rotation(*faces, stored->faces)) {
      glb.file.mesh = {std::move(stored->positions), std::move(stored->faces.offsets),
                       std::move(stored->faces.vertices), std::move(stored->groups)};
      glb.file = checked_as_stored(std::move(glb.file.mesh), std::move(glb.file.warnings));
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
  const Mesh mesh = joined_mesh(pieces, glb.file.warnings);
  glb.file = checked(mesh, pieces, std::move(glb.file.warnings));
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
    std::vector<std::string> warnings;
    std::vector<ScenePiece> pieces = collect_pieces(model, bytes.size(), warnings);
    GlbFile glb = restored(std::move(pieces), load_design(model.asset.extras), std::move(warnings));
    check_base(glb);
    return glb;
  } catch (const ReadError& error) {  // thrown inside the readers of GLB only
    return error;
  }
}

ReadResult read_glb(std::string_view bytes) {
  auto result = read_glb_design(bytes);
  if (auto* error = std::get_if<ReadError>(&result)) return std::move(*error);
  return std::move(std::get<GlbFile>(result).file);
}

}  // namespace planish
