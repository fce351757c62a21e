// SPDX-License-Identifier: MIT
#include "cuts/index_rows.hpp"

#include <algorithm>
#include <utility>

#include "planish/numeric/index.hpp"

namespace planish {

IndexRows::IndexRows(RaggedRows rows) : values_(std::move(rows.values)) {
  ranges_.reserve(at(rows.size()));
  for (std::size_t row = 0; row + 1 < rows.offsets.size(); ++row) {
    const std::size_t begin = at(rows.offsets[row]);
    ranges_.push_back({begin, at(rows.offsets[row + 1]) - begin});
  }
}

void IndexRows::set(int row, const std::vector<int>& values) {
  Range& range = ranges_[at(row)];
  if (values.size() > range.count) {
    range.begin = values_.size();
    values_.resize(values_.size() + values.size());
  }
  range.count = values.size();
  std::copy(values.begin(), values.end(),
            values_.begin() + static_cast<std::ptrdiff_t>(range.begin));
}

void IndexRows::add(const std::vector<int>& values) {
  ranges_.push_back({values_.size(), 0});
  set(size() - 1, values);
}

void IndexRows::remove(const std::vector<char>& gone) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < ranges_.size(); ++row) {
    if (!gone[row]) ranges_[count++] = ranges_[row];
  }
  ranges_.resize(count);
}

}  // namespace planish
