// SPDX-License-Identifier: MIT
/// The planar polygon, any size: as a projection (for splitting) and as equations with
/// derivatives (for tangent spaces and Newton's method).
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "planish/mesh.hpp"

namespace planish {

/// Unit eigenvector of the smallest eigenvalue of a symmetric positive semidefinite 3 × 3 matrix.
/// Rayleigh quotient iteration from `guess` (cubic convergence, so one or two steps when the
/// guess is the last normal), verified, with an eigenvalue decomposition as the safe fallback.
/// @param guess unit vector, or zero for none
[[nodiscard]] Eigen::Vector3d smallest_direction(const Eigen::Matrix3d& covariance,
                                                 const Eigen::Vector3d& guess);

/// Nearest points on a common plane through their mean, (16): centre, then remove the component
/// along the singular vector of the smallest singular value. [PL-1]
/// @param points 3 × k, centred in place and projected
/// @param normal in: last normal or zero; out: the plane's unit normal
void project_to_plane_centred(Eigen::Ref<Eigen::Matrix3Xd> points, Eigen::Vector3d& normal);

/// One scalar equation of flatness among four vertices a, b, c, d:
///   c(p) = scale · det(b − a, c − a, d − a) = 0,                                       [PL-2]
/// trilinear, so all derivatives are closed form. `scale` turns it into a distance on the mesh it
/// was made for, in the unit of the positions. A polygon of n vertices has n − 3 of them.
struct FlatnessEquation {
  std::array<int, 4> vertices{};
  double scale = 1.0;
  /// > 0 where a, b, c carry the plane of a larger polygon: then the scale follows their triangle,
  /// down to this doubled area. Otherwise "all three on a line" would solve every equation of the
  /// polygon at once without making it flat.
  double least_area = 0.0;
};

/// Four points, one a column, in the order of FlatnessEquation::vertices.
using FourPoints = Eigen::Matrix<double, 3, 4>;

/// The factor of det() for the equation with its corners at `points`.
[[nodiscard]] double scale_at(const FlatnessEquation& equation, const FourPoints& points);

/// c with the corners at `points`.
[[nodiscard]] double residual(const FlatnessEquation& equation, const FourPoints& points);

/// ∂c/∂(vertex k) in column k. [PL-3]
[[nodiscard]] FourPoints gradient(const FlatnessEquation& equation, const FourPoints& points);

/// ∂²c/∂(vertex k)∂(vertex l), 3 × 3, for k > l; each is a skew matrix, and the (l, k) block is
/// its transpose; blocks on the diagonal are zero. Order, row by row: (1,0) (2,0) (2,1) (3,0) (3,1)
/// (3,2). [PL-4]
/// Where the scale follows the triangle it is held constant here: the terms left out are multiples
/// of c and of ∇c, which do not change a Newton step on the constraints.
[[nodiscard]] std::array<Eigen::Matrix3d, 6> hessian(const FlatnessEquation& equation,
                                                     const FourPoints& points);

/// The n − 3 equations of `face`. Three well-spread vertices carry the plane; every other vertex
/// gives one equation. Appends nothing for a triangle.
void append_flatness_equations(const Positions& positions, std::span<const int> face,
                               std::vector<FlatnessEquation>& out);

}  // namespace planish
