// SPDX-License-Identifier: MIT
/// What a session finds by splitting panels: lines that let handles go further, and a flat mesh.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>

#include "planish/mesh/mesh_hash.hpp"
#include "session.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

constexpr int kPulled = 26;
constexpr double kEvened = 1e-6;  ///< mm/m

/// A vault whose boundary stays, and where folds sharpen by little.
Session stiff_vault() {
  Session session;
  EXPECT_EQ(session.open_sample("vault", 12), std::nullopt);
  HandleEditOptions options;
  options.attraction = 1e4;
  options.softness = 3.0;
  options.reach = 2;
  options.keep_boundary = true;
  options.bounds.push_back(*parse_stated_limit("fold=+12"));
  EXPECT_EQ(session.set_options(std::move(options)), std::nullopt);
  return session;
}

EditTargets pull_of(const Session& session) {
  Eigen::Vector3d target = session.base().positions.col(kPulled);
  target.z() += 0.4;
  return {.handles = {{kPulled, target}}, .pins = {}};
}

TEST(SessionSplitting, FindsLinesWhoseEditIsTheOneThatTheyPromise) {
  Session session = stiff_vault();
  const auto found = session.split_where_needed(pull_of(session), {});
  ASSERT_TRUE(std::holds_alternative<SplitEdit>(found));
  const auto& [cuts, mesh, result, curve, reached, solves, cost] = std::get<SplitEdit>(found);
  EXPECT_TRUE(reached);
  EXPECT_GT(cost.factorizations, solves);
  ASSERT_FALSE(cuts.empty());
  EXPECT_TRUE(session.moved().empty());
  std::string lines;
  for (const Cut& cut : cuts) lines.append(lines.empty() ? "" : "\n").append(cut_text(cut));
  ASSERT_EQ(session.set_cuts(lines, kEvened), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.base(), mesh));
  ASSERT_EQ(session.edit(EditMode::kSolve, pull_of(session), 0.0), std::nullopt);
  EXPECT_NEAR(session.shape_report().handle_error, curve.back().handle_error, 1e-12);
  EXPECT_EQ(session.moved_positions(), result.moved_positions);
}

TEST(SessionSplitting, SaysWhereLinesCannotBeLookedFor) {
  Session session = stiff_vault();
  EXPECT_TRUE(std::holds_alternative<std::string>(session.split_where_needed({}, {})));
}

TEST(SessionSplitting, CutsImagesUnderASymmetry) {
  Session session = stiff_vault();
  ASSERT_EQ(session.set_symmetry("x", kEvened), std::nullopt);
  const auto found = session.split_where_needed(pull_of(session), {});
  ASSERT_TRUE(std::holds_alternative<SplitEdit>(found));
  const SplitEdit& split = std::get<SplitEdit>(found);
  ASSERT_FALSE(split.cuts.empty());
  EXPECT_EQ(split.cuts.size(), 2U * static_cast<std::size_t>(split.curve.back().lines));
  std::string lines;
  for (const Cut& cut : split.cuts) lines.append(lines.empty() ? "" : "\n").append(cut_text(cut));
  ASSERT_EQ(session.set_cuts(lines, kEvened), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.base(), split.mesh));
  ASSERT_EQ(session.edit(EditMode::kSolve, pull_of(session), 0.0), std::nullopt);
  EXPECT_EQ(session.moved_positions(), split.result.moved_positions);
}

/// One panel bent by a corner that is its own, between others that are flat.
constexpr std::string_view kBent =
    "v 0 0 0.3\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\n"
    "f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n";

Planarising near_the_file() {
  Planarising how;
  how.fairness_weight = 0.0;
  how.within = 0.01;
  return how;
}

TEST(SessionSplitting, TheBaseIsTheFlatMeshWithPanelsParted) {
  Session session;
  ASSERT_EQ(session.open_file(kBent, "obj"), std::nullopt);
  const Mesh opened = session.base();
  ASSERT_EQ(session.split_until_flat(near_the_file(), 2), std::nullopt);
  EXPECT_EQ(session.hybrid().panels, 1);
  EXPECT_EQ(session.hybrid().failing_faces, 0);
  EXPECT_EQ(session.base().face_count(), 5);
  EXPECT_EQ(session.base().positions, opened.positions);
  EXPECT_LE(session.mesh_report().worst.excess, kEvened);
  EXPECT_EQ(session.before_planarising(), opened.positions);
}

TEST(SessionSplitting, RefusedLeavesTheMeshAsItWas) {
  Session session;
  ASSERT_EQ(session.open_file(kBent, "obj"), std::nullopt);
  const auto hash = mesh_hash(session.base());
  EXPECT_NE(session.split_until_flat(near_the_file(), 0), std::nullopt);
  EXPECT_EQ(mesh_hash(session.base()), hash);
  Session cut = stiff_vault();
  ASSERT_EQ(cut.set_cuts("strip=26-27", kEvened), std::nullopt);
  EXPECT_NE(cut.split_until_flat(near_the_file(), 2), std::nullopt);
}

}  // namespace
}  // namespace planish
