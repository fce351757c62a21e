// SPDX-License-Identifier: MIT
/// What points of a mesh stand on, seen from another shape of it. [SUP-6]
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/problem/problem.hpp"
#include "planish/supports/point_support.hpp"
#include "planish/supports/vertex_slides.hpp"

namespace planish {

/// The tracks and surfaces of supports that are meant in a base, for displacements that begin at
/// another shape of it: a design that is made exact, or that variations are found around.
class ShapeSlides {
 public:
  /// @param base what the supports are about
  /// @param shape 3 × n, model units: where displacements begin; a point that has left its place on
  ///              an outline is on the side where `shape` has it
  /// @param supports must pass find_problem(), with `base`
  /// @param unit model units per solver unit
  ShapeSlides(const Mesh& base, const Positions& shape, const std::vector<PointSupport>& supports,
              double unit);
  ShapeSlides(const ShapeSlides&) = delete;
  ShapeSlides& operator=(const ShapeSlides&) = delete;

  /// Holds the problem on `shape`, whose model this must outlive.
  void hold(EditProblem& problem) const;

  /// @see VertexSlides::follow() @param displacement from the shape, solver units
  bool follow(std::span<const int> vertices, const Eigen::Matrix3Xd& displacement);

  /// Whether every vertex is where its supports let it go.
  [[nodiscard]] bool holds(std::span<const int> vertices,
                           const Eigen::Matrix3Xd& displacement) const;

  /// `shape` with the points that stand on something on it; the others where they are.
  [[nodiscard]] Positions shape_on_supports() const;

  [[nodiscard]] const VertexSlides& slides() const { return slides_; }

 private:
  [[nodiscard]] Eigen::Matrix3Xd from_base(std::span<const int> vertices,
                                           const Eigen::Matrix3Xd& displacement) const;

  Mesh base_;
  Positions shape_;
  Eigen::Matrix3Xd from_;  ///< 3 × n, solver units
  double unit_;
  VertexSlides slides_;
};

/// Whether any of them holds a point.
[[nodiscard]] bool hold_points(const std::vector<PointSupport>& supports);

}  // namespace planish
