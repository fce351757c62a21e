// SPDX-License-Identifier: MIT
/// Where an edit may move anything at all.
#pragma once

#include <span>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Whether `options` limit where an edit may move anything.
[[nodiscard]] bool has_reach(const HandleEditOptions& options);

/// Adds the points that rest on a keep-out in the base to `held`. O(n).
void hold_resting(const Mesh& mesh, const HandleEditOptions& options, std::vector<int>& held);

/// Walks from the handles over the faces; costs what it finds, and O(n) marks on the first walk.
class EditReach {
 public:
  EditReach(const Mesh& mesh, const Adjacency& adjacency) : mesh_(mesh), adjacency_(adjacency) {}

  /// Vertices within the reach of one of the handles, these first; no duplicates, not sorted. The
  /// walk does not cross what lies farther than `reach_length`. [RCH-1]
  [[nodiscard]] std::vector<int> within(std::span<const Handle> handles,
                                        const HandleEditOptions& options);

 private:
  void add(int vertex, std::vector<int>& found);
  void add_ring(std::size_t begin, std::size_t end, double length, std::vector<int>& found);
  [[nodiscard]] bool is_near(int vertex, double length) const;

  const Mesh& mesh_;
  const Adjacency& adjacency_;
  std::vector<int> vertex_mark_, face_mark_;
  int stamp_ = 0;
  std::vector<Eigen::Vector3d> centres_;  ///< base positions of the handles, by x
};

}  // namespace planish
