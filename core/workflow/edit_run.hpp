// SPDX-License-Identifier: MIT
/// An edit, run: a flat and, where asked, symmetric base; the edit; its
/// report.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "edit_request.hpp"
#include "mesh_files.hpp"
#include "planish/design/design.hpp"
#include "planish/design/design_steps.hpp"
#include "planish/edit/fewest.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/edit/symmetric_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/projection/planarising.hpp"
#include "planish/projection/projection.hpp"
#include "report.hpp"
#include "request.hpp"
#include "split_run.hpp"

namespace planish::workflow {

/// A mesh whose panels are flat to the tolerance.
struct FlatBase {
  Mesh mesh;
  Planarising how;                             ///< if it was not
  std::optional<ProjectionResult> planarised;  ///< set if the file's mesh was not flat

  /// What edits ask for; else it could not be had.
  [[nodiscard]] bool is_flat() const { return !planarised || planarised->report.usable(); }
};

/// `mesh` itself if it is flat to the tolerance, else a fair flat mesh near it, or the nearest one
/// where panels could not keep their shape in a fair one; whatever the edit's engine: a base is the
/// same for every edit of it.
[[nodiscard]] FlatBase flat_base(const Mesh& mesh, const HandleEditOptions& options,
                                 const Progress& progress);

/// An edit with everything that the commands report about it.
struct EditRun {
  /// The request: its options with the limits that --fewest or --fair adds to those that were
  /// given, its cuts with those that --split-where-needed adds.
  EditRequest asked;
  Mesh given;  ///< as in the file; where there are cuts: parted as they part the flat mesh
  DesignSource source;
  FlatBase base;                            ///< after the cuts
  std::optional<CutMesh> cut;               ///< what they made; absent without any
  std::optional<std::uint32_t> uncut_hash;  ///< mesh_hash() of the base before them
  EditTargets targets;                      ///< without images, as asked for
  std::vector<PointSupport> supports;       ///< of `targets`, with the points that the cuts added
  std::optional<MeshSymmetry> symmetry;  ///< set where --symmetry asks for one; auto may find none
  SymmetricBase evened;                  ///< how the base became symmetric
  std::optional<FewestEdit> fewest;      ///< its result apart; targets.pins has what it holds
  std::optional<SplitRun> splits;  ///< where panels are parted for the handles; asked.cuts has them
  std::optional<std::vector<StatedLimit>> fair;  ///< what --fair found; asked.options has it
  Positions edited;                              ///< 3 × n
  SolveReport report;
};

/// The steps of `run`, which outlives them: of its base after the cuts, whose symmetry counts where
/// it has more than the identity. Throws UsageError where its targets have no images.
[[nodiscard]] DesignSteps steps_of(const EditRun& run);

/// Planarises if needed, and edits. A stop that `progress` asks for gives kCancelled and a valid
/// design: before the edit, the mesh as given. Throws RequestError for wrong options or targets.
/// @param name of the mesh, for messages
[[nodiscard]] EditRun run_edit(EditRequest asked, LoadedSource source, const std::string& name,
                               const Progress& progress);

/// Everything of the report that does not depend on the command.
[[nodiscard]] Json edit_json(const EditRun& run, const Positions& after);

}  // namespace planish::workflow
