// SPDX-License-Identifier: MIT
/// The planar polygon, any size: as a projection (for splitting) and as equations with
/// derivatives (for tangent spaces and Newton's method).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "planish/constraints/kind.hpp"
#include "planish/mesh/mesh.hpp"

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

/// Four points, one a column, in the order of FlatnessEquation::vertices.
using FourPoints = RowPoints<4>;

/// One scalar equation of flatness among four vertices a, b, c, d:
///   c(p) = scale · det(b − a, c − a, d − a) − bend = 0,                                [PL-2]
/// trilinear, so all derivatives are closed form. `scale` turns it into a distance on the mesh it
/// was made for, in the unit of the positions. A polygon of n vertices has n − 3 of them.
struct FlatnessEquation {
  static constexpr int kArity = 4;
  static constexpr bool kCurvedDiagonal = true;  ///< of a bent panel; else linear in each corner
  std::array<int, 4> vertices{};
  double scale = 1.0;
  /// > 0 where a, b, c carry the plane of a larger polygon: then the scale follows their triangle,
  /// down to this doubled area. Otherwise "all three on a line" would solve every equation of the
  /// polygon at once without making it flat.
  double least_area = 0.0;
  /// > 0: the equation of a panel that stays bent. This is then the length of one of its edges in
  /// the mesh, and the scale follows the panel: a distance, for every length of that edge. [PL-5]
  double edge = 0.0;
  double bend = 0.0;     ///< what the determinant's part is to be: 0 in a plane
  bool is_quad = false;  ///< of a panel that stays bent: the corners are all of it
};

/// The factor of det() for the equation with its corners at `points`.
[[nodiscard]] double scale_at(const FlatnessEquation& equation, const FourPoints& points);

/// c with the corners at `points`.
[[nodiscard]] double residual(const FlatnessEquation& equation, const FourPoints& points);

/// ∂c/∂(vertex k) in column k. [PL-3]
[[nodiscard]] FourPoints gradient(const FlatnessEquation& equation, const FourPoints& points);

/// ∂²c/∂(vertex k)∂(vertex l): of a flat panel skew matrices, and zero where k = l. [PL-4] [PL-5]
/// Where the scale follows the panel, multiples of c and of ∇c are left out, which do not change a
/// Newton step on the constraints.
[[nodiscard]] CurvatureBlocks<4, true> hessian(const FlatnessEquation& equation,
                                               const FourPoints& points);

/// Places in `face` of three vertices that are far apart: they carry the plane of a larger polygon,
/// and its circle. @param face at least three vertices
[[nodiscard]] std::array<std::size_t, 3> spread_corners(const Positions& positions,
                                                        std::span<const int> face);

/// The n − 3 equations of `face`. Three well-spread vertices carry the plane; every other vertex
/// gives one equation. Appends nothing for a triangle.
void append_flatness_equations(const Positions& positions, std::span<const int> face,
                               std::vector<FlatnessEquation>& out);

/// The equation by which a panel that is bent at `positions` stays so, from one of its equations of
/// flatness. @param is_quad whether it is the panel's only one
[[nodiscard]] FlatnessEquation bent_equation(const Positions& positions, FlatnessEquation equation,
                                             bool is_quad);

/// Flatness of one panel.
struct FacePlanarity {
  double gap = 0.0;       ///< max − min signed distance to the best-fit plane, model units
  double mm_per_m = 0.0;  ///< 1000 · gap / longest edge; 0 for triangles [MET-1]
  /// mm_per_m, or 0 where the rounding of the panel's own coordinates accounts for it: a panel of
  /// 1 m at 1e7 m cannot be flatter than about 1e-6 mm/m, wherever its corners go. Rounding never
  /// accounts for more than 1e-3 mm/m. What is compared with a tolerance. [MET-3]
  double excess = 0.0;
};

/// [MET-1] for one face; `positions` is 3 × n of the whole mesh.
[[nodiscard]] FacePlanarity face_planarity(const Positions& positions, std::span<const int> face);

/// The kind: every vertex of a face in one plane.
struct PlanarPolygon {
  static constexpr std::string_view kName = "planar";
  static constexpr std::string_view kUnit = "mm/m";
  static constexpr double kTolerance = 1e-6;
  static constexpr Element kElement = Element::kFace;
  static constexpr Sense kSense = Sense::kZero;
  using Row = FlatnessEquation;

  static void append_rows(const Positions& positions, std::span<const int> face,
                          std::vector<Row>& out) {
    append_flatness_equations(positions, face, out);
  }
  /// [MET-1]
  [[nodiscard]] static double measure(const Positions& positions, std::span<const int> face) {
    return face_planarity(positions, face).mm_per_m;
  }
};

}  // namespace planish
