// SPDX-License-Identifier: MIT
// What `planish edit --fair` finds, tells, refuses, and hands to a design.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/cli.hpp"

namespace planish {
namespace {

using nlohmann::json;
using testing::Cli;
using testing::contents;

const std::string kFairEdit =
    "edit sample:vault:13 --handle 84+=0,0,0.7 --softness 5 --reach 4 --keep-boundary -o a.obj "
    "--report a.json --design d.json ";

class CliFair : public Cli {
 protected:
  json report() { return json::parse(contents(directory_ / "a.json")); }
  json bounds() {
    return json::parse(contents(directory_ / "d.json"))["options"].value("bounds", json::array());
  }
};

TEST_F(CliFair, LimitsFoldsWhereItCostsNothingAndTheDesignReplays) {
  ASSERT_EQ(run(kFairEdit), 0) << err();
  const json free = report();
  ASSERT_GT(free["sharpest_fold"]["growth"], 15.0) << "else this tests nothing";
  EXPECT_FALSE(free.contains("fair"));
  ASSERT_EQ(run(kFairEdit + "--fair"), 0) << err();
  const json fair = report();
  ASSERT_FALSE(fair["fair"]["bounds"].empty());
  EXPECT_EQ(fair["fair"]["bounds"], bounds());
  const std::string fold = fair["fair"]["bounds"][0];
  EXPECT_NE(err().find("--fair: --bound " + fold), std::string::npos) << err();
  ASSERT_TRUE(fold.starts_with("fold=+")) << fold;
  EXPECT_LE(fair["sharpest_fold"]["growth"].get<double>(), std::stod(fold.substr(6)) + 0.01);
  EXPECT_LE(fair["handle_error"].get<double>(), free["handle_error"].get<double>() + 0.05 * 0.7);
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(CliFair, LeavesAGentleEditAndStatedLimitsAsTheyAre) {
  const std::string gentle =
      "edit sample:vault:13 --handle 84+=0,0,0.1 --softness 5 --reach 4 --keep-boundary "
      "--report a.json --design d.json -o ";
  ASSERT_EQ(run(gentle + "b.obj"), 0) << err();
  ASSERT_EQ(run(gentle + "a.obj --fair"), 0) << err();
  EXPECT_EQ(report()["fair"]["bounds"], json::array());
  EXPECT_EQ(bounds(), json::array());
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
  ASSERT_EQ(run(kFairEdit + "--fair --bound fold=+70 --bound angle=1:179"), 0) << err();
  EXPECT_EQ(report()["fair"]["bounds"], json::array());
  EXPECT_EQ(bounds(), json({"fold=+70", "angle=1:179"}));
}

TEST_F(CliFair, GoesWithASymmetryAndWithoutOtherSearches) {
  ASSERT_EQ(run(kFairEdit + "--fair --symmetry x"), 0) << err();
  EXPECT_FALSE(report()["fair"]["bounds"].empty());
  EXPECT_LT(report()["symmetry"]["asymmetry_mean_edges"], 1e-9);
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
  EXPECT_EQ(run(kFairEdit + "--fair --fewest panels"), 2);
  EXPECT_NE(err().find("--fair: it knows no --fewest"), std::string::npos) << err();
  EXPECT_EQ(run(kFairEdit + "--fair --split-where-needed 2"), 2);
}

}  // namespace
}  // namespace planish
#endif
