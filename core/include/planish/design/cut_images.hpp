// SPDX-License-Identifier: MIT
/// The cuts that one cut asks for under a symmetry: itself and its images.
#pragma once

#include <vector>

#include "planish/cuts/cut.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {

/// `cut` and those of its images that the ones before do not make already, in an order in which
/// cut_mesh() takes them; `cut` alone where it cannot be made. Whether all of them can be made
/// cut_mesh() says. @param symmetry of `mesh`
[[nodiscard]] std::vector<Cut> cut_with_images(const Mesh& mesh, const Cut& cut,
                                               const MeshSymmetry& symmetry);

/// `cuts` as they are where what they leave has the symmetry; else each with its images, about the
/// mesh that those before it and their images left. Whether all of them can be made cut_base()
/// says.
/// @param symmetry of `mesh`; @param tolerance mm/m
[[nodiscard]] std::vector<Cut> cuts_with_images(const Mesh& mesh, const std::vector<Cut>& cuts,
                                                const MeshSymmetry& symmetry, double tolerance);

}  // namespace planish
