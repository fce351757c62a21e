// SPDX-License-Identifier: MIT
#include "engines/row_update.hpp"

#include <algorithm>
#include <utility>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr std::size_t kMostChanges = 200;  ///< beyond it another factorization is quicker

}  // namespace

void RowUpdate::begin(const std::vector<char>& active) {
  factorized_ = active;
  rows_.clear();
  columns_.clear();
  changes_.clear();
}

std::vector<RowUpdate::Change> RowUpdate::changes_to(const std::vector<char>& active) const {
  std::vector<Change> changes;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const bool was = !factorized_.empty() && factorized_[i] != 0;
    const bool is = active[i] != 0;
    if (was != is) changes.push_back({static_cast<int>(i), is, -1});
  }
  return changes;
}

int RowUpdate::column_of(int row, const RowJacobian& rows, const Inverse& inverse) {
  const auto found = std::find(rows_.begin(), rows_.end(), row);
  if (found != rows_.end()) return static_cast<int>(found - rows_.begin());
  rows_.push_back(row);
  columns_.push_back(rows.transposed(row));
  inverse(columns_.back());
  return static_cast<int>(rows_.size()) - 1;
}

bool RowUpdate::set(const std::vector<char>& active, double penalty, const RowJacobian& rows,
                    const Inverse& inverse) {
  std::vector<Change> changes = changes_to(active);
  if (changes.size() > kMostChanges) return false;
  const auto count = static_cast<Eigen::Index>(changes.size());
  Eigen::MatrixXd small(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    Change& change = changes[static_cast<std::size_t>(k)];
    change.column = column_of(change.row, rows, inverse);
    for (Eigen::Index l = 0; l <= k; ++l) {
      const int column = changes[static_cast<std::size_t>(l)].column;
      small(k, l) = rows.apply(change.row, columns_[at(column)]);
    }
    small(k, k) += (change.came ? 1.0 : -1.0) / penalty;
  }
  Eigen::LDLT<Eigen::MatrixXd> factor(small);  // reads the lower triangle
  const auto went = std::count_if(changes.begin(), changes.end(),
                                  [](const Change& change) { return !change.came; });
  if (count > 0 && (factor.vectorD().array() < 0.0).count() != went) return false;
  changes_ = std::move(changes);
  small_ = std::move(factor);
  return true;
}

void RowUpdate::apply(const RowJacobian& rows, Eigen::Matrix3Xd& x) const {
  if (changes_.empty()) return;
  Eigen::VectorXd along(static_cast<Eigen::Index>(changes_.size()));
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    along[static_cast<Eigen::Index>(k)] = rows.apply(changes_[k].row, x);
  }
  along = small_.solve(along);
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    x -= along[static_cast<Eigen::Index>(k)] * columns_[at(changes_[k].column)];
  }
}

}  // namespace planish
