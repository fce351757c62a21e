// SPDX-License-Identifier: MIT
/// What a session says of its mesh, of the design shown and of its variations.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "planish/measures/folds.hpp"
#include "planish/measures/motion.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/variations/subspace.hpp"

namespace planish {

/// See FacePlanarity.
struct WorstPanel {
  double gap = 0.0, mm_per_m = 0.0;  ///< of the one panel that is worst in mm/m
  double excess = 0.0;               ///< of whichever panel it is largest
};

/// How far the panels or nodes of a mesh are from a kind of constraint; degrees.
struct KindSpread {
  std::string_view kind;                           ///< for example "circular"
  double median = 0.0, worst = 0.0, excess = 0.0;  ///< excess: of the worst, beyond rounding
};

struct MeshReport {
  MeshSummary summary;
  int degrees_of_freedom = 0;
  WorstPanel worst;
  int planarised_vertices = 0;    ///< that planarising moved; 0 if there was none
  double planarised_most = 0.0;   ///< the longest way of one, model units
  std::vector<KindSpread> kinds;  ///< of each that has rows on this mesh, planarity left out
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< display: (p − centre) · scale
  double scale = 1.0;
  std::vector<std::string> warnings;
};

/// Of a design: an edit, a variation, a step of the history.
struct ShapeReport {
  SolveReport solve;  ///< what led to it; its figures of the shape are those below
  int moved_vertices = 0;
  double max_displacement = 0.0;  ///< model units
  MotionRange motion;             ///< off the surface of the base and along it, model units
  WorstPanel worst;
  double fold_before = 0.0;    ///< degrees: sharpest at the panels of moved vertices, on the base
  Fold fold;                   ///< the sharpest there, of the design
  double fold_growth = 0.0;    ///< degrees: of the fold that sharpened most
  double handle_error = 0.0;   ///< of the design shown, model units: a variation moves handles too
  int continuation = 0;        ///< of the edit, see EditTargets
  bool lower_at_once = false;  ///< its objective is lower at once than along its path
  double seconds = 0.0;
};

struct VariationsReport {
  SubspaceReport subspace;
  int dimension = 0;
  double seconds = 0.0;
};

}  // namespace planish
