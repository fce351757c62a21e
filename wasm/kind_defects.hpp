// SPDX-License-Identifier: MIT
/// How far each panel or node of a mesh is from a kind of constraint.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "planish/constraints/elements.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Violations, one for each face or vertex of `mesh` at `positions`, 3 × n; nullopt where nothing
/// called `name` has rows: at triangles, and at vertices that are not inside.
inline std::vector<std::optional<Violation>> kind_defects(std::string_view name, const Mesh& mesh,
                                                          const Adjacency& adjacency,
                                                          const Positions& positions) {
  MeshElements elements(mesh, adjacency);
  std::vector<std::optional<Violation>> defects;
  ConstraintKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName != name) return;
    std::vector<typename Kind::Row> rows;
    defects.resize(static_cast<std::size_t>(elements.count(Kind::kElement)));
    for (int e = 0; e < elements.count(Kind::kElement); ++e) {
      const auto element = elements.of(Kind::kElement, e);
      rows.clear();
      Kind::append_rows(mesh.positions, element, rows);
      if (rows.empty()) continue;
      defects[static_cast<std::size_t>(e)] = violation_of<Kind>(positions, element);
    }
  });
  return defects;
}

}  // namespace planish
