// SPDX-License-Identifier: MIT
/// Problem (3): move a few handles, keep every panel flat, leave the rest where it is.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planish/constraints/kept_constraint.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/constraints/stated_limit.hpp"
#include "planish/measures/energies.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/numeric/executor.hpp"
#include "planish/obstacles/keep_out.hpp"
#include "planish/problem/corner_force.hpp"
#include "planish/problem/engine.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/supports/point_support.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct MeshSymmetry;

/// A vertex and where it should go.
struct Handle {
  int vertex = 0;
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< absolute position, model units

  friend bool operator==(const Handle&, const Handle&) = default;
};

/// What the user holds: handles to move, pins that stay, and points that slide on something. Order
/// does not matter.
struct EditTargets {
  std::vector<Handle> handles = {};
  std::vector<int> pins = {};               ///< vertices that keep their base position exactly
  std::vector<PointSupport> supports = {};  ///< a vertex in several stays on all of them
  /// Steps, 0 to kMostContinuation: the handles go to their targets in so many equal ones from the
  /// base, each solved from the last like a frame of a drag. 0 solves at once. Where an edit has
  /// more than one minimum the two may differ. Engine::kNewton; a drag ignores it. [PTH-1]
  int continuation = 0;
};

/// How far the handle that is farthest from its target is from it. @param points 3 × n
[[nodiscard]] double farthest_handle(const std::vector<Handle>& handles, const Positions& points);

/// Most steps of EditTargets::continuation.
inline constexpr int kMostContinuation = 1000;

/// Weights and choices of an edit. Lengths are divided by the mean edge length before a solve,
/// so every weight is a pure number and means the same on a model in mm, m or km.
struct HandleEditOptions {
  /// ω_h > 0. Lower: handles stop short of their targets. Higher: closer, slower. [HE-1]
  double attraction = 1000.0;
  /// ω_s ≥ 0. Lower: more vertices move. Higher: fewer, with sharper transitions. [HE-2]
  double locality = 1.0;
  /// ω_f ≥ 0. 0 moves the handle's immediate neighbours only. Higher: wider, smoother. [HE-3]
  double smoothness = 1.0;
  FairnessKind fairness = FairnessKind::kSecondDifference;
  Sparsity sparsity = Sparsity::kL21;
  /// No panel becomes concave, crossing, turned over or collapsed that was not. [SHP-1]
  bool keep_shape = true;
  /// Limits on folds, angles, edges, areas and sizes of panels. [LIM-1]
  std::vector<StatedLimit> bounds = {};
  /// Where nothing may go: what is there in the base goes no deeper. [KEE-1]
  std::vector<KeepOut> keep_outs = {};
  double clearance = 0.0;     ///< ≥ 0, model units: from the keep-outs
  bool hard_handles = false;  ///< targets are constraints; infeasible ones are reported
  /// Face rings ≥ 0 around the handles that may move; 0 is no limit. Few: panels fold to follow the
  /// handle, or it stops short. [RCH-1]
  int reach = 0;
  /// How far from a handle's base position vertices may move, straight, model units, ≥ 0; 0 is no
  /// limit. Where `reach` is given too, both hold.
  double reach_length = 0.0;
  /// Points on a boundary stay, handles excepted.
  bool keep_boundary = false;
  /// 0, or kSoftest ≥ softness ≥ kHardest: derives the weights in place of `locality` and
  /// `smoothness`. Higher: wider and gentler. [SOF-1]
  double softness = 0.0;
  Engine engine = Engine::kNewton;
  /// Threads for the paper's engine; null: the caller's alone. The bits are the same. [ALM-7]
  std::shared_ptr<Executor> executor = nullptr;
  /// Worst panel of a finished edit, mm/m, > 0; far from the origin as far as the coordinates can
  /// hold it, see FacePlanarity::excess. [MET-3]
  double tolerance = PlanarPolygon::kTolerance;
  /// Panels that move stay as bent as they are, instead of becoming flat: none bends more, and what
  /// is flat to PlanarPolygon::kTolerance stays so. `tolerance` is then the most that the base may
  /// be bent. Engine::kNewton. [MET-6]
  bool keep_bends = false;
  /// At most one of each kind. They hold in absolute terms: see find_broken_constraint().
  std::vector<KeptConstraint> constraints = {};
  /// Outer steps ≥ 1; 0 picks the engine's own limit.
  int max_iterations = 0;
};

/// The scale of HandleEditOptions::softness.
inline constexpr double kHardest = 1.0, kSoftest = 10.0;

/// The first rule that `options` breaks, naming the field; nullopt if none.
[[nodiscard]] Refusal find_problem(const HandleEditOptions& options);

/// Planarity and the constraints of `options`, which break no rule.
[[nodiscard]] KeptKinds kept_kinds(const HandleEditOptions& options);

/// Why `mesh` is no base for an edit with these constraints: the constraint beside planarity that
/// it breaks itself, and its worst panel; nullopt if it keeps them all. O(n).
[[nodiscard]] Refusal find_broken_constraint(const Mesh& mesh, const HandleEditOptions& options);

/// Why the steps of `targets` are none.
[[nodiscard]] Refusal find_continuation_problem(const EditTargets& targets);

/// What of an edit the engine of `options` does not solve: see Beyond.
[[nodiscard]] Refusal find_engine_problem(const HandleEditOptions& options,
                                          const EditTargets& targets, bool symmetric);

/// Why an edit with these options has no variations around it.
[[nodiscard]] Refusal find_variation_problem(const HandleEditOptions& options);

/// The first rule that `targets` break on `mesh`, naming the vertex; nullopt if none.
[[nodiscard]] Refusal find_problem(const EditTargets& targets, const Mesh& mesh);

/// Vertices that no edit of `targets` moves, whatever the handles do: the pins, with keep_boundary
/// the boundary, with a reach everything outside it. Handles are never among them. Ascending; O(n).
[[nodiscard]] std::vector<int> held_vertices(const Mesh& mesh, const EditTargets& targets,
                                             const HandleEditOptions& options);

/// What an edit moved: everything else is the base mesh, bit for bit.
struct HandleEditResult {
  std::vector<int> moved;     ///< ascending vertex indices
  Positions moved_positions;  ///< 3 × |moved|, model units, same order
  SolveReport report;
};

/// `mesh` with the moved vertices of `result` in place.
[[nodiscard]] Positions apply(const Mesh& mesh, const HandleEditResult& result);

/// Keeps what does not depend on the targets. Construction is O(n); a solve costs what the edit
/// costs. `mesh` must pass check_mesh() and be flat to the tolerance (see project_to_planar()).
class HandleEditSolver {
 public:
  HandleEditSolver(const Mesh& mesh, const HandleEditOptions& options);
  ~HandleEditSolver();
  HandleEditSolver(HandleEditSolver&&) noexcept;
  HandleEditSolver& operator=(HandleEditSolver&&) noexcept;

  /// New weights for the following solves; forgets the drag. O(n), far less than construction
  /// unless `fairness` changes.
  void set_options(const HandleEditOptions& options);

  /// Solves from the base mesh. The result depends on mesh, options and targets alone.
  [[nodiscard]] HandleEditResult solve(const EditTargets& targets, const Progress& progress = {});

  /// solve() under a symmetry: the result is symmetric to 1e-9 of the mean edge where the base is,
  /// mirror planes of an axis through 0 to the bit. Forgets the drag. [SYM-2]
  /// @param targets closed under `symmetry`: see with_images()
  /// @param symmetry of the mesh, which has it within kSymmetric
  [[nodiscard]] HandleEditResult solve_symmetric(const EditTargets& targets,
                                                 const MeshSymmetry& symmetry,
                                                 const Progress& progress = {});

  /// What holds panels flat where the last solve ended; nothing of panels that hold nothing, and
  /// nothing at all under the paper's engine.
  [[nodiscard]] std::vector<CornerForce> corner_forces() const;

  /// Solves from the last result, for a frame of a drag. Exact like solve(), but may follow the
  /// path. Stops early, with the last exact state, once `budget_seconds` is spent.
  [[nodiscard]] HandleEditResult drag(const EditTargets& targets, double budget_seconds);

  /// Marks where the drag stands, for go_back(). Costs what moved.
  void keep_frame();
  /// The next frame follows the one that was kept last, as if none had been since; where none was,
  /// or where options, pins or supports changed, it starts afresh.
  void go_back();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// One call: HandleEditSolver(mesh, options).solve(targets).
[[nodiscard]] HandleEditResult solve_handle_edit(const Mesh& mesh, const EditTargets& targets,
                                                 const HandleEditOptions& options = {});

}  // namespace planish
