// SPDX-License-Identifier: MIT
#include "planish/constraints/mesh_limits.hpp"

#include <utility>

#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Which rows hang on a face, from which faces hang on a row.
RaggedRows rows_by_face(int face_count, const std::vector<std::pair<int, int>>& uses) {
  RaggedRows rows;
  rows.offsets.assign(at(face_count) + 1, 0);
  for (const auto& [face, row] : uses) ++rows.offsets[at(face) + 1];
  for (std::size_t f = 1; f < rows.offsets.size(); ++f) rows.offsets[f] += rows.offsets[f - 1];
  std::vector<int> next(rows.offsets.begin(), rows.offsets.end() - 1);
  rows.values.resize(uses.size());
  for (const auto& [face, row] : uses) rows.values[at(next[at(face)]++)] = row;
  return rows;
}

}  // namespace

MeshLimits::MeshLimits(const LimitBase& base, const std::vector<StatedLimit>& limits) {
  const int faces = base.mesh.face_count();
  LimitKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    auto& rows = rows_.of<Kind>();
    std::vector<std::pair<int, int>> uses;
    for (const StatedLimit& limit : limits) {
      if (limit.name != Kind::kName) continue;
      for (int f = 0; f < faces; ++f) {
        std::size_t row = rows.size();
        Kind::append_rows(base, f, limit, rows);
        for (; row < rows.size(); ++row) {
          uses.emplace_back(f, static_cast<int>(row));
          const int other = other_panel(rows[row], f);
          if (other >= 0) uses.emplace_back(other, static_cast<int>(row));
        }
      }
    }
    if (!rows.empty()) rows_of_[LimitKinds::index_of<Kind>()] = rows_by_face(faces, uses);
  });
}

std::vector<LimitExcess> limit_excess(const MeshLimits& limits, int face_count) {
  std::array<LimitExcess, LimitKinds::kCount> kinds;
  for (int face = 0; face < face_count; ++face) {
    limits.for_each_row(face, [&](auto tag, const auto& row, int, int) {
      using Kind = typename decltype(tag)::type;
      LimitExcess& kind = kinds[LimitKinds::index_of<Kind>()];
      kind.name = Kind::kName;
      const bool listed = !kind.panels.empty() && kind.panels.back() == face;
      if (row.scale.exceeded && !listed) kind.panels.push_back(face);
    });
  }
  std::vector<LimitExcess> excess;
  for (LimitExcess& kind : kinds) {
    if (!kind.panels.empty()) excess.push_back(std::move(kind));
  }
  return excess;
}

std::vector<LimitStanding> limit_standing(const MeshLimits& limits, std::span<const int> faces,
                                          const std::function<Eigen::Vector3d(int)>& point) {
  std::array<LimitStanding, LimitKinds::kCount> kinds;
  for (const int face : faces) {
    limits.for_each_row(face, [&](auto tag, const auto& row, int, int) {
      using Kind = typename decltype(tag)::type;
      const double share = row.scale.share(value(row, placed_points(row, point)));
      LimitStanding& kind = kinds[LimitKinds::index_of<Kind>()];
      // Not a number is no share that holds.
      if (!(share >= kind.least_share)) kind.least_share = share;
      const bool listed = !kind.binding.empty() && kind.binding.back() == face;
      if (!(share >= kBindingShare) && !listed) kind.binding.push_back(face);
    });
  }
  std::vector<LimitStanding> standing;
  LimitKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    const std::size_t index = LimitKinds::index_of<Kind>();
    if (!limits.has(index)) return;
    kinds[index].name = Kind::kName;
    standing.push_back(std::move(kinds[index]));
  });
  if (const MeshKeepOuts* const keep_outs = limits.keep_outs()) {
    standing.push_back(keep_outs->standing(faces, point));
  }
  return standing;
}

}  // namespace planish
