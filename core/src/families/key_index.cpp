// SPDX-License-Identifier: MIT
#include "families/key_index.hpp"

#include <numeric>

#include "planish/numeric/index.hpp"

namespace planish {

KeyIndex::KeyIndex(const Eigen::MatrixXd& keys) : keys_(keys.rows(), keys.cols()) {
  if (keys.cols() == 0) return;
  (keys.rowwise().maxCoeff() - keys.rowwise().minCoeff()).maxCoeff(&axis_);
  columns_.resize(at(keys.cols()));
  std::iota(columns_.begin(), columns_.end(), 0);
  std::stable_sort(columns_.begin(), columns_.end(),
                   [&](int a, int b) { return keys(axis_, a) < keys(axis_, b); });
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    keys_.col(static_cast<Eigen::Index>(k)) = keys.col(columns_[k]);
    first_.push_back(keys(axis_, columns_[k]));
  }
}

}  // namespace planish
