// SPDX-License-Identifier: MIT
/// Recipes in docs/scenes give their recorded result again (all of them every night, and at every
/// commit in WebAssembly: tests/web/figures.test.ts): by the compiler that recorded it up to
/// rounding, and so does a certified edit by any other. Variations and the reference engine have
/// no certificate yet: another compiler ends up to a hundredth of an edge away.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "planish/design/design.hpp"
#include "planish/design/design_text.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

std::vector<std::string> recipes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(testing::in_tree("docs/scenes"))) {
    const std::string name = entry.path().stem().string();
    if (name.rfind("figure-", 0) == 0) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// One of each kind: edits of each mesh, variations made exact, the paper's engine; all every
/// night.
std::vector<std::string> replayed() {
  if (testing::is_night()) return recipes();
  return {"figure-2-l2", "figure-4-t3", "figure-7", "figure-8-a", "figure-9-a"};
}

std::string text_of(const std::string& name) {
  std::ifstream file(testing::in_tree("docs/scenes/" + name + ".json"));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Whether another compiler must agree up to rounding.
bool is_certified(const Design& design) {
  return design.variations.empty() && design.options.engine == Engine::kNewton;
}

#ifdef __EMSCRIPTEN__
constexpr bool kRecordedHere = false;
#else
constexpr bool kRecordedHere = true;
#endif

TEST(Recipes, AreThirty) { EXPECT_EQ(recipes().size(), 30u); }

class RecordedRecipes : public ::testing::TestWithParam<std::string> {};

TEST_P(RecordedRecipes, GiveTheirRecordedResult) {
  constexpr double kNear = 0.01;  // of the mean edge
  const auto design = read_design(text_of(GetParam()));
  ASSERT_TRUE(std::holds_alternative<Design>(design)) << std::get<std::string>(design);
  const auto replayed = replay(std::get<Design>(design));
  ASSERT_TRUE(std::holds_alternative<Replay>(replayed)) << std::get<std::string>(replayed);
  const Replay& result = std::get<Replay>(replayed);
  if (kRecordedHere || is_certified(std::get<Design>(design))) {
    EXPECT_TRUE(result.agrees) << "by " << result.deviation;
    EXPECT_EQ(result.mark.moved, std::get<Design>(design).result->moved);
  } else {
    EXPECT_LE(result.deviation, kNear * mean_edge_length(result.base));
  }
  if (std::get<Design>(design).options.keep_shape) {
    EXPECT_EQ(testing::spoilt_count(result.base, result.shape), 0)
        << "a figure of what the product makes";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RecordedRecipes, ::testing::ValuesIn(replayed()));

}  // namespace
}  // namespace planish
