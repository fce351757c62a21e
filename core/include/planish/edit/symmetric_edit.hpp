// SPDX-License-Identifier: MIT
/// An edit under a symmetry: the base that it starts from, and its targets with all their images.
/// HandleEditSolver::solve_symmetric() solves it. [SYM-2]
#pragma once

#include <string>
#include <variant>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// `targets` with the images of its handles, pins and supports; or the sentence that says what they
/// contradict. The given handles come first. A handle on a mirror plane or an axis must have its
/// target there, to a millionth of the mean edge, and gets it exactly.
/// @param base that `symmetry` is of
[[nodiscard]] std::variant<EditTargets, std::string> with_images(const EditTargets& targets,
                                                                 const Mesh& base,
                                                                 const MeshSymmetry& symmetry);

/// The nearest place to `place` on all mirror planes and axes that `vertex` is on; `place` itself
/// where it is on none. Model units.
[[nodiscard]] Eigen::Vector3d place_on_fixed_points(const MeshSymmetry& symmetry, int vertex,
                                                    const Eigen::Vector3d& place);

/// A flat mesh further from symmetric than this share of its mean edge is not evened out: to do so
/// would spoil panels.
inline constexpr double kMostEvened = 0.01;

/// What make_symmetric() did.
struct SymmetricBase {
  bool symmetric = true;  ///< false: no mesh that is flat and symmetric was found
  double max_move = 0.0;  ///< model units; 0: nothing moved
  int moved = 0;          ///< points whose bits are not those given
};

/// Moves what was found symmetric within kSymmetryReach to where it is within kSymmetric, flat
/// again to `tolerance`; a mesh that is within kSymmetric keeps its bits, as does one beyond
/// kMostEvened, which is not symmetric.
/// @param tolerance mm/m
[[nodiscard]] SymmetricBase make_symmetric(Mesh& flat, const MeshSymmetry& symmetry,
                                           double tolerance, const Progress& progress = {});

}  // namespace planish
