// SPDX-License-Identifier: MIT
/// The options and targets that `edit`, `explore` and `project` have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.hpp"
#include "planish/cuts/cut_mesh.hpp"
#include "planish/design/design.hpp"
#include "planish/edit/fewest.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish::cli {

/// Rows of the option table for handles, pins, weights, fairness and solver.
[[nodiscard]] std::vector<OptionRow> edit_option_rows();

/// The same and what `edit` and `explore` know: --cut and --symmetry.
[[nodiscard]] std::vector<OptionRow> edit_command_rows();

/// What --fewest and --within-handle ask for; nullopt without. Throws CommandError.
[[nodiscard]] std::optional<FewestOptions> fewest_options(const Arguments& arguments);

/// The share that --within-handle asks for, as it was without. Throws CommandError.
void set_within_handle(const Arguments& arguments, double& share);

[[nodiscard]] HandleEditOptions edit_options(const Arguments& arguments);

/// Of the coordinates, m unless --model-unit says otherwise. Throws CommandError for another word.
[[nodiscard]] std::string model_unit(const Arguments& arguments);

/// Handles, pins and supports as they were asked for; "V+=" counts from the positions of `base`.
/// Throws CommandError.
/// @param cut what made `base`: its added points go with the supports that are checked; or null
[[nodiscard]] EditTargets edit_targets(const Arguments& arguments, const Mesh& base,
                                       const CutMesh* cut = nullptr);

/// Beside planarity, with its own tolerance where none is given: "circular" or "circular:1e-6".
/// @param planar mm/m; set by "planar:TOL"
[[nodiscard]] std::vector<KeptConstraint> parse_constraints(const Arguments& arguments,
                                                            double& planar);

inline constexpr OptionRow kConstraintRow = {
    "--constraint", "KIND[:TOL]",
    "beside planar, which is always on: circular (opposite angles of a panel\n"
    "add up to 180°) or conical (ω1 + ω3 = ω2 + ω4 around a point), to TOL\n"
    "degrees, default 1e-9; repeatable"};

/// The row of --support.
[[nodiscard]] OptionRow support_row();

/// What --support asks for, in the order given; rules are find_problem()'s. Throws CommandError for
/// a text that is no support.
[[nodiscard]] std::vector<PointSupport> parse_supports(const Arguments& arguments);

[[nodiscard]] FairnessKind parse_fairness(std::string_view text);
[[nodiscard]] Engine parse_engine(std::string_view text);
/// All of "V,V,...", in every place that the option is given. Throws CommandError.
[[nodiscard]] std::vector<int> parse_vertices(const Arguments& arguments, std::string_view option,
                                              const Mesh& mesh);
[[nodiscard]] std::vector<int> parse_pins(const Arguments& arguments, const Mesh& mesh);

/// What --bound asks for.
struct Bounds {
  bool keep_shape = true;  ///< the last of shape=on|off; on without any
  std::vector<StatedLimit> limits;
  std::optional<double> flat;  ///< mm/m, > 0: flat=H, which project alone knows
};

/// Throws CommandError for a text that is no bound.
[[nodiscard]] Bounds parse_bounds(const Arguments& arguments);

}  // namespace planish::cli
