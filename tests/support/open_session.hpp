// SPDX-License-Identifier: MIT
/// Sessions with a mesh open, and what is asked of them.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "session.hpp"

namespace planish::testing {

/// Points along one side of the meshes that sessions open.
inline constexpr int kSide = 13;

inline Session open_vault() {
  Session session;
  EXPECT_EQ(session.open_sample("vault", kSide), std::nullopt);
  return session;
}

/// The middle of a square mesh, raised.
inline EditTargets lift(const Session& session, double height) {
  constexpr int kMiddle = kSide / 2 * (kSide + 1);
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
