// SPDX-License-Identifier: MIT
#include "splitting/local_flatness.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "planish/measures/folds.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/projection/projection.hpp"

namespace planish {
namespace {

/// Fair first, which folds less; then the nearest.
constexpr std::array<double, 2> kFairness = {10.0, 0.0};

/// Panels around some points as a mesh of their own.
struct LocalMesh {
  Mesh mesh;
  std::vector<int> points;  ///< ascending: which of the whole mesh
  std::vector<int> pins;    ///< by their numbers here
};

std::vector<int> with_corners(const Mesh& mesh, std::span<const int> faces) {
  std::vector<int> points;
  for (const int f : faces) points.insert(points.end(), mesh.face(f).begin(), mesh.face(f).end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

LocalMesh local_mesh(const Mesh& mesh, std::span<const int> about, int reach) {
  const Adjacency adjacency = build_adjacency(mesh);
  std::vector<int> free(about.begin(), about.end());
  for (int ring = 0; ring < reach; ++ring) free = with_corners(mesh, faces_of(adjacency, free));
  std::sort(free.begin(), free.end());
  const std::vector<int> faces = faces_of(adjacency, free);
  LocalMesh local;
  local.points = with_corners(mesh, faces);
  local.mesh.positions.resize(3, static_cast<Eigen::Index>(local.points.size()));
  for (std::size_t k = 0; k < local.points.size(); ++k) {
    local.mesh.positions.col(static_cast<Eigen::Index>(k)) = mesh.positions.col(local.points[k]);
    if (!std::binary_search(free.begin(), free.end(), local.points[k])) {
      local.pins.push_back(static_cast<int>(k));
    }
  }
  for (const int f : faces) {
    for (const int v : mesh.face(f)) {
      const auto place = std::lower_bound(local.points.begin(), local.points.end(), v);
      local.mesh.face_vertices.push_back(static_cast<int>(place - local.points.begin()));
    }
    local.mesh.face_offsets.push_back(static_cast<int>(local.mesh.face_vertices.size()));
  }
  return local;
}

}  // namespace

std::variant<Positions, std::string> flat_around(const Mesh& mesh, std::span<const int> about,
                                                 const NearbyOptions& options,
                                                 const Progress& progress) {
  const LocalMesh local = local_mesh(mesh, about, options.reach);
  ProjectionOptions projection;
  projection.tolerance = options.tolerance;
  for (const double fairness : kFairness) {
    projection.fairness_weight = fairness;
    const ProjectionResult result = project_to_planar(local.mesh, projection, local.pins, progress);
    if (result.report.status == SolveStatus::kCancelled) return "stopped";
    if (!result.report.usable() || !result.failing_faces.empty()) continue;
    Positions positions = mesh.positions;
    for (std::size_t k = 0; k < result.moved.size(); ++k) {
      positions.col(local.points[at(result.moved[k])]) =
          result.moved_positions.col(static_cast<Eigen::Index>(k));
    }
    return positions;
  }
  return "no flat and sound mesh was found with " + std::to_string(options.reach) +
         " rings of panels around; a wider reach may help";
}

}  // namespace planish
