// SPDX-License-Identifier: MIT
/// Logarithm with the same bits on every platform; see trigonometry.hpp.
#pragma once

namespace planish {

/// ln x for a normal x > 0; error of a few units in the last place of max(1, |ln x|).
[[nodiscard]] double natural_logarithm(double x);

}  // namespace planish
