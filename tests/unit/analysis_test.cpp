// SPDX-License-Identifier: MIT
#include "analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "planish/measures/panel_health.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr int kPulled = 8 * 17 + 8;

struct EditedVault {
  Mesh mesh = testing::sample("vault", 17);
  EditTargets targets = testing::pull(mesh, kPulled, {0.0, 0.0, 0.5});
  HandleEditResult result = solve_handle_edit(mesh, targets);
  Analysis analysis{mesh};

  EditedVault() { analysis.show(result.moved, result.moved_positions); }
  [[nodiscard]] bool moved(int v) const {
    return std::binary_search(result.moved.begin(), result.moved.end(), v);
  }
};

TEST(Analysis, SaysWhichPanelsMustBeMadeAgain) {
  const EditedVault vault;
  const std::vector<float> health = vault.analysis.panel_health();
  ASSERT_EQ(health.size(), 4 * static_cast<std::size_t>(vault.mesh.face_count()));
  int bevels = 0;
  for (int f = 0; f < vault.mesh.face_count(); ++f) {
    const auto face = vault.mesh.face(f);
    const bool changed =
        std::any_of(face.begin(), face.end(), [&](int v) { return vault.moved(v); });
    const float change = health[4 * static_cast<std::size_t>(f) + 3];
    EXPECT_EQ(change == 1.0F, changed) << f;
    bevels += change == 2.0F ? 1 : 0;
  }
  EXPECT_GT(bevels, 0);
}

TEST(Analysis, SaysHowFarPanelsAndNodesAreFromAKind) {
  const Mesh dome = testing::sample("dome", 9);
  Analysis analysis(dome);
  const std::vector<float> circular = analysis.defects("circular");
  ASSERT_EQ(circular.size(), static_cast<std::size_t>(dome.face_count()));
  EXPECT_LE(*std::max_element(circular.begin(), circular.end()), 1e-9F);
  EXPECT_TRUE(analysis.defects("round").empty());
  // One corner of one panel, moved in its plane: that panel alone, on the mesh's corner, misses it.
  const Eigen::Vector3d inwards = dome.positions.col(dome.face(0)[2]) - dome.positions.col(0);
  const Positions moved = dome.positions.col(0) + 0.1 * inwards;
  analysis.show({0}, moved);
  const std::vector<float> missed = analysis.defects("circular");
  EXPECT_GT(missed[0], 1.0F);
  EXPECT_EQ(std::count_if(missed.begin(), missed.end(), [](float d) { return d > 1e-6F; }), 1);
  const std::vector<float> conical = analysis.defects("conical");
  ASSERT_EQ(conical.size(), static_cast<std::size_t>(dome.vertex_count()));
  EXPECT_EQ(conical[0], -1.0F) << "not a node of valence 4 inside";
}

TEST(Analysis, TellsDamageByTheEditFromDamageByPlanarising) {
  const Mesh base = testing::sample("vault", 9);
  constexpr int kCentre = 40, kFace = 0;
  Positions opened = base.positions;
  Analysis planarised(base, opened);
  EXPECT_EQ(planarised.panel_damage(), std::vector<unsigned char>(64, 0));
  // A point pushed across the opposite corners of its panels damages panels around it only.
  const Eigen::Vector3d push = 2.0 * (opened.col(kCentre + 1) - opened.col(kCentre));
  planarised.show({kCentre}, opened.col(kCentre) + push);
  const std::vector<unsigned char> damage = planarised.panel_damage();
  for (int f = 0; f < base.face_count(); ++f) {
    const auto face = base.face(f);
    const bool at_the_point = std::find(face.begin(), face.end(), kCentre) != face.end();
    if (!at_the_point) {
      EXPECT_EQ(damage[static_cast<std::size_t>(f)], 0) << f;
    }
  }
  EXPECT_GT(std::count_if(damage.begin(), damage.end(), [](int d) { return d > 0; }), 1);
  // The file had the first panel the other way round: planarising turned it over.
  const auto first = base.face(kFace);
  opened.col(first[0]).swap(opened.col(first[2]));
  const Analysis turned(base, opened);
  EXPECT_EQ(turned.panel_damage()[0], static_cast<unsigned char>(PanelDamage::kTurnedOver));
}

TEST(Analysis, FarFromTheEditNothingBends) {
  const EditedVault vault;
  const std::vector<float> bends = vault.analysis.vertex_bending(FairnessKind::kSecondDifference);
  ASSERT_EQ(bends.size(), static_cast<std::size_t>(vault.mesh.vertex_count()));
  EXPECT_GT(*std::max_element(bends.begin(), bends.end()), 0.0F);
  EXPECT_EQ(bends.front(), 0.0F);
  EXPECT_EQ(bends.back(), 0.0F);
}

TEST(Analysis, CountsWhatTheEditLeavesFree) {
  const EditedVault vault;
  const auto found = vault.analysis.freedom(vault.targets);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->points, static_cast<int>(vault.result.moved.size()));
  EXPECT_EQ(found->freedom(), 3 * found->points - found->rank);
  EXPECT_LE(found->rank, found->equations);
}

TEST(Analysis, NamesThePanelsAtAHandleThatIsHeld) {
  const Mesh mesh = testing::sample("vault", 17);
  EditTargets targets = testing::pull(mesh, kPulled, {0.0, 0.0, 0.5});
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (v != kPulled) targets.pins.push_back(v);
  }
  const Analysis analysis(mesh);
  const auto found = analysis.freedom(targets);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->freedom(), 0);
  EXPECT_NEAR(found->borne, 1.0, 1e-9);
  std::set<int> around;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (std::find(face.begin(), face.end(), kPulled) != face.end()) around.insert(f);
  }
  ASSERT_FALSE(found->holding.empty());
  for (const HoldingPanel& panel : found->holding) {
    EXPECT_TRUE(around.contains(panel.face)) << panel.face;
  }
}

}  // namespace
}  // namespace planish
