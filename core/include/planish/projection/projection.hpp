// SPDX-License-Identifier: MIT
/// Problem (8): the nearest mesh whose panels are all flat.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "planish/constraints/kept_constraint.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/measures/energies.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/numeric/executor.hpp"
#include "planish/problem/engine.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/supports/point_support.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct ProjectionOptions {
  /// α_f ≥ 0. 0: the nearest mesh. Higher: a smoother correction that moves more vertices. [PRO-1]
  double fairness_weight = 0.0;
  double distance_weight = 1.0;  ///< α_d > 0; higher: closer to the given mesh [PRO-2]
  FairnessKind fairness = FairnessKind::kSecondDifference;
  Engine engine = Engine::kNewton;
  std::shared_ptr<Executor> executor = nullptr;  ///< as in HandleEditOptions
  /// No panel becomes concave, crossing, turned over or collapsed that was not [SHP-1]; where that
  /// and flatness cannot both be had, shape wins and the panels that are not flat are named; with a
  /// history, flatness wins.
  bool keep_shape = true;
  /// Of every panel's FacePlanarity::excess, mm/m, > 0.
  double tolerance = PlanarPolygon::kTolerance;
  /// Without a history: panels become as flat as the tolerance asks for and no flatter, by the
  /// least change. [PRO-7]
  bool no_flatter = false;
  /// Without a history: no vertex moves farther, model units; where the flat mesh is farther away,
  /// the result is as flat as that allows. 0: any distance. [PRO-7]
  double within = 0.0;
  /// Kept beside planarity.
  std::vector<KeptConstraint> constraints = {};
  /// What points stand on: as in edits, about the mesh as given, with a history about that. They
  /// must pass find_problem() on it. kNewton only. [SUP-6]
  std::vector<PointSupport> supports = {};
  int max_iterations = 0;  ///< 0 picks the engine's own limit
};

[[nodiscard]] Refusal find_problem(const ProjectionOptions& options);

/// Why the nearest mesh within some rings of what failed took the place of (8) with its weighted
/// distance: SolveStatus::kNearestConfined.
enum class ConfinedBecause {
  kNothing,            ///< it did not
  kNotExact,           ///< the weighted problem's solve left panels above a tolerance
  kSpoiltPanels,       ///< its panels would have lost their shape
  kStatedLimits,       ///< its panels would have exceeded a limit of the edit
  kSpoiltByVariation,  ///< no other flat mesh near it keeps the shape of panels either
};

/// The reason as reports say it, for example "weighted distance: panels would lose their shape"; ""
/// for kNothing.
[[nodiscard]] std::string_view reason(ConfinedBecause because);

struct ProjectionResult {
  std::vector<int> moved;     ///< ascending vertex indices
  Positions moved_positions;  ///< 3 × |moved|, model units
  double rms_move = 0.0;      ///< over all vertices, model units
  double max_move = 0.0;      ///< model units
  /// α_f of the problem solved: more than asked for where the panels' shape needs it.
  double fairness_weight = 0.0;
  ConfinedBecause confined_because = ConfinedBecause::kNothing;
  /// Faces still above a tolerance, or around a point that is (empty when exact), worst first.
  std::vector<int> failing_faces;
  SolveReport report;
};

/// Makes every panel flat, and keep the other constraints asked for, moving as little as possible:
/// ‖t̃‖². A mesh that keeps them already comes back as it is, bit for bit.
/// @param pins vertices that must not move
[[nodiscard]] ProjectionResult project_to_planar(const Mesh& mesh,
                                                 const ProjectionOptions& options = {},
                                                 const std::vector<int>& pins = {},
                                                 const Progress& progress = {});

/// Projects a mesh with a history: vertices that still sit where `reference` has them are penalised
/// by w_i ‖t̃_i‖, so a local design stays local. Faces are `mesh`'s. [PRO-3]
/// @param reference p⁰, 3 × n
[[nodiscard]] ProjectionResult project_to_planar(const Mesh& mesh, const Positions& reference,
                                                 const ProjectionOptions& options = {},
                                                 const std::vector<int>& pins = {},
                                                 const Progress& progress = {});

}  // namespace planish
