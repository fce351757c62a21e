// SPDX-License-Identifier: MIT
/// Results as programs hold them: each knows its report, its messages and its bytes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "design_input.hpp"
#include "edit_run.hpp"
#include "exploration.hpp"
#include "mobility_run.hpp"
#include "open_mesh.hpp"
#include "planish/design/design.hpp"
#include "planish/fabrication/cutting_plan.hpp"
#include "planish/offset/mesh_offset.hpp"
#include "planish/projection/projection.hpp"

namespace planish::library {

/// What every result of an operation offers.
struct Shape {
  Mesh base;                          ///< what it was made from
  Positions positions;                ///< 3 × n
  std::string report;                 ///< JSON, as the command writes it
  std::vector<std::string> messages;  ///< sentences that the command says on standard error
};

/// An edit, kept for its variations.
struct Edit {
  std::shared_ptr<const OpenMesh> given;
  EditRun run;
};

/// The variations of an edit.
struct EditFamily {
  std::shared_ptr<const Edit> edit;
  workflow::Family family;
};

/// One of them.
struct EditVariation {
  std::shared_ptr<const EditFamily> of;
  Variation variation;
};

[[nodiscard]] Edit make_edit(std::shared_ptr<const OpenMesh> mesh, const std::string& asked,
                             const Progress& progress);
[[nodiscard]] Shape shape_of(const Edit& edit);
[[nodiscard]] Design design_of(const Edit& edit);
/// The design where `name` ends in .json; otherwise the mesh in the format of its extension, a GLB
/// with base, design and variations. So for all that have it.
[[nodiscard]] std::string bytes_of(const Edit& edit, const std::string& name);

[[nodiscard]] EditFamily make_family(std::shared_ptr<const Edit> edit, const std::string& asked,
                                     const Progress& progress);
/// @param asked for: coefficients
[[nodiscard]] EditVariation make_variation(std::shared_ptr<const EditFamily> family,
                                           const std::string& asked);
[[nodiscard]] EditVariation make_exact(const EditVariation& variation, const Progress& progress);
[[nodiscard]] Shape shape_of(const EditVariation& variation);
[[nodiscard]] Design design_of(const EditVariation& variation);
[[nodiscard]] std::string bytes_of(const EditVariation& variation, const std::string& name);

[[nodiscard]] Shape make_projection(const OpenMesh& mesh, const std::string& asked,
                                    const OpenMesh* reference, const Progress& progress);
[[nodiscard]] std::string bytes_of(const Shape& shape, const std::string& name);

[[nodiscard]] Shape make_offset(const OpenMesh& mesh, const std::string& asked);

/// Ready to measure where `mesh` can move. @param asked the options of `planish mobility`
[[nodiscard]] MobilityRun make_mobility(const OpenMesh& mesh, const std::string& asked);

/// What of a mesh is alike.
struct MeshTypes {
  CuttingPlan plan;  ///< with types
  std::string report;
  std::vector<std::string> messages;
};

/// @param asked the options of `planish types`
[[nodiscard]] MeshTypes make_types(const OpenMesh& mesh, const std::string& asked);
/// @param name must end in .csv
[[nodiscard]] std::string bytes_of(const MeshTypes& types, const std::string& name);

/// A design done again.
struct Replayed {
  Design design;  ///< with the mark of this result
  Replay replay;
  Shape shape;
};

[[nodiscard]] OpenedDesign design_of_text(const std::string& text);
[[nodiscard]] Replayed make_replay(const OpenedDesign& opened, const OpenMesh* base,
                                   const Progress& progress);
[[nodiscard]] std::string bytes_of(const Replayed& replayed, const std::string& name);

/// @param name must end in .json
[[nodiscard]] std::string bytes_of(const Design& design, const std::string& name);

/// Rows (name, value, help) that `command` takes: edit, explore, project, offset, mobility,
/// convert or types.
[[nodiscard]] std::vector<OptionRow> option_rows(const std::string& command);

}  // namespace planish::library
