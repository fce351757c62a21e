// SPDX-License-Identifier: MIT
/// What `edit`, `explore` and `project` have in common: options, targets, a flat base.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.hpp"
#include "files.hpp"
#include "planish/design.hpp"
#include "planish/handle_edit.hpp"
#include "planish/mesh.hpp"
#include "planish/planarising.hpp"
#include "planish/projection.hpp"
#include "planish/symmetric_edit.hpp"
#include "report.hpp"

namespace planish::cli {

/// Rows of the option table for handles, pins, weights, fairness and solver.
[[nodiscard]] std::vector<OptionRow> edit_option_rows();

/// The same and what `edit` alone knows: --symmetry.
[[nodiscard]] std::vector<OptionRow> edit_command_rows();

[[nodiscard]] HandleEditOptions edit_options(const Arguments& arguments);

/// Of the coordinates, m unless --model-unit says otherwise. Throws CommandError for another word.
[[nodiscard]] std::string model_unit(const Arguments& arguments);

/// Handles and pins; "V+=" counts from the positions of `base`. Throws CommandError.
[[nodiscard]] EditTargets edit_targets(const Arguments& arguments, const Mesh& base);

/// Beside planarity, with its own tolerance where none is given: "circular" or "circular:1e-6".
/// @param planar mm/m; set by "planar:TOL"
[[nodiscard]] std::vector<KeptConstraint> parse_constraints(const Arguments& arguments,
                                                            double& planar);

inline constexpr OptionRow kConstraintRow = {
    "--constraint", "KIND[:TOL]",
    "beside planar, which is always on: circular (opposite angles of a panel\n"
    "add up to 180°) or conical (ω1 + ω3 = ω2 + ω4 around a point), to TOL\n"
    "degrees, default 1e-9; repeatable"};

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

/// A mesh whose panels are flat to the tolerance.
struct FlatBase {
  Mesh mesh;
  Planarising how;                             ///< if it was not
  std::optional<ProjectionResult> planarised;  ///< set if the file's mesh was not flat
};

/// `mesh` itself if it is flat to the tolerance, else a fair flat mesh near it, or the nearest one
/// where panels could not keep their shape in a fair one; whatever the edit's engine: a base is the
/// same for every edit of it.
[[nodiscard]] FlatBase flat_base(const Mesh& mesh, const HandleEditOptions& options,
                                 const Progress& progress);

/// An edit with everything that the commands report about it.
struct EditRun {
  std::string unit;  ///< of the model
  Mesh given;        ///< as in the file
  DesignSource source;
  FlatBase base;
  EditTargets targets;                   ///< without images
  std::optional<MeshSymmetry> symmetry;  ///< set where --symmetry asks for one; auto may find none
  SymmetricBase evened;                  ///< how the base became symmetric
  Positions edited;                      ///< 3 × n
  SolveReport report;
};

/// Planarises if needed, and edits. A stop that `progress` asks for gives kCancelled and a valid
/// design: before the edit, the mesh as given. Throws CommandError for wrong options or targets.
/// @param name of the mesh, for messages
[[nodiscard]] EditRun run_edit(const Arguments& arguments, const HandleEditOptions& options,
                               LoadedSource source, const std::string& name,
                               const Progress& progress);

/// The same for the only positional word, telling standard error.
[[nodiscard]] EditRun run_edit_solver(const Arguments& arguments, const HandleEditOptions& options);

/// Who edits a mesh that is not flat should know that more of it moved than the edit; nullopt if
/// the mesh was flat.
[[nodiscard]] std::optional<std::string> planarised_sentence(const FlatBase& base);

/// Nor need it be symmetric; nullopt where it was.
[[nodiscard]] std::optional<std::string> evened_sentence(const EditRun& run);

/// Everything of the report that does not depend on the command.
[[nodiscard]] Json edit_json(const EditRun& run, const Positions& after, Engine engine);

}  // namespace planish::cli
