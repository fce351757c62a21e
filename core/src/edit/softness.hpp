// SPDX-License-Identifier: MIT
/// The weights of an edit: those of the options, or those that a softness stands for.
#pragma once

#include "planish/edit/handle_edit.hpp"

namespace planish {

/// ω_h, ω_s and ω_f of (3).
struct EditWeights {
  double attraction = 0.0, locality = 0.0, smoothness = 0.0;
};

/// The only place that turns a softness into weights. [SOF-1]
/// ω_s depends on neither `move` nor the reach, so that a drag that pulls further need not write it
/// anew.
/// @param move largest move asked for of a handle, mean edges, ≥ 0
/// @param mean_edge model units, > 0
[[nodiscard]] EditWeights edit_weights(const HandleEditOptions& options, double move,
                                       double mean_edge);

}  // namespace planish
