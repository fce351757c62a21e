// SPDX-License-Identifier: MIT
/// The common form of (3) and (8) that both engines read:
///
///   min  Σ_i [ w_i/2 ‖d_i‖ + q_i/2 ‖d_i − target_i‖² ] + ω_f/2 ‖E d‖²                   [PB-1]
///   s.t. c(p + d) = 0,   d_i = target_i where fixed
///
/// with all lengths in units of the mean edge length of the mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <type_traits>
#include <vector>

#include "planish/constraints/inequality_rows.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/constraints/registry.hpp"
#include "planish/measures/energies.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/supports/vertex_slides.hpp"

namespace planish {

/// What does not change while a mesh is edited, in solver units. Built once, O(n).
class MeshModel {
 public:
  /// @param kept the kinds that have rows
  MeshModel(const Mesh& mesh, FairnessKind fairness, const KeptKinds& kept = KeptKinds());

  [[nodiscard]] int vertex_count() const { return static_cast<int>(points.cols()); }
  /// Solver units → model units, for displacements.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] std::span<const int> face(int f) const;

  Mesh mesh;         ///< as given, model units
  Positions points;  ///< 3 × n, centred, mean edge 1
  Adjacency adjacency;
  FairnessOperator fairness;          ///< rows × n
  FairnessOperator fairness_columns;  ///< its transpose: n × rows
  KeptKinds kept;
  ConstraintRows equations;  ///< of all elements; a kept kind's, element by element
  /// Of each kept kind, n_elements + 1 offsets into its batch of `equations`; of the others none.
  std::array<std::vector<int>, ConstraintKinds::kCount> element_offsets;

  /// Whether rows of a kind that hangs on vertices hang on this one's star.
  [[nodiscard]] bool has_star_rows(int vertex) const;

  /// How far out of flat a panel may stay, mm/m: as far as it is in a mesh whose panels keep their
  /// bends, else 0. [MET-6]
  [[nodiscard]] double bend(int face) const {
    return bends_.empty() ? 0.0 : bends_[static_cast<std::size_t>(face)];
  }
  /// A panel's rows ask for `share` of the bend that they asked for, 0 to 1.
  void ease_bend(int face, double share);
  /// Every panel's rows ask for its own bend again.
  void restore_bends();

  /// What an element with its corners at `positions` misses a kind by: of a panel that keeps its
  /// bend, what it is bent beyond that.
  template <ConstraintKind Kind>
  [[nodiscard]] Violation violation(int element, const Positions& positions,
                                    std::span<const int> vertices) const {
    Violation found = violation_of<Kind>(positions, vertices);
    if constexpr (std::is_same_v<Kind, PlanarPolygon>) {
      const double kept_bend = bend(element);
      found.excess = found.excess <= kept_bend ? 0.0 : found.excess - kept_bend;
    }
    return found;
  }

 private:
  void keep_bends();

  std::vector<double> bends_;      ///< of each face, mm/m; empty: panels become flat
  std::vector<double> bent_rows_;  ///< what each equation of flatness has of that, solver units
  std::vector<int> eased_;         ///< faces whose rows ask for less
  double unit_ = 1.0;
};

/// The part of the objective that belongs to one vertex.
struct VertexTerm {
  double norm_weight = 0.0;                          ///< w ≥ 0
  double square_weight = 0.0;                        ///< q ≥ 0
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< displacement, solver units
  bool fixed = false;   ///< d = target exactly; the weights are then ignored
  bool handle = false;  ///< reported under ObjectiveTerms::handle; always part of the support
};

/// t of [SHP-3] and [LIM-2]: what the barrier costs where a corner has lost half of its size is
/// then far below the price of a moved vertex.
inline constexpr double kShapeWeight = 1e-2;

/// t of the keep-outs' barrier [KEE-1]. A search keeps clear of them by the first, so that its
/// steps are long; a finished edit comes as close as the last lets it.
inline constexpr double kFirstKeepOutWeight = 1e-1, kLastKeepOutWeight = 1e-3;

/// (3) or (8) on a mesh.
struct EditProblem {
  const MeshModel* model = nullptr;
  std::vector<VertexTerm> terms;  ///< n
  std::vector<int> handles;       ///< vertices whose term is a handle's
  double fairness_weight = 0.0;   ///< ω_f ≥ 0
  std::vector<int> region;        ///< ascending: where vertices may move; empty: anywhere
  bool seeks_support = true;      ///< few vertices move, and the solve finds which; else all may
  double shape_weight = 0.0;  ///< t ≥ 0 of the barrier [SHP-3]; 0: panels may lose their shape
  /// Corners that are straight in the base have multipliers [SHP-4]; else they have the barrier.
  bool limits_straight_corners = false;
  const MeshLimits* limits = nullptr;  ///< of `model`, in solver units; null: none are stated
  double keep_out_weight = kFirstKeepOutWeight;  ///< t > 0 of the barrier on keep-outs' rows
  const VertexSlides* slides = nullptr;          ///< null: every vertex may move anywhere
  /// 3 × n, solver units: how far the model's points are from the mesh that `slides` are about;
  /// null: they are that mesh's.
  const Eigen::Matrix3Xd* slides_from = nullptr;
};

/// One row of E: what it adds up.
struct FairnessRow {
  std::span<const int> vertices;    ///< local
  std::span<const double> weights;  ///< same layout

  /// Σ_k weights[k] · column(vertices[k]).
  template <class Column>
  [[nodiscard]] Eigen::Vector3d sum(const Column& column) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < vertices.size(); ++k) result += weights[k] * column(vertices[k]);
    return result;
  }
};

/// A free vertex of a patch that may not move anywhere.
struct Slide {
  int vertex = 0;  ///< local
  SlideTrack track;
};

/// The problem restricted to a set of free vertices; all others keep d = 0 (or their fixed
/// target). Local vertex numbers: first the free ones, then the halo they share terms with.
struct Patch {
  std::vector<int> vertices;  ///< local → mesh
  int free_count = 0;
  Positions points;               ///< 3 × local, solver units, undisplaced
  Positions displacement;         ///< 3 × local; the halo's columns are constant
  std::vector<VertexTerm> terms;  ///< free_count
  std::vector<Slide> slides;      ///< ascending
  ConstraintRows equations;       ///< local vertices; each touches a free one
  std::vector<int> equation_ids;  ///< their rows in MeshModel::equations; then of surface rows
  RaggedRows faces;               ///< local vertices of the same faces
  std::vector<int> face_ids;      ///< mesh face of each row of `faces`
  std::vector<int> star_ids;      ///< mesh vertices whose stars have rows here
  RaggedRows fairness_vertices;   ///< local vertices of each fairness row
  std::vector<double> fairness_values;  ///< same layout
  InequalityRows inequalities;          ///< local vertices; each touches a free one
  /// Of their multipliers in a field, −1: it has none; empty: none of them has.
  std::vector<int> inequality_ids;
  double shape_weight = 0.0;
  double keep_out_weight = 0.0;
  double fairness_weight = 0.0;

  [[nodiscard]] int local_count() const { return static_cast<int>(vertices.size()); }
  [[nodiscard]] FairnessRow fairness_row(int r) const {
    return {fairness_vertices[r],
            {fairness_values.data() + fairness_vertices.offsets[static_cast<std::size_t>(r)],
             fairness_vertices[r].size()}};
  }
  /// Calls visit(row) for every row of E on this patch.
  template <class Visit>
  void for_each_fairness_row(const Visit& visit) const {
    for (int r = 0; r < fairness_vertices.size(); ++r) visit(fairness_row(r));
  }
};

/// The nearest displacement on its track for every free vertex that has one.
/// @param displacement 3 × at least free_count
void put_on_tracks(const Patch& patch, Eigen::Matrix3Xd& displacement);

/// The displacements nearest to none: 0, or the nearest on a track that leads past it; 3 × free.
[[nodiscard]] Eigen::Matrix3Xd on_tracks(const Patch& patch);

/// Cuts patches out of a problem without touching the rest of the mesh. Keeps O(n) marks.
class PatchCutter {
 public:
  explicit PatchCutter(const MeshModel& model);

  /// @param free mesh vertices, no duplicates; fixed ones among them are left out
  void cut(const EditProblem& problem, std::span<const int> free, Patch& patch);

  /// cut() of `inner`, where every vertex that shares an equation or a fairness row with it is free
  /// too, but has no further rows: a relaxation of the problem on the whole mesh. Where its minimum
  /// leaves those vertices at rest, it is the minimum with everything free. [OPT-2]
  void cut_open(const EditProblem& problem, std::span<const int> inner, Patch& patch);

 private:
  int local(int vertex, Patch& patch);
  void begin(const EditProblem& problem, std::span<const int> free, Patch& patch);
  void add_rows(const EditProblem& problem, int owners, Patch& patch);
  void add_face(const EditProblem& problem, int face, Patch& patch);
  bool enter(std::span<int> vertices, Patch& patch);
  void add_corners(const EditProblem& problem, int face, Patch& patch);
  void add_straight(const MeshModel& model, int face, StraightCorner corner, Patch& patch);
  void add_limits(const MeshLimits& limits, int face, Patch& patch);
  void add_stars(const MeshModel& model, int vertex, Patch& patch);
  void add_fairness_rows(const EditProblem& problem, int vertex, Patch& patch);
  void place(const EditProblem& problem, Patch& patch);
  void number_inequalities(const MeshModel& model, Patch& patch) const;
  void add_surface_rows(const EditProblem& problem, Patch& patch);
  void cut_equations(const MeshModel& model, Patch& patch);

  std::vector<int> local_of_;  ///< −1 outside the patch being cut
  std::vector<int> face_mark_, row_mark_, star_mark_;
  /// Of the limits' rows of the patch being cut, kind by kind: their numbers in MeshLimits.
  std::array<std::vector<int>, LimitKinds::kCount> limit_numbers_;
  /// Of the straight corners' rows: their places in the mesh's list of corners.
  std::vector<int> straight_places_;
  int stamp_ = 0;
};

/// [PB-1] without smoothing, term by term.
[[nodiscard]] ObjectiveTerms objective(const Patch& patch);

/// Renames the vertices of a row. @param local new name by old one
/// @returns whether one of them is free: less than `free_count`
[[nodiscard]] bool localise(std::span<int> vertices, const std::vector<int>& local, int free_count);

/// The corners of a row, displaced; the free ones by `displacement` (3 × free, or 3 × local).
template <class Row>
[[nodiscard]] RowPoints<Row::kArity> corners_at(const Patch& patch,
                                                const Eigen::Matrix3Xd& displacement,
                                                const Row& row) {
  const auto arity = static_cast<Eigen::Index>(row.vertices.size());
  RowPoints<Row::kArity> result(3, arity);
  for (Eigen::Index k = 0; k < arity; ++k) {
    const int v = row.vertices[static_cast<std::size_t>(k)];
    result.col(k) = patch.points.col(v);
    if (v < patch.free_count) {
      result.col(k) += displacement.col(v);
    } else {
      result.col(k) += patch.displacement.col(v);
    }
  }
  return result;
}

/// The corners of `row`, displaced by the patch's own displacement.
template <ConstraintRow Row>
[[nodiscard]] RowPoints<Row::kArity> corners(const Patch& patch, const Row& row) {
  return corners_at(patch, patch.displacement, row);
}

/// c at points + displacement. @param displacement 3 × free, or 3 × local: the halo keeps the
/// patch's own. @param out resized to |equations|
void residuals_at(const Patch& patch, const Eigen::Matrix3Xd& displacement, Eigen::VectorXd& out);

}  // namespace planish
