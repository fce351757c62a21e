// SPDX-License-Identifier: MIT
/// The dense kernels of the factorization, in registers of two numbers or of four, against plain
/// loops: bit for bit.
#include "engines/panel_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Height and pivot columns of a panel.
class PanelKernels : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  [[nodiscard]] int height() const { return std::get<0>(GetParam()); }
  [[nodiscard]] int pivot() const { return std::get<1>(GetParam()); }
  /// Of a panel, column-major.
  [[nodiscard]] std::size_t place(int row, int column) const {
    return at(row) + at(column) * at(height());
  }

  [[nodiscard]] std::vector<double> panel() const {
    std::mt19937 engine(7);
    std::normal_distribution<double> number;
    std::vector<double> values(at(height()) * at(pivot()));
    for (double& value : values) value = number(engine);
    for (int j = 0; j < pivot(); ++j) values[place(j, j)] = 4.0 * height();
    return values;
  }
};

/// Cholesky an entry at a time, each sum in the order of the columns. Below a block of three
/// columns a pivot's reciprocal is taken once.
TEST_P(PanelKernels, EliminateAsPlainLoopsDo) {
  std::vector<double> plain = panel();
  for (int j = 0; j < pivot(); ++j) {
    const int block_end = 3 * (j / 3) + 3;
    for (int i = j; i < height(); ++i) {
      double sum = plain[place(i, j)];
      for (int k = 0; k < j; ++k) sum -= plain[place(i, k)] * plain[place(j, k)];
      const bool inside = i < block_end;
      const double diagonal = plain[place(j, j)];
      if (i == j) {
        plain[place(i, j)] = std::sqrt(sum);
      } else {
        plain[place(i, j)] = inside ? sum / diagonal : sum * (1.0 / diagonal);
      }
    }
  }
  std::vector<double> values = panel();
  ASSERT_TRUE(eliminate_panel(values.data(), height(), pivot()));
  for (int j = 0; j < pivot(); ++j) {
    for (int i = j; i < height(); ++i) {
      ASSERT_EQ(values[place(i, j)], plain[place(i, j)]) << i << ", " << j;
    }
  }
}

TEST_P(PanelKernels, UpdateAsPlainLoopsDo) {
  const std::vector<double> values = panel();
  const int side = height() - pivot();
  std::vector<double> plain(at(side) * at(side), 0.5);
  std::vector<double> update = plain;
  for (int j = 0; j < side; ++j) {
    for (int i = j; i < side; ++i) {
      double& sum = plain[at(i) + at(j) * at(side)];
      for (int k = 0; k < pivot(); ++k) {
        sum -= values[place(pivot() + i, k)] * values[place(pivot() + j, k)];
      }
    }
  }
  update_front(values.data(), height(), pivot(), update.data());
  for (int j = 0; j < side; ++j) {
    for (int i = j; i < side; ++i) {
      const std::size_t entry = at(i) + at(j) * at(side);
      ASSERT_EQ(update[entry], plain[entry]) << i << ", " << j;
    }
  }
}

// Rows in all of what is done twelve, six and three at a time.
INSTANTIATE_TEST_SUITE_P(OfSizes, PanelKernels,
                         testing::Values(std::tuple(3, 3), std::tuple(9, 3), std::tuple(15, 6),
                                         std::tuple(24, 12), std::tuple(36, 15),
                                         std::tuple(81, 30)));

}  // namespace
}  // namespace planish
