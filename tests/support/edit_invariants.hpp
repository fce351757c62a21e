// SPDX-License-Identifier: MIT
/// What holds after every operation on every mesh, measured without the code under test.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/projection/projection.hpp"
#include "planish/variations/subspace.hpp"

namespace planish::testing {

/// [MET-1] by a singular value decomposition of the face's points, mm/m.
[[nodiscard]] double svd_mm_per_m(const Positions& positions, std::span<const int> face);
/// The worst face.
[[nodiscard]] double worst_svd_mm_per_m(const Mesh& mesh, const Positions& positions);

/// How flat a face can be expected to be: the promise of 1e-6 mm/m, or what the rounding of its own
/// coordinates leaves (8 units in the last place over its longest edge, at most 1e-3 mm/m).
[[nodiscard]] double flatness_promise(const Positions& positions, std::span<const int> face);

/// The edit is finite, ascending and exact in its list of moved vertices; pins are untouched;
/// panels are flat unless the status says otherwise, and never worse than the base; the report
/// agrees with what is measured here.
[[nodiscard]] ::testing::AssertionResult is_valid_edit(const Mesh& mesh, const EditTargets& targets,
                                                       const HandleEditResult& result);

/// The same for a projection of `mesh`.
[[nodiscard]] ::testing::AssertionResult is_valid_projection(const Mesh& mesh,
                                                             const std::vector<int>& pins,
                                                             const ProjectionResult& result);
[[nodiscard]] Positions apply(const Mesh& mesh, const ProjectionResult& result);

/// Orthonormal to 1e-8, finite, its origin the edit's own bits; coefficients 0 give the edit.
[[nodiscard]] ::testing::AssertionResult is_valid_subspace(const Positions& edited,
                                                           const Subspace& subspace);

}  // namespace planish::testing
