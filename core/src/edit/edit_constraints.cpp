// SPDX-License-Identifier: MIT
#include "planish/constraints/elements.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/text/number.hpp"

namespace planish {

KeptKinds kept_kinds(const HandleEditOptions& options) {
  if (!options.keep_bends) return kept_kinds(options.tolerance, options.constraints);
  KeptKinds kept = kept_kinds(PlanarPolygon::kTolerance, options.constraints);
  kept.keep_bends();
  return kept;
}

Refusal find_broken_constraint(const Mesh& mesh, const HandleEditOptions& options) {
  const KeptKinds kept = kept_kinds(options);
  if (options.constraints.empty()) return std::nullopt;
  Refusal broken;
  const Adjacency adjacency = build_adjacency(mesh);
  MeshElements elements(mesh, adjacency);
  kept.for_each([&](auto tag, std::size_t kind) {
    using Kind = typename decltype(tag)::type;
    if (broken || kind == ConstraintKinds::index_of<PlanarPolygon>()) return;
    Violation worst;
    int where = 0;
    for (int e = 0; e < elements.count(Kind::kElement); ++e) {
      const Violation here = violation_of<Kind>(mesh.positions, elements.of(Kind::kElement, e));
      if (here.excess <= worst.excess) continue;
      worst = here;
      where = e;
    }
    if (worst.excess <= kept.tolerance(kind)) return;
    const std::string where_word = Kind::kElement == Element::kFace ? "panel " : "point ";
    broken = "the base mesh is not " + std::string(Kind::kName) + ": " + where_word +
             std::to_string(where) + " misses it by " + three_digits(worst.measure) + " " +
             std::string(Kind::kUnit);
  });
  return broken;
}

}  // namespace planish
