// SPDX-License-Identifier: MIT
/// Dense kernels of the multifrontal factorization for 3 × 3 blocks: the panels are a few dozen
/// columns wide, where a general matrix product spends more time packing than multiplying.
#pragma once

#include <cstddef>

namespace planish {

/// Cholesky of the leading `pivot` columns of a panel, in place, and the rows below scaled.
/// @param panel column-major, `height` rows with stride `height`; lower triangle read and written
/// @param height, pivot multiples of 3, pivot ≤ height
/// @returns false at a pivot that is not positive
[[nodiscard]] bool eliminate_panel(double* panel, std::ptrdiff_t height, std::ptrdiff_t pivot);

/// update ← update − B Bᵀ, lower triangle, B the rows below the pivots of an eliminated panel.
/// @param update (height − pivot)², column-major, contiguous
void update_front(const double* panel, std::ptrdiff_t height, std::ptrdiff_t pivot, double* update);

}  // namespace planish
