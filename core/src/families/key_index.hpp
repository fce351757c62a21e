// SPDX-License-Identifier: MIT
/// Which keys are near a key, in every one of their numbers.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace planish {

/// Sorted by the number that differs most. Keys of one length; a question costs those that are near
/// in that number.
class KeyIndex {
 public:
  /// @param keys a column each
  explicit KeyIndex(const Eigen::MatrixXd& keys);

  /// Calls `found(column)` for each key within `distance` of `key`, in an order that depends on the
  /// keys alone where no two are equal.
  template <typename Found>
  void near(const Eigen::VectorXd& key, double distance, Found&& found) const {
    const auto low = std::lower_bound(first_.begin(), first_.end(), key(axis_) - distance);
    for (auto at = low - first_.begin(); at < keys_.cols(); ++at) {
      if (first_[static_cast<std::size_t>(at)] > key(axis_) + distance) break;
      if (is_near(at, key, distance)) found(columns_[static_cast<std::size_t>(at)]);
    }
  }

 private:
  [[nodiscard]] bool is_near(Eigen::Index at, const Eigen::VectorXd& key, double distance) const {
    for (Eigen::Index k = 0; k < key.size(); ++k) {
      if (std::abs(keys_(k, at) - key(k)) > distance) return false;
    }
    return true;
  }

  Eigen::Index axis_ = 0;
  std::vector<double> first_;  ///< that number of each key, ascending
  std::vector<int> columns_;   ///< of each in the order of `first_`
  Eigen::MatrixXd keys_;       ///< likewise
};

}  // namespace planish
