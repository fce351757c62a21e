// SPDX-License-Identifier: MIT
/// What a cutting package is written from: every panel flat, every edge and node numbered.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planish/fabrication/flat_panel.hpp"
#include "planish/fabrication/inset.hpp"
#include "planish/fabrication/joints.hpp"
#include "planish/fabrication/panel_names.hpp"
#include "planish/fabrication/remake.hpp"
#include "planish/fabrication/structure_types.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// Lengths are in `unit`, which everything in the package is written in.
struct CuttingOptions {
  std::string name = "panels";   ///< for people; what was cut
  std::string model_unit = "m";  ///< of the mesh: mm, cm, m, km, in or ft
  std::string unit = "mm";       ///< of the package: the same words
  double gap = 0.0;              ///< joint between panels, ≥ 0: every edge goes in by half of it
  double thickness = 0.0;        ///< ≥ 0; 0: not known, no volume is given
  double sheet_width = 0.0;      ///< both > 0, or both 0: no sheets
  double sheet_height = 0.0;
  double text_height = 0.0;  ///< ≥ 0, of texts in drawings of panels, less where there is no room;
                             ///< 0: by the size of the panel
  std::optional<TypeOptions> types;  ///< also sorts panels, nodes and edges into types
  bool by_type = false;  ///< cuts one template a type; needs `types`, and a gap in the middle of
                         ///< types->joint where that is given
  bool remake_only = false;  ///< draws what must be made again against a base
  std::vector<int> panels;   ///< draws these faces only; empty: no such limit
  PanelNames names;          ///< of the mesh that is cut
};

/// The first rule that `options` breaks, naming its field; nullopt if none.
/// @param has_base whether there is a mesh to compare with
[[nodiscard]] Refusal find_problem(const CuttingOptions& options, const Mesh& mesh, bool has_base);

/// Metres in one `unit`; nullopt for another word.
[[nodiscard]] std::optional<double> metres_in(const std::string& unit);

struct CuttingPlan {
  CuttingOptions options;
  Mesh mesh;                    ///< positions in options.unit
  std::uint32_t hash = 0;       ///< mesh_hash() of the mesh as given
  std::uint32_t base_hash = 0;  ///< of the base as given; without one, `hash`
  double scale = 1.0;           ///< options.unit in one model unit
  JointTable joints;
  std::vector<FlatPanel> panels;        ///< one a face, in options.unit
  std::vector<int> vertex_of_node;      ///< nodes in the order in which the faces first use them
  std::vector<int> node_of_vertex;      ///< −1 for a vertex without faces
  std::optional<Remake> remake;         ///< against the base, if there is one
  std::optional<StructureTypes> types;  ///< where they are asked for
  std::vector<char> drawn;              ///< 1 for each face that the drawings show
};

/// A panel that a gap cuts into several pieces.
struct PanelApart {
  int face = 0, pieces = 0;
};

/// What came of the panels of a plan; faces by their index.
struct DrawnReport {
  int drawn = 0;              ///< panels that the drawings or the model show
  double flatness = 0.0;      ///< of the worst panel, mm/m
  double excess = 0.0;        ///< `flatness` less what rounding accounts for: see FacePlanarity
  std::vector<int> vanished;  ///< the gap leaves nothing of them, or they cross themselves
  std::vector<PanelApart> apart;
  std::vector<int> lost_sides;  ///< the gap leaves one piece, but not every side of it
};

/// @param mesh must have passed check_mesh(); @param base the same, or nullptr; its panels also say
/// which side x runs along; @param options must have no problem
[[nodiscard]] CuttingPlan make_cutting_plan(const Mesh& mesh, const Mesh* base,
                                            const CuttingOptions& options);

/// Notes in `report` what is left of a face; `pieces`: one at least.
void note_pieces(const CuttingPlan& plan, int face, const std::vector<CutPiece>& pieces,
                 DrawnReport& report);

/// "E-0001" for joint 0; "N-0001" for node 0.
[[nodiscard]] std::string edge_name(int joint);
[[nodiscard]] std::string node_name(int node);

}  // namespace planish
