// SPDX-License-Identifier: MIT
/// [YYPM11]: the fairest directions of the tangent space, with nothing that keeps them local.
#pragma once

#include <Eigen/Core>

#include "planish/measures/energies.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish::comparison {

/// Eigenvectors of EᵀE over {t : J t = 0, t = 0 on the boundary}, smallest first.
/// @param flat a mesh whose panels are flat
/// @returns 3n × s, orthonormal, interleaved by vertex; fewer columns if there are fewer
[[nodiscard]] Eigen::MatrixXd global_subspace(const Mesh& flat, int dimension,
                                              FairnessKind fairness);

}  // namespace planish::comparison
