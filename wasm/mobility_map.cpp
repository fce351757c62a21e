// SPDX-License-Identifier: MIT
#include "mobility_map.hpp"

#include <utility>

#include "planish/mobility/best_places.hpp"

namespace planish {

MobilityOptions map_options(HandleEditOptions edit) {
  MobilityOptions options;
  const HandleEditOptions usual = MobilityOptions::default_edit();
  options.edit = std::move(edit);
  options.edit.engine = usual.engine;
  options.edit.reach = usual.reach;
  options.edit.reach_length = 0.0;
  add_unstated(options.edit.bounds, usual.bounds);
  return options;
}

Refusal find_map_problem(const Mesh& mesh, const MobilityOptions& options) {
  if (auto problem = find_problem(options)) return problem;
  return find_broken_constraint(mesh, options.edit);
}

MobilityMap::MobilityMap(Mesh mesh, const MobilityOptions& options)
    : mesh_(std::move(mesh)), adjacency_(build_adjacency(mesh_)), meter_(mesh_, options) {}

std::vector<MobilityRow> MobilityMap::measure(int vertex) {
  const auto measured = meter_.measure(vertex);
  rows_.insert(rows_.end(), measured.begin(), measured.end());
  return {measured.begin(), measured.end()};
}

std::vector<MobilityRow> MobilityMap::best(int count) const {
  return best_places(adjacency_, rows_, count);
}

}  // namespace planish
