// SPDX-License-Identifier: MIT
/// Growing vertex sets over a mesh at the cost of the set, not of the mesh. [WSN-4]
#pragma once

#include <span>
#include <vector>

#include "planish/problem/problem.hpp"

namespace planish {

/// The vertices of either of two sets; both and the result ascending, no duplicates.
[[nodiscard]] std::vector<int> set_union(std::span<const int> one, std::span<const int> other);

class WorkingSetGrower {
 public:
  explicit WorkingSetGrower(const MeshModel& model);

  /// `seeds` and everything within `rings` face rings of them, ascending, no duplicates.
  [[nodiscard]] std::vector<int> grow(std::span<const int> seeds, int rings);

  /// `seeds` and their neighbours along edges, ascending, no duplicates.
  [[nodiscard]] std::vector<int> neighbourhood(std::span<const int> seeds);

  /// The edge polylines through `vertex`, at most `length` edges each way, `vertex` included. Empty
  /// where no line goes straight (odd interior valence).
  [[nodiscard]] std::vector<int> lines_through(int vertex, int length) const;

  /// `movers` and what comes next, at most `length` vertices, along each edge polyline that leaves
  /// the set `inside` (ascending) at one of them; ascending, no duplicates.
  [[nodiscard]] std::vector<int> with_lines_ahead(std::span<const int> movers,
                                                  std::span<const int> inside, int length) const;

 private:
  /// Unless it has the stamp already.
  void add_once(int vertex, std::vector<int>& set);
  void follow(int from, int vertex, int length, std::vector<int>& out) const;

  const MeshModel& model_;
  std::vector<int> mark_, face_mark_;
  int stamp_ = 0;
};

}  // namespace planish
