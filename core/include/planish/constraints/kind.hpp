// SPDX-License-Identifier: MIT
/// What a kind of constraint is: equations ("rows") that hang on the elements of a mesh, each a
/// smooth function of a few vertices with closed derivatives. Engines see rows, never kinds.
/// How to add one: docs/extending.md. [CON-1]
#pragma once

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// What the rows of a kind hang on.
enum class Element {
  kFace,    ///< the vertices of a face, in order
  kEdge,    ///< the two ends of an edge
  kVertex,  ///< a vertex, then its neighbours in order around it
  kSet,     ///< any vertices, as whoever asks for the constraint lists them
};

/// What a row says of its residual.
enum class Sense { kZero, kAtLeastZero };

/// The vertices of a row, one a column.
template <int Arity>
using RowPoints = Eigen::Matrix<double, 3, Arity>;

/// Second derivatives of a row by its vertices k and l: 3 × 3 blocks for k > l, row by row, that
/// is (1,0) (2,0) (2,1) (3,0) …; with `Diagonal` for k = l too: (0,0) (1,0) (1,1) (2,0) …
/// The (l, k) block is the transpose of (k, l).
template <int Arity, bool Diagonal>
using CurvatureBlocks =
    std::array<Eigen::Matrix3d,
               static_cast<std::size_t>(Arity*(Diagonal ? Arity + 1 : Arity - 1) / 2)>;

/// Where the block (k, l), k ≥ l, of a row stands in its CurvatureBlocks.
template <class Row>
constexpr std::size_t block_index(int k, int l) {
  const auto row = static_cast<std::size_t>(k);
  const std::size_t first = (Row::kCurvedDiagonal ? row * (row + 1) : row * (row - 1)) / 2;
  return first + static_cast<std::size_t>(l);
}

/// One equation on `kArity` vertices (or fewer: a vertex may stand twice, if nothing is read at its
/// later places): data that was made once for the base mesh, and three pure
/// functions, found by argument-dependent lookup. The residual is a length, in the unit of the
/// positions. Where it is zero, the gradient is its derivative and the Hessian, along directions
/// that keep it, the gradient's; elsewhere they may leave out multiples of the residual.
template <class Row>
concept ConstraintRow = requires(const Row& row, const RowPoints<Row::kArity>& points) {
  requires std::same_as<std::remove_cvref_t<decltype(row.vertices)>, std::array<int, Row::kArity>>;
  { residual(row, points) } -> std::same_as<double>;
  { gradient(row, points) } -> std::same_as<RowPoints<Row::kArity>>;
  { hessian(row, points) } -> std::same_as<CurvatureBlocks<Row::kArity, Row::kCurvedDiagonal>>;
};

/// A kind: its rows, and what a report says of it.
template <class Kind>
concept ConstraintKind = ConstraintRow<typename Kind::Row> &&
    requires(const Positions& positions, std::span<const int> element,
             std::vector<typename Kind::Row>& out) {
  { Kind::kName } -> std::convertible_to<std::string_view>;  ///< on the command line
  { Kind::kUnit } -> std::convertible_to<std::string_view>;  ///< of measure()
  { Kind::kTolerance } -> std::convertible_to<double>;       ///< default bound of measure()
  { Kind::kElement } -> std::convertible_to<Element>;
  { Kind::kSense } -> std::convertible_to<Sense>;
  /// The rows of one element, scaled on `positions`; none where it cannot be broken.
  Kind::append_rows(positions, element, out);
  /// How far one element is from keeping the constraint, ≥ 0; what people are told.
  { Kind::measure(positions, element) } -> std::same_as<double>;
};

}  // namespace planish
