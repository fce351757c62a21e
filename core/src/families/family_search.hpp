// SPDX-License-Identifier: MIT
/// From shapes with as many columns each to templates that cover all of them.
#pragma once

#include <optional>
#include <vector>

#include "families/key_index.hpp"
#include "families/shape_space.hpp"

namespace planish {

/// A template and the shapes that it stands for.
struct Cluster {
  MeasuredShape shape;
  std::vector<int> members;
};

/// A greedy cover by the shapes themselves, whose templates then move to reach more, and of which
/// clusters go that others can take in. [FAM-2]
class FamilySearch {
 public:
  /// @param shapes in an order that depends on the shapes alone; no two the same
  FamilySearch(ShapeSpace& space, const std::vector<MeasuredShape>& shapes, double within);

  /// Every shape is a member of one cluster, within the distance of its template.
  [[nodiscard]] std::vector<Cluster> find();

 private:
  std::vector<Cluster> cover(bool growing);
  std::vector<std::vector<int>> reach_of(const std::vector<int>& centres);
  std::size_t stride_of(const std::vector<int>& open);
  void pick(const std::vector<int>& centres, std::size_t stride, bool growing,
            std::vector<Cluster>& clusters);
  int open_count(const std::vector<int>& reach) const;

  void grow(Cluster& cluster);
  void take_more(Cluster& cluster);
  std::vector<int> covered_by(const MeasuredShape& shape);
  std::vector<int> just_beyond(const Cluster& cluster);

  std::optional<MeasuredShape> centre_of(const MeasuredShape& start,
                                         const std::vector<int>& members);
  double worst_on(const MeasuredShape& shape, const std::vector<int>& members, double bound);

  void drop_clusters(std::vector<Cluster>& clusters);
  bool give_away(std::size_t giver, std::vector<Cluster>& clusters, const KeyIndex& index);
  void settle(std::vector<Cluster>& clusters);

  ShapeSpace& space_;
  const std::vector<MeasuredShape>& shapes_;
  double within_;
  KeyIndex index_;
  std::size_t pairs_ = 0;   ///< with near keys, of the round with most
  std::vector<char> open_;  ///< 1 for a shape that no cluster has yet
};

}  // namespace planish
