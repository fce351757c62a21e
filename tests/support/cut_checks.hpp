// SPDX-License-Identifier: MIT
/// What cuts promise, measured without the product's code.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish::testing {

/// Vertices that panels use, less edges, plus panels.
[[nodiscard]] int euler_characteristic(const Mesh& mesh);

/// The figures that is_valid_cut() compares, the worst of all panels.
struct CutFigures {
  double flatness = 0.0;  ///< of a part: distance from its plane over its panel's size
  double bent = 0.0;      ///< the same, of the panel that was cut
  double area = 0.0;      ///< of all parts of a panel, less that of the panel, over it
};

/// Whether `cut` is what cuts without a trim may make of `mesh`: accepted by check_mesh(), of the
/// same Euler characteristic; points, and panels that no record names, bit-identical, those with
/// straight corners but for these; parts oriented as their panel, as flat as it, and as large
/// together. Raises `figures` to the worst that it finds.
/// @param largest what figures may be, over what the mesh itself is out of flat
[[nodiscard]] ::testing::AssertionResult is_valid_cut(const Mesh& mesh, const CutMesh& cut,
                                                      double largest, CutFigures& figures);

/// Whether two trims along one plane, of what is beyond it and of what is before it, leave `mesh`
/// between them: areas, and Euler characteristics less that of where they meet.
[[nodiscard]] ::testing::AssertionResult are_two_halves(const Mesh& mesh, const CutMesh& before,
                                                        const CutMesh& beyond, double largest,
                                                        CutFigures& figures);

/// Cuts at random places of a mesh, the same for the same seed.
class RandomCuts {
 public:
  explicit RandomCuts(std::uint64_t seed) : state_(seed * 2 + 1) {}

  /// A whole number from 0 to below `count`.
  int below(int count);
  double share() { return 0.05 + 0.9 * below(1 << 20) / double{1 << 20}; }

  SplitCut split(const Mesh& mesh);
  StripCut strip(const Mesh& mesh);  ///< across a side of a quad, where there is one
  CornerCut corner(const Mesh& mesh);
  RefineCut refine(const Mesh& mesh);
  TrimCut trim(const Mesh& mesh);  ///< through the middle of a panel
  /// Any but a trim.
  Cut any(const Mesh& mesh);

 private:
  /// A random panel, rather with `corners` of them (0: with more than three).
  int panel(const Mesh& mesh, std::size_t corners);

  std::uint64_t state_;
};

/// The cut that `text` names; fails the test where it names none.
[[nodiscard]] Cut parsed_cut(const std::string& text);

}  // namespace planish::testing
