// SPDX-License-Identifier: MIT
// Where an edit does not go: a hard handle that stops short, joints that slide far.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/cli.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;

/// A script that asked for exactly there must not take what stops short for it.
TEST_F(Cli, AHardHandleThatStopsShortIsAnErrorAndASentence) {
  const std::string edit = "edit sample:vault:8 --handle 36+=0,0,0.2 --hard --report r.json ";
  EXPECT_EQ(run(edit), 0) << err();
  EXPECT_EQ(err().find("handle 36 stops"), std::string::npos) << err();
  // 10 % short, which is no word without --hard.
  const std::string stopped = "edit sample:vault:8 --handle 36+=0,0,0.2 --keep-out above=";
  ASSERT_EQ(run("edit sample:vault:8 --handle 36+=0,0,0.18 --hard -o e.obj"), 0) << err();
  const std::string height = std::to_string(load("e.obj").positions(2, 36));
  EXPECT_EQ(run(stopped + height + " --attraction 100000 -o f.obj"), 0) << err();
  EXPECT_EQ(err().find("handle 36 stops"), std::string::npos) << err();
  EXPECT_EQ(run(stopped + height + " --hard -o f.obj"), 4) << err();
  EXPECT_NE(err().find("short of "), std::string::npos) << err();
  EXPECT_EQ(
      run("explore sample:vault:8 --handle 36+=0,0,0.2 --dimension 2 --hard --keep-out above=" +
          height + " -o f.obj"),
      4)
      << err();
  EXPECT_NE(err().find("short of "), std::string::npos) << err();
}

TEST_F(Cli, KeepsTheLimitOnSlidesAndSaysWhichTargetIsBeyondIt) {
  const std::string edit =
      "edit sample:vault:12 --handle 66+=0.8,0,0.2 --bound slide=0.2 --report r.json ";
  const auto report = [&] { return nlohmann::json::parse(contents(directory_ / "r.json")); };
  for (const std::string how : {"", "--hard "}) {
    ASSERT_EQ(run(edit + how + "--design d.json"), how.empty() ? 0 : 4) << err();
    EXPECT_NE(err().find("joints slide along it by up to 0.2 (units"), std::string::npos) << err();
    EXPECT_NE(err().find("the target of handle 66 is "), std::string::npos) << err();
    EXPECT_NE(err().find("where --bound slide=0.2 stops it"), std::string::npos) << err();
    EXPECT_LE(report()["motion"]["slide_max"].get<double>(), 0.2 * (1.0 + 1e-6));
    EXPECT_EQ(report()["bounds"][0]["name"], "slide");
    ASSERT_EQ(run("replay d.json --report again.json"), 0) << err();
    EXPECT_EQ(nlohmann::json::parse(contents(directory_ / "again.json"))["verified"], true);
  }
  ASSERT_EQ(run("edit sample:vault:12 --handle 66+=0,0,0.2 --bound slide=0.2 --report r.json"), 0);
  EXPECT_EQ(err().find("the target of handle"), std::string::npos) << err();
}

TEST_F(Cli, SaysHowFarJointsSlideWhereThatIsFar) {
  const std::string edit = "edit sample:vault:12 --handle 66+=0,0,0.3 --report r.json ";
  ASSERT_EQ(run(edit + "--keep-boundary --softness 5 --reach 6 --hard"), 0) << err();
  const auto motion = nlohmann::json::parse(contents(directory_ / "r.json"))["motion"];
  ASSERT_GT(motion["slide_max"].get<double>(), 0.5 * motion["shape_max"].get<double>());
  EXPECT_NE(err().find("the surface moves by up to 0.3"), std::string::npos) << err();
  EXPECT_NE(err().find("--bound slide=MAX limits it"), std::string::npos) << err();
  ASSERT_EQ(run("edit sample:vault:9 --handle 40+=0,0,0.3 --report r.json"), 0) << err();
  const auto still = nlohmann::json::parse(contents(directory_ / "r.json"))["motion"];
  ASSERT_LE(still["slide_max"].get<double>(), 0.5 * still["shape_max"].get<double>());
  EXPECT_EQ(err().find("joints slide"), std::string::npos) << err();
}

/// What cannot help is not advised.
TEST_F(Cli, AHandleThatStopsShortIsToldWhatHoldsIt) {
  const std::string edit = "edit sample:vault:8 --handle 36+=0,0,0.5 --report r.json ";
  ASSERT_EQ(run(edit + "--keep-out above=1"), 0) << err();
  EXPECT_NE(err().find("its target is beyond --keep-out above=1, as it is itself"),
            std::string::npos)
      << err();
  EXPECT_EQ(err().find("--attraction"), std::string::npos) << err();
  ASSERT_EQ(run(edit + "--keep-out above=1 --hard"), 4) << err();
  EXPECT_NE(err().find("handle 36: its target is beyond --keep-out above=1"), std::string::npos);
  ASSERT_EQ(run(edit + "--reach 6mm"), 0) << err();
  EXPECT_NE(err().find("no point around it may follow; some may with a wider --reach\n"),
            std::string::npos)
      << err();
  ASSERT_EQ(run(edit + "--keep-out above=90 --attraction 2"), 0) << err();
  EXPECT_NE(err().find("--attraction pulls harder"), std::string::npos) << err();
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
