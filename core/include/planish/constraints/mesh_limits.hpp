// SPDX-License-Identifier: MIT
/// The limits' rows of a whole mesh, panel by panel. Built once, O(n).
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "planish/constraints/limit_kinds.hpp"
#include "planish/constraints/limit_standing.hpp"
#include "planish/constraints/stated_limit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/obstacles/keep_out.hpp"

namespace planish {

class MeshKeepOuts;

class MeshLimits {
 public:
  /// @param limits that break no rule; of several with one name all hold
  MeshLimits(const LimitBase& base, const std::vector<StatedLimit>& limits);

  /// Keep-outs in place of those that were, if any. @param base outlives choose_planes()
  void keep_out(const LimitBase& base, const FreeSpace& free);
  void keep_out(const LimitBase& base, const std::vector<KeepOut>& keep_outs, double clearance);
  /// Null: there are none.
  [[nodiscard]] MeshKeepOuts* keep_outs() const { return keep_outs_.get(); }

  /// Whether no limit of a kind holds anything back; keep-outs are none.
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  /// Whether a limit of the kind at `index` of LimitKinds holds something back.
  [[nodiscard]] bool has(std::size_t index) const { return rows_of_[index].size() > 0; }

  /// Calls visit(std::type_identity<Kind>(), row, other, number) for every row that hangs on
  /// `face`; `other` is the second panel of a row that has two, −1 else, and `number` is the row's
  /// among all, kind after kind.
  template <class Visit>
  void for_each_row(int face, const Visit& visit) const {
    int first = 0;
    LimitKinds::for_each([&](auto tag) {
      using Kind = typename decltype(tag)::type;
      const std::vector<typename Kind::Row>& rows = rows_.of<Kind>();
      const RaggedRows& places = rows_of_[LimitKinds::index_of<Kind>()];
      if (places.size() > 0) {
        for (const int place : places[face]) {
          const typename Kind::Row& row = rows[static_cast<std::size_t>(place)];
          visit(tag, row, other_panel(row, face), first + place);
        }
      }
      first += static_cast<int>(rows.size());
    });
  }

 private:
  template <LimitRow Row>
  [[nodiscard]] static int other_panel(const Row& row, int face) {
    if constexpr (requires { row.panels; }) {
      return row.panels[0] == face ? row.panels[1] : row.panels[0];
    } else {
      return -1;
    }
  }

  LimitRows rows_;
  std::array<RaggedRows, LimitKinds::kCount> rows_of_;  ///< by face; empty: nothing is stated
  /// Null: there are none. Shared, so that only who makes them needs to know how they end.
  std::shared_ptr<MeshKeepOuts> keep_outs_;
};

/// The points of a row. @param point a vertex's place, in the unit that the row was made in
template <LimitRow Row, class Point>
[[nodiscard]] RowPoints<Row::kArity> placed_points(const Row& row, const Point& point) {
  RowPoints<Row::kArity> points(3, static_cast<Eigen::Index>(row.vertices.size()));
  for (std::size_t k = 0; k < row.vertices.size(); ++k) {
    points.col(static_cast<Eigen::Index>(k)) = point(row.vertices[k]);
  }
  return points;
}

/// Panels that break a limit before anything moves; there it holds what they have.
struct LimitExcess {
  std::string_view name;    ///< of the limit
  std::vector<int> panels;  ///< ascending
};

/// The excess of every limit that some panel breaks, in the order of LimitKinds.
[[nodiscard]] std::vector<LimitExcess> limit_excess(const MeshLimits& limits, int face_count);

/// The share below which a limit counts as holding something back: what presses ends a millionth
/// from its bound, see kLimitMargin.
inline constexpr double kBindingShare = 1e-4;

/// The standing of every limit that rows hang on, in the order of LimitKinds, keep-outs last; of
/// `faces` (ascending). @param point a vertex's place, in the unit that the limits were made in
[[nodiscard]] std::vector<LimitStanding> limit_standing(
    const MeshLimits& limits, std::span<const int> faces,
    const std::function<Eigen::Vector3d(int)>& point);

}  // namespace planish
