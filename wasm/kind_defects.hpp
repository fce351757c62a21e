// SPDX-License-Identifier: MIT
/// How far each panel or node of a mesh is from a kind of constraint.
#pragma once

#include <optional>
#include <vector>

#include "planish/adjacency.hpp"
#include "planish/constraints/elements.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/mesh.hpp"

namespace planish {

/// One for each face or vertex of `mesh` at `positions`, 3 × n; nullopt where the kind bounds
/// nothing: at triangles, and at vertices that are not inside or not of valence 4.
template <class Kind>
std::vector<std::optional<Violation>> kind_defects(const Mesh& mesh, const Adjacency& adjacency,
                                                   const Positions& positions) {
  MeshElements elements(mesh, adjacency);
  std::vector<std::optional<Violation>> defects;
  for (int e = 0; e < elements.count(Kind::kElement); ++e) {
    const auto element = elements.of(Kind::kElement, e);
    const bool bounded =
        Kind::kElement == Element::kFace ? element.size() > 3 : element.size() == 5;
    defects.push_back(bounded ? std::optional(violation_of<Kind>(positions, element))
                              : std::nullopt);
  }
  return defects;
}

}  // namespace planish
