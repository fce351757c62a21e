// SPDX-License-Identifier: MIT
/// A sparse displacement of a whole mesh with its dual variables: O(1) access, O(touched) reset.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engines/patch_system.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// What a warm start needs. Untouched vertices and equations read as zero.
class DisplacementField {
 public:
  /// @param equation_count of the model; surface rows and limits, whose numbers come after these,
  ///                       get room once one of them is stored
  DisplacementField(int vertex_count, int equation_count);

  void clear();
  /// Values of the patch's free vertices, equations and inequalities.
  void load(const Patch& patch, PatchState& state) const;
  void store(const Patch& patch, const PatchState& state);
  /// d and w of one vertex become zero: it has left the working set.
  void reset_vertex(int vertex);

  [[nodiscard]] Eigen::Vector3d displacement(int vertex) const { return displacement_.col(vertex); }
  void set_displacement(int vertex, const Eigen::Vector3d& value);
  [[nodiscard]] const std::vector<int>& touched_vertices() const { return vertices_; }

  /// Everything multiplied by `factor`: where a linear path from zero would be.
  void scale(double factor);

  /// The touched part only, to be put back later.
  struct Snapshot {
    std::vector<int> vertices, equations;
    Eigen::Matrix3Xd displacement, norm_dual;
    Eigen::VectorXd multipliers;
  };
  [[nodiscard]] Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);

 private:
  void touch_vertex(int vertex);
  void touch_equation(int equation);
  void make_room(int equation);
  [[nodiscard]] double multiplier(int equation) const;

  Eigen::Matrix3Xd displacement_, norm_dual_;  ///< 3 × n
  Eigen::VectorXd multipliers_;
  std::vector<char> vertex_touched_, equation_touched_;
  std::vector<int> vertices_, equations_;
};

/// How far apart two states put a vertex at most.
[[nodiscard]] double farthest_apart(const DisplacementField::Snapshot& a,
                                    const DisplacementField::Snapshot& b);

}  // namespace planish
