// SPDX-License-Identifier: MIT
#include "planish/mobility/best_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace planish {
namespace {

bool changes_shape(const MobilityRow& row) {
  return row.distance > 0.0 && std::abs(row.direction.z()) == 1.0;
}

bool is_better_place(const MobilityRow& one, const MobilityRow& other) {
  const auto rank = [](const MobilityRow& row) {
    return std::tuple(-row.distance, row.remake, row.sharpest_fold, row.vertex, -row.direction.z());
  };
  return rank(one) < rank(other);
}

/// Marks what lies fewer than kPlacesApart edges from `vertex`.
void mark_around(const Adjacency& adjacency, int vertex, std::vector<char>& marked) {
  std::vector<int> found = {vertex};
  std::vector<char> seen(marked.size(), 0);
  seen[static_cast<std::size_t>(vertex)] = 1;
  std::size_t begin = 0;
  for (int ring = 0; ring < kPlacesApart; ++ring) {
    const std::size_t end = found.size();
    for (; begin < end; ++begin) {
      const int v = found[begin];
      marked[static_cast<std::size_t>(v)] = 1;
      for (const int w : adjacency.neighbours[v]) {
        if (seen[static_cast<std::size_t>(w)] != 0) continue;
        seen[static_cast<std::size_t>(w)] = 1;
        found.push_back(w);
      }
    }
  }
}

}  // namespace

std::vector<MobilityRow> best_places(const Adjacency& adjacency, std::vector<MobilityRow> rows,
                                     int count) {
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const MobilityRow& row) { return !changes_shape(row); }),
             rows.end());
  std::sort(rows.begin(), rows.end(), is_better_place);
  std::vector<MobilityRow> places;
  std::vector<char> taken(static_cast<std::size_t>(adjacency.neighbours.size()), 0);
  for (const MobilityRow& row : rows) {
    if (static_cast<int>(places.size()) == count) break;
    if (taken[static_cast<std::size_t>(row.vertex)] != 0) continue;
    places.push_back(row);
    mark_around(adjacency, row.vertex, taken);
  }
  return places;
}

}  // namespace planish
