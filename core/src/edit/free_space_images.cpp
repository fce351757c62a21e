// SPDX-License-Identifier: MIT
#include "edit/free_space_images.hpp"

#include <algorithm>
#include <utility>

namespace planish {
namespace {

/// Whether two boxes are one, whichever of their halves is named first.
bool is_same_box(const KeptBox& a, const KeptBox& b) {
  constexpr double kSame = 1e-12;
  const double size = a.centre.cwiseAbs().maxCoeff() + a.halves.cwiseAbs().maxCoeff();
  if ((a.centre - b.centre).norm() > kSame * size) return false;
  for (int i = 0; i < 3; ++i) {
    bool found = false;
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d one = a.halves.col(i), other = b.halves.col(j);
      found = found || std::min((one - other).norm(), (one + other).norm()) <= kSame * size;
    }
    if (!found) return false;
  }
  return true;
}

bool is_same_side(const HalfSpace& a, const HalfSpace& b) {
  constexpr double kSame = 1e-12;
  return (a.normal - b.normal).norm() <= kSame &&
         std::abs(a.bound - b.bound) <= kSame * std::abs(a.bound);
}

}  // namespace

FreeSpace with_images(const FreeSpace& free, const MeshSymmetry& symmetry) {
  FreeSpace all;
  all.apart = free.apart;
  all.wall_clearance = free.wall_clearance;
  const auto add = [](auto& list, const auto& image, const auto& is_same) {
    const bool known =
        std::any_of(list.begin(), list.end(), [&](const auto& one) { return is_same(one, image); });
    if (!known) list.push_back(image);
  };
  for (std::size_t k = 0; k < symmetry.operations.size(); ++k) {
    const Eigen::Matrix3d& turn = symmetry.operations[k].turn;
    for (const HalfSpace& side : free.sides) {
      const Eigen::Vector3d normal = turn * side.normal;
      const double shift = (normal - side.normal).dot(symmetry.centre);
      add(all.sides, HalfSpace{normal, side.bound + shift}, is_same_side);
    }
    for (const Positions& wall : free.walls) {
      Positions image = wall;
      for (auto corner : image.colwise()) corner = symmetry.moved(k, corner);
      all.walls.push_back(std::move(image));
    }
    for (const KeptBox& box : free.boxes) {
      const KeptBox image{symmetry.moved(k, box.centre), turn * box.halves, box.clearance};
      add(all.boxes, image, is_same_box);
    }
  }
  return all;
}

}  // namespace planish
