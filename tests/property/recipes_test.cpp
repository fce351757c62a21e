// SPDX-License-Identifier: MIT
/// Every recipe in docs/scenes gives its recorded result again, up to rounding: by any compiler.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "planish/design.hpp"
#include "planish/design_text.hpp"

namespace planish {
namespace {

std::vector<std::string> recipes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(PLANISH_SCENES)) {
    const std::string name = entry.path().stem().string();
    if (name.rfind("figure-", 0) == 0) names.push_back(name);
  }
  return names;
}

std::string text_of(const std::string& name) {
  std::ifstream file(std::string(PLANISH_SCENES) + "/" + name + ".json");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Recipes, AllGiveTheirRecordedResultUpToRounding) {
  const std::vector<std::string> names = recipes();
  EXPECT_EQ(names.size(), 30u);
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const auto design = read_design(text_of(name));
    ASSERT_TRUE(std::holds_alternative<Design>(design)) << std::get<std::string>(design);
    const auto replayed = replay(std::get<Design>(design));
    ASSERT_TRUE(std::holds_alternative<Replay>(replayed)) << std::get<std::string>(replayed);
    const Replay& result = std::get<Replay>(replayed);
    EXPECT_TRUE(result.agrees) << "by " << result.deviation;
    EXPECT_EQ(result.mark.moved, std::get<Design>(design).result->moved);
  }
}

}  // namespace
}  // namespace planish
