// SPDX-License-Identifier: MIT
/// Sessions with a mesh open, and what is asked of them.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "session.hpp"

namespace planish::testing {

inline Session open_vault() {
  Session session;
  EXPECT_EQ(session.open_sample("vault", 17), std::nullopt);
  return session;
}

/// The middle of the 17 × 17 vault, raised.
inline EditTargets lift(const Session& session, double height) {
  constexpr int kMiddle = 8 * 17 + 8;
  Eigen::Vector3d target = session.base().positions.col(kMiddle);
  target.z() += height;
  return {.handles = {{kMiddle, target}}, .pins = {}};
}

/// A wide panel that is far out of flat in millimetres, a small one that is so in mm/m.
inline constexpr std::string_view kWideAndSmall =
    "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 1\nf 1 2 3 4\n"
    "v 30 0 0\nv 31 0 0\nv 31 1 0\nv 30 1 0.2\nf 5 6 7 8\n";

/// How far the base is from circular panels.
inline KindSpread circular_of(const Session& session) {
  for (const KindSpread& spread : session.mesh_report().kinds) {
    if (spread.kind == "circular") return spread;
  }
  ADD_FAILURE() << "no panel of this mesh could miss its circle";
  return {};
}

}  // namespace planish::testing
