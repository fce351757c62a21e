// SPDX-License-Identifier: MIT
/// The JSON report of docs/architecture.md.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "planish/variations/subspace.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] Json mesh_json(const Mesh& mesh);
[[nodiscard]] Json planarity_json(const Mesh& mesh, const Positions& before,
                                  const Positions& after);
/// Panels that are flat but spoilt since `before`, by what became of them; indices from 0.
[[nodiscard]] Json damage_json(const Mesh& mesh, const Positions& before, const Positions& after);

/// The sharpest folds, in degrees, of the faces of `base` that `after` touches: here and there.
[[nodiscard]] Json fold_json(const Mesh& base, const Positions& after);

/// The largest distance of a point of `after` from the surface of `base`, on whichever side, and
/// the longest way along it; model units.
[[nodiscard]] Json motion_json(const Mesh& base, const Positions& after);

/// How many panels of `base` the shop makes again for `after`: cut (`outline`) or only joined at
/// another angle (`bevel`); and how many nodes, since they moved or only their arms turned.
[[nodiscard]] Json remake_json(const Mesh& base, const Positions& after);

/// Figures of a mesh as `info` reports them.
[[nodiscard]] Json info_json(const MeshFile& file);

/// A support as messages and reports call it: without the points of a model.
[[nodiscard]] std::string support_name(const PointSupport& support);

/// How far the points of each support are off it; nothing where there are none.
void add_supports(Json& json, const std::vector<PointSupport>& supports, const Mesh& base,
                  const Positions& after);

/// Under which symmetry an edit was, and how far `after` is from it, in mean edges.
[[nodiscard]] Json symmetry_json(const MeshSymmetry& symmetry, const Mesh& base,
                                 const Positions& after);

/// The sentences among `sentences` that are not nullopt.
[[nodiscard]] std::vector<std::string> said(
    std::initializer_list<std::optional<std::string>> sentences);

/// What `damage_json` found, "3 concave, 1 crossing", and the sentence with it; nullopt where it
/// found nothing.
[[nodiscard]] std::optional<std::string> damage_words(const Json& damage);
[[nodiscard]] std::optional<std::string> damage_sentence(const Json& damage);

/// The sentence where `fold_json` has a fold that is much sharper than before; nullopt else.
[[nodiscard]] std::optional<std::string> fold_sentence(const Json& fold);

/// The sentence where a solve stopped short of a target or has no certificate; nullopt where all is
/// well.
[[nodiscard]] std::optional<std::string> outcome_sentence(const SolveReport& report);

[[nodiscard]] Json subspace_json(const SubspaceReport& report, int dimension);

/// How far a mesh is from each kind that is kept, before and after.
[[nodiscard]] Json violations_json(const std::vector<KindViolation>& violations);

[[nodiscard]] Json optimality_json(const Optimality& optimality);

/// Status, objective, counts and times of a solve.
void add_solve(Json& json, const SolveReport& report, Engine engine);

}  // namespace planish::workflow
