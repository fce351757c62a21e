// SPDX-License-Identifier: MIT
#include "constraints/face_across.hpp"

#include <optional>
#include <span>

namespace planish {
namespace {

/// Whether `face` has a side between a and b, and which way it runs.
std::optional<bool> side_of(std::span<const int> face, int a, int b) {
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int from = face[k], to = face[(k + 1) % face.size()];
    if (from == a && to == b) return true;
    if (from == b && to == a) return false;
  }
  return std::nullopt;
}

}  // namespace

FaceAcross face_across(const LimitBase& base, int face, int a, int b) {
  FaceAcross found;
  for (const int f : base.adjacency.faces[a]) {
    if (f == face) continue;
    const auto forward = side_of(base.mesh.face(f), a, b);
    if (!forward) continue;
    if (found.face >= 0) return {};
    found = {f, *forward};
  }
  return found;
}

}  // namespace planish
