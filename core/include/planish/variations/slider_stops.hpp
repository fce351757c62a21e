// SPDX-License-Identifier: MIT
/// How far each slider of a family of variations may go before a panel loses its shape. [SUB-7]
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/variations/subspace.hpp"

namespace planish {

/// Where a slider stops, and the panel that stops it.
struct SliderStop {
  double value = std::numeric_limits<double>::infinity();  ///< of the coefficient; ±∞: nowhere
  int face = -1;                                           ///< −1: none
};

/// From its lower to its upper stop, the slider's present value in between.
struct SliderRange {
  SliderStop lower{-std::numeric_limits<double>::infinity(), -1};
  SliderStop upper;
};

/// The range of every slider, all others where they are. Along a slider a corner's share [SHP-1] is
/// a quadratic, so its stops are roots: a preview in closed form, as the sliders themselves are.
/// A slider that stands beyond a stop is told that stop, behind it. Corners without a share left in
/// the edit itself stop nothing. The shape bound keeps a twentieth of each corner, so a stop comes
/// a little before the panel is spoilt. Costs what the support's panels have.
/// @param base what the panels' shape is measured against
/// @param edited 3 × n, p⁺ of the family
/// @param values s coefficients
[[nodiscard]] std::vector<SliderRange> slider_ranges(const Mesh& base, const Positions& edited,
                                                     const Subspace& subspace,
                                                     const Eigen::VectorXd& values);

}  // namespace planish
