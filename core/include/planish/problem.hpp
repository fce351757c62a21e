// SPDX-License-Identifier: MIT
/// The common form of (3) and (8) that both engines read:
///
///   min  Σ_i [ w_i/2 ‖d_i‖ + q_i/2 ‖d_i − target_i‖² ] + ω_f/2 ‖E d‖²                   [PB-1]
///   s.t. c(p + d) = 0,   d_i = target_i where fixed
///
/// with all lengths in units of the mean edge length of the mesh.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "planish/adjacency.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/energies.hpp"
#include "planish/mesh.hpp"
#include "planish/solve_report.hpp"

namespace planish {

/// What does not change while a mesh is edited, in solver units. Built once, O(n).
class MeshModel {
 public:
  MeshModel(const Mesh& mesh, FairnessKind fairness);

  [[nodiscard]] int vertex_count() const { return static_cast<int>(points.cols()); }
  /// Solver units → model units, for displacements.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] std::span<const int> face(int f) const;

  Mesh mesh;         ///< as given, model units
  Positions points;  ///< 3 × n, centred, mean edge 1
  Adjacency adjacency;
  FairnessOperator fairness;                ///< rows × n
  FairnessOperator fairness_columns;        ///< its transpose: n × rows
  std::vector<FlatnessEquation> equations;  ///< of all faces, face by face
  std::vector<int> face_equations;          ///< n_faces + 1 offsets into `equations`

 private:
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

/// (3) or (8) on a mesh.
struct EditProblem {
  const MeshModel* model = nullptr;
  std::vector<VertexTerm> terms;  ///< n
  std::vector<int> handles;       ///< vertices whose term is a handle's
  double fairness_weight = 0.0;   ///< ω_f ≥ 0
  /// Whether (almost) every vertex has a norm weight: then few move, and a working set finds them.
  bool sparse = true;
};

/// The problem restricted to a set of free vertices; all others keep d = 0 (or their fixed
/// target). Local vertex numbers: first the free ones, then the halo they share terms with.
struct Patch {
  std::vector<int> vertices;  ///< local → mesh
  int free_count = 0;
  Positions points;                         ///< 3 × local, solver units, undisplaced
  Positions displacement;                   ///< 3 × local; the halo's columns are constant
  std::vector<VertexTerm> terms;            ///< free_count
  std::vector<FlatnessEquation> equations;  ///< local vertices; each touches a free one
  std::vector<int> equation_ids;            ///< the same in MeshModel::equations
  RaggedRows faces;                         ///< local vertices of the same faces
  std::vector<int> face_ids;                ///< mesh face of each row of `faces`
  RaggedRows fairness_vertices;             ///< local vertices of each fairness row
  std::vector<double> fairness_values;      ///< same layout
  double fairness_weight = 0.0;

  [[nodiscard]] int local_count() const { return static_cast<int>(vertices.size()); }
};

/// Cuts patches out of a problem without touching the rest of the mesh. Keeps O(n) marks.
class PatchCutter {
 public:
  explicit PatchCutter(int vertex_count, int face_count, int fairness_rows);

  /// @param free mesh vertices, no duplicates; fixed ones among them are left out
  void cut(const EditProblem& problem, std::span<const int> free, Patch& patch);

 private:
  int local(int vertex, Patch& patch);

  std::vector<int> local_of_;  ///< −1 outside the patch being cut
  std::vector<int> face_mark_, row_mark_;
  int stamp_ = 0;
};

/// [PB-1] without smoothing, term by term.
[[nodiscard]] ObjectiveTerms objective(const Patch& patch);

/// Residuals of all equations at points + displacement. @param out resized to |equations|
void residuals(const Patch& patch, Eigen::VectorXd& out);

/// The four displaced corners of an equation.
[[nodiscard]] FourPoints corners(const Patch& patch, const FlatnessEquation& equation);

/// The same with the free ones displaced by `displacement` (3 × free) instead of the patch's own.
[[nodiscard]] FourPoints corners_at(const Patch& patch, const Eigen::Matrix3Xd& displacement,
                                    const FlatnessEquation& equation);

}  // namespace planish
