// SPDX-License-Identifier: MIT
#include "engines/working_set.hpp"

#include <algorithm>
#include <iterator>

#include "planish/numeric/index.hpp"

namespace planish {

std::vector<int> set_union(std::span<const int> one, std::span<const int> other) {
  std::vector<int> both;
  std::set_union(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(both));
  return both;
}

WorkingSetGrower::WorkingSetGrower(const MeshModel& model)
    : model_(model),
      mark_(at(model.vertex_count()), 0),
      face_mark_(at(model.mesh.face_count()), 0) {}

void WorkingSetGrower::add_once(int vertex, std::vector<int>& set) {
  if (mark_[at(vertex)] == stamp_) return;
  mark_[at(vertex)] = stamp_;
  set.push_back(vertex);
}

std::vector<int> WorkingSetGrower::grow(std::span<const int> seeds, int rings) {
  ++stamp_;
  std::vector<int> set;
  const auto add = [&](int v) { add_once(v, set); };
  for (const int v : seeds) add(v);
  std::size_t begin = 0;
  for (int ring = 0; ring < rings && begin < set.size(); ++ring) {
    const std::size_t end = set.size();
    for (std::size_t k = begin; k < end; ++k) {
      for (const int f : model_.adjacency.faces[set[k]]) {
        if (face_mark_[at(f)] == stamp_) continue;  // a panel of 10,000 corners is walked once
        face_mark_[at(f)] = stamp_;
        for (const int w : model_.face(f)) add(w);
      }
    }
    begin = end;
  }
  std::sort(set.begin(), set.end());
  return set;
}

std::vector<int> WorkingSetGrower::neighbourhood(std::span<const int> seeds) {
  ++stamp_;
  std::vector<int> set;
  const auto add = [&](int v) { add_once(v, set); };
  for (const int v : seeds) {
    add(v);
    for (const int w : model_.adjacency.neighbours[v]) add(w);
  }
  std::sort(set.begin(), set.end());
  return set;
}

void WorkingSetGrower::follow(int from, int vertex, int length, std::vector<int>& out) const {
  for (int step = 0; step < length; ++step) {
    out.push_back(vertex);
    const auto around = model_.adjacency.neighbours[vertex];
    const auto found = std::find(around.begin(), around.end(), from);
    if (model_.adjacency.boundary[at(vertex)] || around.size() % 2 != 0 || found == around.end()) {
      return;
    }
    const auto index = static_cast<std::size_t>(found - around.begin());
    const int next = around[(index + around.size() / 2) % around.size()];
    from = vertex;
    vertex = next;
  }
}

std::vector<int> WorkingSetGrower::lines_through(int vertex, int length) const {
  const auto around = model_.adjacency.neighbours[vertex];
  if (!model_.adjacency.boundary[at(vertex)] && around.size() % 2 != 0) return {};
  std::vector<int> line{vertex};
  for (const int neighbour : around) follow(vertex, neighbour, length, line);
  return line;
}

std::vector<int> WorkingSetGrower::with_lines_ahead(std::span<const int> movers,
                                                    std::span<const int> inside, int length) const {
  std::vector<int> set(movers.begin(), movers.end());
  for (const int v : movers) {
    for (const int before : model_.adjacency.neighbours[v]) {
      if (std::binary_search(inside.begin(), inside.end(), before)) follow(before, v, length, set);
    }
  }
  std::sort(set.begin(), set.end());
  set.erase(std::unique(set.begin(), set.end()), set.end());
  return set;
}

}  // namespace planish
