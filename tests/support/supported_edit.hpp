// SPDX-License-Identifier: MIT
/// What tests of supports share: a sample, its middle vertex and edits of it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"

namespace planish::testing {

/// @param text as parse_point_support() reads it
inline PointSupport support(const std::string& text) { return *parse_point_support(text); }

inline std::string sample_name(const ::testing::TestParamInfo<const char*>& of) { return of.param; }

/// Edits of a sample around its middle vertex.
class SupportedEdit : public ::testing::TestWithParam<const char*> {
 protected:
  SupportedEdit() : mesh(sample(GetParam(), 16)), handle(middle_vertex(mesh)) {}

  [[nodiscard]] EditTargets lifted(double lift) const {
    return pull(mesh, handle, {0.2 * lift, 0.1 * lift, lift});
  }
  /// Points around the handle, the handle left out.
  [[nodiscard]] std::vector<int> around() const {
    std::vector<int> ring = ring_neighbourhood(mesh, handle, 1);
    std::erase(ring, handle);
    return ring;
  }
  [[nodiscard]] HandleEditResult solve(const EditTargets& targets) const {
    HandleEditResult result = solve_handle_edit(mesh, targets);
    EXPECT_TRUE(is_valid_edit(mesh, targets, result));
    return result;
  }

  /// How far a vertex went.
  [[nodiscard]] double way_of(const HandleEditResult& result, int vertex) const {
    return (apply(mesh, result).col(vertex) - mesh.positions.col(vertex)).norm();
  }

  const Eigen::Vector3d kAlong{0.6, 0.7, 0.1};  ///< about a mean edge along most surfaces

  Mesh mesh;
  int handle;
};

}  // namespace planish::testing
