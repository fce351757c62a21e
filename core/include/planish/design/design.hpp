// SPDX-License-Identifier: MIT
/// A design is a base mesh and what was done to it: data that a link, a file or a test stores, and
/// that gives the same shape again wherever it is replayed.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/design/design_steps.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/io/gltf.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/mesh/mesh_hash.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/projection/planarising.hpp"
#include "planish/projection/projection.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "planish/text/refusal.hpp"
#include "planish/variations/subspace.hpp"

namespace planish {

/// A base mesh that make_sample() makes.
struct SampleSource {
  std::string name;
  int size = 0;
};

/// A base mesh from a file: its bytes ride along, or whoever replays brings the mesh.
struct FileSource {
  std::string name;  ///< for people, for example "roof.obj"
  /// mesh_hash() of the base that was edited, after planarising; absent: not known.
  std::optional<std::uint32_t> hash;
  std::string format;  ///< "obj", "off", "ply" or "glb"; "" without bytes
  std::string bytes;   ///< the file; "" if it does not ride along
};

using DesignSource = std::variant<SampleSource, FileSource>;

/// One look around: a family of variations, the place chosen in it, and whether that was made
/// exact. The next one starts from there.
struct DesignVariation {
  SubspaceOptions options;           ///< fairness and engine are those of the edit
  std::vector<double> coefficients;  ///< slider values, at most options.dimension
  bool exact = true;                 ///< projected afterwards
  double exact_fairness = 0.0;       ///< α_f ≥ 0 of that projection [PRO-1]
  std::vector<int> close = {};       ///< Ψ of (4), vertices; empty: the handles
};

/// Where a vertex went, to 12 digits.
struct DesignProbe {
  int vertex = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< model units
};

/// Enough of a result to recognise it, or to say how far another one is from it.
struct DesignMark {
  std::uint32_t hash =
      0;          ///< CRC-32 of the moved indices (int32), then their coordinates (float64)
  int moved = 0;  ///< vertices
  std::vector<DesignProbe> probes;  ///< a few of them
};

/// Source, recipe, and the mark of what the recipe gave.
struct Design {
  std::string title;
  DesignSource source;
  std::optional<Planarising> planarised;  ///< how the source became the flat base; absent: it was
  std::string unit = "m";                 ///< of the model: mm, cm, m, km, in or ft
  /// Made on the flat, and symmetric, base before the edit, whose base is what they leave.
  std::vector<Cut> cuts = {};
  EditTargets targets;
  /// Under which the targets have images, and the base is made symmetric; empty: none.
  std::vector<SymmetryElement> symmetry = {};
  HandleEditOptions options;
  std::vector<DesignVariation> variations;  ///< one after the other
  std::optional<DesignMark> result;         ///< absent: nothing to verify against
};

/// The first rule that `design` breaks whatever its mesh is, naming the field; nullopt if none.
[[nodiscard]] Refusal find_problem(const Design& design);

/// @param shape 3 × n, the positions that the design gave
[[nodiscard]] DesignMark mark_of(const Mesh& base, const Positions& shape);
/// The mark of a shape of which only the moved vertices are at hand.
[[nodiscard]] DesignMark mark_of(const SparseShape& shape);

/// Largest distance of a probe from `shape`, model units; 0 only if `shape` is the recorded result
/// to the last bit.
[[nodiscard]] double deviation(const DesignMark& mark, const Mesh& base, const Positions& shape);

/// The largest deviation between results that are the same, model units: a billionth of the mesh's
/// diagonal. Compilers round in another order; certified results agree far below it, and nobody
/// sees it.
[[nodiscard]] double agreement(const Mesh& base);

/// What each slider does at value 1, for a GLB's morph targets: in slider order and scale.
[[nodiscard]] GlbVariations variations_of(const Subspace& subspace);

struct Replay {
  Mesh base;                   ///< what was edited: flat, planarised and cut if the design says so
  Positions shape;             ///< 3 × n, model units
  std::optional<CutMesh> cut;  ///< what the cuts made of the flat mesh; absent: none
  std::vector<PointSupport> supports;     ///< the design's, with the points that cuts added on them
  std::optional<MeshSymmetry> symmetry;   ///< of the base, where the design has one
  SolveReport report;                     ///< of the edit, or of the projection that failed
  std::vector<int> directions;            ///< that each variation found, up to one that found none
  std::optional<VariationFamily> family;  ///< that the last variation is of
  std::optional<SolveReport> exact;       ///< of the projection that made it exact
  DesignMark mark;                        ///< of `shape`
  bool verified = false;                  ///< `shape` is the recorded result, bit for bit
  bool agrees = false;                    ///< so are its probes, up to rounding: see agreement()
  double deviation = 0.0;                 ///< from the recorded probes, model units
};

/// Does `design` again, for everybody: page, packages and command.
/// @param given the mesh of a FileSource that does not ride along; otherwise not used
/// @return the result, or one sentence that says why there is none
[[nodiscard]] std::variant<Replay, std::string> replay(const Design& design,
                                                       const Mesh* given = nullptr,
                                                       const Progress& progress = {});

/// What the cuts of `design` made of its flat mesh, where a file holds what they left: nothing is
/// made flat anew. One sentence where the design's mesh cannot be had, or has more points.
/// @param base of the edit, as it was stored: 3 × n, model units
[[nodiscard]] std::variant<CutMesh, std::string> cuts_that_left(const Positions& base,
                                                                const Design& design);

/// Does `design` again on a base that was opened, made flat, symmetric and cut, already, with
/// supports that have the points of the cuts (supports_after_cuts()) and are not told in the
/// result.
/// @param symmetry of that base, which is the design's; null: none, and designs with one are
/// refused
[[nodiscard]] std::variant<Replay, std::string> replay_on(
    Mesh base, std::shared_ptr<const MeshSymmetry> symmetry, const Design& design,
    const Progress& progress = {});

}  // namespace planish
