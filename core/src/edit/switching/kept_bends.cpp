// SPDX-License-Identifier: MIT
#include "edit/switching/kept_bends.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace planish {

bool KeptBends::clamp(const ExactDesign& design) {
  constexpr double kMargin = 2e-3;  // so that the size of a panel may change once more
  bool changed = false;
  Positions corners;
  std::vector<int> order;
  for (const int f : design.faces) {
    const double bend = model_.bend(f);
    if (bend == 0.0) continue;
    const std::span<const int> face = model_.face(f);
    corners = model_.mesh.positions(Eigen::all, std::vector<int>(face.begin(), face.end()));
    order.resize(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      order[k] = static_cast<int>(k);
      const auto moved = std::lower_bound(design.vertices.begin(), design.vertices.end(), face[k]);
      if (moved == design.vertices.end() || *moved != face[k]) continue;
      corners.col(order[k]) = design.positions.col(moved - design.vertices.begin());
    }
    const double now = violation_of<PlanarPolygon>(corners, order).excess;
    if (!(now > bend + 0.5 * PlanarPolygon::kTolerance)) continue;
    model_.ease_bend(f, (1.0 - kMargin) * bend / now);
    changed = true;
  }
  return changed;
}

}  // namespace planish
