// SPDX-License-Identifier: MIT
/// Parametric sample meshes, every panel flat by construction (to 1e-6 mm/m); z is up, the mean
/// edge is about 1.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Names for make_sample(), in the order a chooser should show them:
/// roof, vault, dome, freeform, hex, trihex.
[[nodiscard]] std::vector<std::string_view> sample_names();

/// The sample `name` at `size`. vault and dome have size × size vertices by the formulas of
/// docs/math.md; the others have roughly as many. nullopt if the name is unknown or the size is
/// outside 3 … 2000. Same bits on every platform: no libm trigonometry.
[[nodiscard]] std::optional<Mesh> make_sample(std::string_view name, int size);

}  // namespace planish
