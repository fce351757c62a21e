// SPDX-License-Identifier: MIT
/// Rows of indices that change their lengths, in one piece of memory: a mesh of them costs no more
/// than copying it.
#pragma once

#include <span>
#include <vector>

#include "planish/mesh/adjacency.hpp"

namespace planish {

class IndexRows {
 public:
  explicit IndexRows(RaggedRows rows);

  [[nodiscard]] int size() const { return static_cast<int>(ranges_.size()); }

  /// Valid until a row is set or added.
  [[nodiscard]] std::span<const int> operator[](int row) const {
    const Range& range = ranges_[static_cast<std::size_t>(row)];
    return std::span<const int>(values_).subspan(range.begin, range.count);
  }

  void set(int row, const std::vector<int>& values);
  void add(const std::vector<int>& values);

  /// Takes out the rows that are in `gone`, one flag a row.
  void remove(const std::vector<char>& gone);

 private:
  struct Range {
    std::size_t begin = 0, count = 0;
  };

  std::vector<Range> ranges_;
  std::vector<int> values_;  ///< those of longer rows that were set are behind all others
};

}  // namespace planish
