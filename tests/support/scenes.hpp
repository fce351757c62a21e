// SPDX-License-Identifier: MIT
/// Meshes, edits and random numbers that the numerical tests and the benchmarks share.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/problem.hpp"
#include "planish/variations/subspace.hpp"

namespace planish::testing {

inline constexpr double kPromise = 1e-6;  ///< mm/m out of flat, what every exact result keeps

/// The fixed seeds of every randomised test, and PLANISH_SEED from the environment if set.
[[nodiscard]] std::vector<unsigned> seeds();

/// Whether a set is run whole: every night (PLANISH_NIGHTLY=1), and in part at every commit.
[[nodiscard]] bool is_night();
/// So many of a set: all of them every night, a few at every commit.
[[nodiscard]] int by_night(int all, int few);

/// Random actions per sequence: a moderate number, or PLANISH_ACTIONS from the environment.
[[nodiscard]] int action_count();

/// Standard normal coordinates, 3 × count; the same on every platform.
[[nodiscard]] Eigen::Matrix3Xd random_points(unsigned seed, Eigen::Index count);
/// Standard normal values.
[[nodiscard]] Eigen::VectorXd random_vector(unsigned seed, Eigen::Index count);

/// columns × rows vertices at (i, j, height(i, j)), vertex j · columns + i, quads in between.
[[nodiscard]] Mesh quad_grid(int columns, int rows,
                             const std::function<double(double, double)>& height);
/// The same, flat.
[[nodiscard]] Mesh quad_grid(int columns, int rows);
/// The same with each quad cut into two triangles: no constraints at all.
[[nodiscard]] Mesh triangle_grid(int columns, int rows);
/// A sample of shapes.hpp by name; aborts the test where it does not exist.
[[nodiscard]] Mesh sample(const std::string& name, int size);

/// The two public scenes of docs/math.md: vertex 16 · 32 + 16 of the 32 × 32 mesh, lifted by 1.5.
[[nodiscard]] EditTargets public_scene_targets(const Mesh& mesh);
/// One handle, moved by `move`.
[[nodiscard]] EditTargets pull(const Mesh& mesh, int vertex, const Eigen::Vector3d& move);

/// Vertices within `rings` face rings of `vertex`, ascending; an independent count.
[[nodiscard]] std::vector<int> ring_neighbourhood(const Mesh& mesh, int vertex, int rings);
/// Vertices that a result moves by more than `length`.
[[nodiscard]] std::vector<int> moved_beyond(const Mesh& mesh, const HandleEditResult& result,
                                            double length);
/// Panels that `after` spoils, all of them counted.
[[nodiscard]] int spoilt_count(const Mesh& base, const Positions& after);
/// An edit's positions with its variation at `values`.
[[nodiscard]] Positions varied(const Positions& edited, const Subspace& subspace,
                               const Eigen::VectorXd& values);
/// The vertex nearest to the middle of the bounding box.
[[nodiscard]] int middle_vertex(const Mesh& mesh);

/// A mesh with the problem (3) on it: terms as HandleEditSolver sets them, nothing solved.
class ProblemOnMesh {
 public:
  explicit ProblemOnMesh(const Mesh& mesh, FairnessKind kind = FairnessKind::kSecondDifference);

  /// Makes `vertex` a handle with a displacement in solver units.
  void add_handle(int vertex, const Eigen::Vector3d& target, double attraction = 1000.0);
  [[nodiscard]] Patch cut(const std::vector<int>& free);
  [[nodiscard]] Patch cut_all();

  MeshModel model;
  EditProblem problem;
};

}  // namespace planish::testing
