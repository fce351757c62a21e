// SPDX-License-Identifier: MIT
#include "planish/measures/metrics.hpp"

#include <algorithm>
#include <cstring>

namespace planish {
PlanaritySummary planarity_summary(const Mesh& mesh) {
  return planarity_summary(mesh, mesh.positions);
}

PlanaritySummary planarity_summary(const Mesh& mesh, const Positions& positions) {
  PlanaritySummary summary;
  int counted = 0;
  double sum = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() < 4) continue;
    const FacePlanarity here = face_planarity(positions, mesh.face(f));
    ++counted;
    sum += here.mm_per_m;
    if (!(here.mm_per_m <= summary.max) || summary.worst_face < 0) {
      summary.max = here.mm_per_m;
      summary.worst_face = f;
      summary.worst_gap = here.gap;
    }
    summary.max_gap = std::max(summary.max_gap, here.gap);
    if (!(here.excess <= summary.max_excess)) summary.max_excess = here.excess;
  }
  if (counted > 0) summary.mean = sum / counted;
  return summary;
}

int degrees_of_freedom(const Mesh& mesh) {
  std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const int v : mesh.face_vertices) used[static_cast<std::size_t>(v)] = 1;
  int freedom = 3 * static_cast<int>(std::count(used.begin(), used.end(), 1));
  for (int f = 0; f < mesh.face_count(); ++f) {
    freedom -= static_cast<int>(mesh.face(f).size()) - 3;
  }
  return freedom;
}

std::vector<int> moved_vertices(const Positions& before, const Positions& after) {
  std::vector<int> moved;
  for (Eigen::Index v = 0; v < before.cols(); ++v) {
    if (std::memcmp(before.col(v).data(), after.col(v).data(), 3 * sizeof(double)) != 0) {
      moved.push_back(static_cast<int>(v));
    }
  }
  return moved;
}

int moved_vertex_count(const Positions& before, const Positions& after) {
  return static_cast<int>(moved_vertices(before, after).size());
}

}  // namespace planish
