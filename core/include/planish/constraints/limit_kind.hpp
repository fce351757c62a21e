// SPDX-License-Identifier: MIT
/// What a kind of limit is: rows that hang on panels, each a smooth function of a few vertices that
/// must stay on one side of a bound. How to add one: docs/extending.md. [LIM-1]
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <span>
#include <string_view>
#include <vector>

#include "planish/constraints/kind.hpp"
#include "planish/constraints/limit_scale.hpp"
#include "planish/constraints/stated_limit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// The second derivatives of a limit's row: 3 × 3 blocks, vertex by vertex.
template <int Arity>
using LimitHessian = Eigen::Matrix<double, Arity == Eigen::Dynamic ? Eigen::Dynamic : 3 * Arity,
                                   Arity == Eigen::Dynamic ? Eigen::Dynamic : 3 * Arity>;

/// Data made once on the base mesh, and three pure functions of the points: g and its derivatives,
/// exact everywhere. `kArity` may be Eigen::Dynamic: then `vertices` is a list. No vertex twice.
template <class Row>
concept LimitRow = requires(const Row& row, const RowPoints<Row::kArity>& points) {
  { row.scale } -> std::convertible_to<LimitScale>;
  { row.vertices.size() } -> std::convertible_to<std::size_t>;
  { value(row, points) } -> std::same_as<double>;
  { gradient(row, points) } -> std::same_as<RowPoints<Row::kArity>>;
  { hessian(row, points) } -> std::same_as<LimitHessian<Row::kArity>>;
};

/// Where limits are stated: the base mesh, in any unit of length.
struct LimitBase {
  const Mesh& mesh;
  const Adjacency& adjacency;
  const Positions& points;  ///< 3 × n
  double unit = 1.0;        ///< model units per unit of `points`
};

/// A kind: its name and the rows of one panel.
template <class Kind>
concept LimitKind = LimitRow<typename Kind::Row> &&
    requires(const LimitBase& base, int face, const StatedLimit& limit,
             std::vector<typename Kind::Row>& out) {
  { Kind::kName } -> std::convertible_to<std::string_view>;  ///< on the command line
  { Kind::kForm } -> std::convertible_to<std::string_view>;  ///< of its value, for people
  /// The rows of `face`. A row of two panels is made for the lower one and names both.
  Kind::append_rows(base, face, limit, out);
};

}  // namespace planish
