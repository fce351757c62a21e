// SPDX-License-Identifier: MIT
/// How an edit changes the number of types of panels, where that is asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

/// When panels count as one type.
struct TypeCounting {
  double within = 0.0;    ///< how far a corner may be from the template's
  bool is_share = false;  ///< of the mean edge; else units of the mesh
  bool mirrored = false;  ///< a panel may be its template turned over
};

/// --count-types and --mirrored.
[[nodiscard]] std::vector<OptionRow> type_counting_rows();

/// What they ask for; nullopt without. Throws UsageError.
[[nodiscard]] std::optional<TypeCounting> type_counting(const Request& request);

/// "panels", "within" (units of the mesh), "mirrored", "before" and "after".
/// @param after 3 × n, of `mesh`
[[nodiscard]] Json type_change_json(const TypeCounting& counting, const Mesh& mesh,
                                    const Positions& after);

/// "panels are of 61 types, 12 before: alike within 0.0075 (units of the mesh)".
[[nodiscard]] std::string type_change_sentence(const Json& change);

}  // namespace planish::workflow
