// SPDX-License-Identifier: MIT
/// The other face of an edge.
#pragma once

#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct FaceAcross {
  int face = -1;         ///< −1: none, or more than one
  bool forward = false;  ///< its side runs from a to b
};

/// The one other face that shares the side between a and b of `face`.
[[nodiscard]] FaceAcross face_across(const LimitBase& base, int face, int a, int b);

}  // namespace planish
