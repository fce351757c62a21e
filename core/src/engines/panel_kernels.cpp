// SPDX-License-Identifier: MIT
#include "engines/panel_kernels.hpp"

#include <Eigen/Core>
#include <cmath>

namespace planish {
namespace {

using Eigen::Index;
using Packet = Eigen::internal::Packet2d;

/// C (6 × 3, stride c_stride) −= A (6 × depth) · B (3 × depth)ᵀ; A and B have stride `stride`.
inline void subtract_product_6x3(const double* a, const double* b, Index stride, Index depth,
                                 double* c, Index c_stride) {
  using Eigen::internal::pload1;
  using Eigen::internal::ploadu;
  using Eigen::internal::pmul;
  using Eigen::internal::pstoreu;
  using Eigen::internal::psub;
  Packet sums[3][3];
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) sums[j][i] = ploadu<Packet>(c + j * c_stride + 2 * i);
  }
  for (Index p = 0; p < depth; ++p, a += stride, b += stride) {
    const Packet rows[3] = {ploadu<Packet>(a), ploadu<Packet>(a + 2), ploadu<Packet>(a + 4)};
    for (int j = 0; j < 3; ++j) {
      const Packet factor = pload1<Packet>(b + j);
      for (int i = 0; i < 3; ++i) sums[j][i] = psub(sums[j][i], pmul(rows[i], factor));
    }
  }
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) pstoreu(c + j * c_stride + 2 * i, sums[j][i]);
  }
}

/// C (3 × 3) −= A (3 × depth) · B (3 × depth)ᵀ.
inline void subtract_product_3x3(const double* a, const double* b, Index stride, Index depth,
                                 double* c, Index c_stride) {
  double sums[3][3];
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) sums[j][i] = c[j * c_stride + i];
  }
  for (Index p = 0; p < depth; ++p, a += stride, b += stride) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) sums[j][i] -= a[i] * b[j];
    }
  }
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) c[j * c_stride + i] = sums[j][i];
  }
}

#if defined(__x86_64__) && defined(__GNUC__)

inline bool has_wide_registers() { return __builtin_cpu_supports("avx2") != 0; }

/// C (12 × 3) −= A (12 × depth) · B (3 × depth)ᵀ, as often as `rows` allows, in registers of four
/// numbers. Every entry has a sum of its own in one order, without fused operations: the bits are
/// those of the narrower kernels.
/// @returns how many rows are done
__attribute__((target("avx2"))) Index subtract_product_12x3(const double* a, const double* b,
                                                            Index stride, Index depth, Index rows,
                                                            double* c, Index c_stride) {
  using Wide = double __attribute__((vector_size(32)));
  struct __attribute__((packed, may_alias)) Unaligned {
    Wide numbers;
  };
  constexpr Index kHeight = 12;
  Index done = 0;
  for (; done + kHeight <= rows; done += kHeight, a += kHeight, c += kHeight) {
    Wide sums[3][3];
    for (int j = 0; j < 3; ++j) {
      const auto* const column = reinterpret_cast<const Unaligned*>(c + j * c_stride);
      for (int i = 0; i < 3; ++i) sums[j][i] = column[i].numbers;
    }
    for (Index p = 0; p < depth; ++p) {
      const auto* const column = reinterpret_cast<const Unaligned*>(a + p * stride);
      const Wide parts[3] = {column[0].numbers, column[1].numbers, column[2].numbers};
      for (int j = 0; j < 3; ++j) {
        const double factor = b[p * stride + j];
        for (int i = 0; i < 3; ++i) sums[j][i] -= parts[i] * factor;
      }
    }
    for (int j = 0; j < 3; ++j) {
      auto* const column = reinterpret_cast<Unaligned*>(c + j * c_stride);
      for (int i = 0; i < 3; ++i) column[i].numbers = sums[j][i];
    }
  }
  return done;
}

#else

inline bool has_wide_registers() { return false; }

Index subtract_product_12x3(const double*, const double*, Index, Index, Index, double*, Index) {
  return 0;
}

#endif

/// C (rows × 3) −= A (rows × depth) · B (3 × depth)ᵀ, rows a multiple of 3.
inline void subtract_product(const double* a, const double* b, Index stride, Index depth,
                             Index rows, double* c, Index c_stride) {
  Index i = 0;
  if (has_wide_registers()) i = subtract_product_12x3(a, b, stride, depth, rows, c, c_stride);
  for (; i + 6 <= rows; i += 6) {
    subtract_product_6x3(a + i, b, stride, depth, c + i, c_stride);
  }
  if (i < rows) subtract_product_3x3(a + i, b, stride, depth, c + i, c_stride);
}

/// Cholesky of a 3 × 3 block in place and x ← x L⁻ᵀ for the `rows` rows below it.
inline bool eliminate_block(double* block, Index rows, Index stride) {
  double* const c0 = block;
  double* const c1 = block + stride;
  double* const c2 = block + 2 * stride;
  if (!(c0[0] > 0.0)) return false;
  const double l00 = std::sqrt(c0[0]);
  const double l10 = c0[1] / l00;
  const double l20 = c0[2] / l00;
  const double p1 = c1[1] - l10 * l10;
  if (!(p1 > 0.0)) return false;
  const double l11 = std::sqrt(p1);
  const double l21 = (c1[2] - l20 * l10) / l11;
  const double p2 = c2[2] - l20 * l20 - l21 * l21;
  if (!(p2 > 0.0)) return false;
  const double l22 = std::sqrt(p2);
  c0[0] = l00;
  c0[1] = l10;
  c0[2] = l20;
  c1[1] = l11;
  c1[2] = l21;
  c2[2] = l22;
  const double r0 = 1.0 / l00;
  const double r1 = 1.0 / l11;
  const double r2 = 1.0 / l22;
  for (Index i = 3; i < 3 + rows; ++i) {
    const double x0 = c0[i] * r0;
    const double x1 = (c1[i] - x0 * l10) * r1;
    c0[i] = x0;
    c1[i] = x1;
    c2[i] = (c2[i] - x0 * l20 - x1 * l21) * r2;
  }
  return true;
}

}  // namespace

bool eliminate_panel(double* panel, std::ptrdiff_t height, std::ptrdiff_t pivot) {
  for (Index j = 0; j < pivot; j += 3) {
    double* const corner = panel + j + j * height;
    subtract_product(panel + j, panel + j, height, j, height - j, corner, height);
    if (!eliminate_block(corner, height - j - 3, height)) return false;
  }
  return true;
}

void update_front(const double* panel, std::ptrdiff_t height, std::ptrdiff_t pivot,
                  double* update) {
  const Index side = height - pivot;
  const double* const below = panel + pivot;
  for (Index j = 0; j < side; j += 3) {
    subtract_product(below + j, below + j, height, pivot, side - j, update + j + j * side, side);
  }
}

}  // namespace planish
