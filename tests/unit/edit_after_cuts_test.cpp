// SPDX-License-Identifier: MIT
/// A cut near a handle gives neighbours straight corners, and an edit that arrives and is cheap
/// without them is so with them. [SHP-4]
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

SolveReport edit_of(const Mesh& mesh, int vertex) {
  HandleEditOptions options;
  options.attraction = 1e4;
  options.softness = 3.0;
  options.reach = 6;
  options.keep_boundary = true;
  HandleEditSolver solver(mesh, options);
  return solver.solve(testing::pull(mesh, vertex, {0.0, 0.0, 0.8})).report;
}

Mesh mesh_after(const Mesh& mesh, const Cut& cut) {
  auto made = cut_mesh(mesh, {cut});
  return std::get<CutMesh>(std::move(made)).mesh;
}

class EditAfterACut : public ::testing::TestWithParam<int> {};

TEST_P(EditAfterACut, ArrivesAndCostsNoMoreThanTwice) {
  const Mesh mesh = testing::sample("vault", 16);
  const int handle = GetParam();
  const Adjacency adjacency = build_adjacency(mesh);
  const auto panels = adjacency.faces[handle];
  const int panel = *std::min_element(panels.begin(), panels.end());
  const auto corners = mesh.face(panel);
  const auto place = std::find(corners.begin(), corners.end(), handle) - corners.begin();
  const int opposite = corners[static_cast<std::size_t>(place + 2) % corners.size()];
  const SolveReport before = edit_of(mesh, handle);
  ASSERT_EQ(before.status, SolveStatus::kConverged);
  for (const Cut& cut : {Cut{CornerCut{panel, opposite, 0.5}}, Cut{RefineCut{{panel}}}}) {
    const SolveReport report = edit_of(mesh_after(mesh, cut), handle);
    EXPECT_EQ(report.status, SolveStatus::kConverged);
    EXPECT_LE(report.cost.factorizations, 2 * before.cost.factorizations);
  }
}

INSTANTIATE_TEST_SUITE_P(Handles, EditAfterACut, ::testing::Values(87, 104, 117, 120));

}  // namespace
}  // namespace planish
