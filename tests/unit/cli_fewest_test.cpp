// SPDX-License-Identifier: MIT
// What `planish edit --fewest` reports, refuses, and hands to a design.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/cli.hpp"

namespace planish {
namespace {

using nlohmann::json;
using testing::Cli;
using testing::contents;

const std::string kEdit =
    "edit sample:vault:9 --handle 40+=0,0,0.3 --softness 5 --reach 4 --keep-boundary "
    "--bound fold=+15 ";

TEST_F(Cli, FewestReportsWhatItSavedAndTheDesignReplays) {
  ASSERT_EQ(run(kEdit + "--fewest panels -o a.obj --report a.json --design d.json"), 0) << err();
  EXPECT_NE(err().find(" cut again in place of "), std::string::npos) << err();
  const json report = json::parse(contents(directory_ / "a.json"));
  const json& fewest = report["fewest"];
  EXPECT_EQ(fewest["of"], "panels");
  EXPECT_EQ(fewest["panels"], report["remake"]["outline"]);
  EXPECT_EQ(fewest["points"], report["moved_vertices"]);
  EXPECT_LT(fewest["panels"], fewest["panels_before"]);
  EXPECT_EQ(fewest["reached"], true);
  EXPECT_EQ(fewest["minimal"], true);
  EXPECT_EQ(json::parse(contents(directory_ / "d.json"))["pins"].size(), fewest["held"]);
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, FewestKeepsPanelsThatCanBeBuilt) {
  const std::string edit =
      "edit sample:vault:9 --handle 40+=0,0,0.3 --softness 5 --reach 3 --keep-boundary "
      "--bound fold=+15 --fewest panels --report a.json --design d.json -o a.obj ";
  ASSERT_EQ(run(edit), 0) << err();
  const json bounds = json::parse(contents(directory_ / "d.json"))["options"]["bounds"];
  ASSERT_EQ(bounds.size(), 3U) << bounds;
  EXPECT_EQ(bounds[1], "angle=20:170");
  EXPECT_EQ(bounds[2].get<std::string>().rfind("edge=", 0), 0U) << bounds;
  const json built = json::parse(contents(directory_ / "a.json"))["fewest"];
  EXPECT_EQ(built["slivers"], json::array());
  EXPECT_EQ(built["reached"], true);
  EXPECT_EQ(err().find("sliver"), std::string::npos) << err();
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
  // What someone states is the limit; slivers are said.
  ASSERT_EQ(run(edit + "--bound angle=0.1:179.9 --bound edge=0.001:9"), 0) << err();
  const json free = json::parse(contents(directory_ / "a.json"))["fewest"];
  EXPECT_EQ(json::parse(contents(directory_ / "d.json"))["options"]["bounds"].size(), 3U);
  const bool said = err().find("became") != std::string::npos;
  EXPECT_EQ(said, !free["slivers"].empty()) << err();
}

TEST_F(Cli, FewestHoldsPointsWithTheirImagesUnderASymmetry) {
  ASSERT_EQ(run(kEdit + "--fewest panels --symmetry x -o a.obj --report a.json --design d.json"), 0)
      << err();
  const json report = json::parse(contents(directory_ / "a.json"));
  const json& fewest = report["fewest"];
  EXPECT_EQ(report["symmetry"]["images"], 2);
  EXPECT_LT(report["symmetry"]["asymmetry_mean_edges"], 1e-10);
  EXPECT_EQ(fewest["panels"], report["remake"]["outline"]);
  EXPECT_LT(fewest["panels"], 0.5 * fewest["panels_before"].get<int>());
  EXPECT_EQ(fewest["reached"], true);
  EXPECT_EQ(fewest["minimal"], true);
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, FewestStopsAtSoManyPanelsAndFoldsMoreGently) {
  const std::string edit = kEdit.substr(0, kEdit.find("--bound")) + "--report r.json -o a.obj ";
  const auto report = [&] { return json::parse(contents(directory_ / "r.json")); };
  ASSERT_EQ(run(edit + "--fewest panels"), 0) << err();
  const json fewest = report();
  EXPECT_EQ(fewest["fewest"]["most_panels"], json());
  const int before = fewest["fewest"]["panels_before"], least = fewest["fewest"]["panels"];
  const int most = (before + least) / 2;
  ASSERT_EQ(run(edit + "--design d.json --fewest " + std::to_string(most)), 0) << err();
  const json few = report();
  EXPECT_EQ(few["fewest"]["most_panels"], most);
  EXPECT_EQ(few["fewest"]["panels"], few["remake"]["outline"]);
  EXPECT_LE(few["fewest"]["panels"], most);
  EXPECT_GT(few["fewest"]["panels"], least);
  EXPECT_LT(few["fewest"]["solves"], fewest["fewest"]["solves"]);
  EXPECT_LT(few["sharpest_fold"]["growth"], fewest["sharpest_fold"]["growth"]);
  EXPECT_EQ(err().find("stopped after"), std::string::npos) << err();
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
  // Fewer than can be had: those that can, and a word.
  EXPECT_EQ(run(edit + "--fewest 1"), 4) << err();
  EXPECT_NE(err().find(", not the 1 that were asked for"), std::string::npos) << err();
  EXPECT_EQ(report()["fewest"]["panels"], least);
}

TEST_F(Cli, FewestSaysWhereTheHandlesDoNotArriveAnyway) {
  run("edit sample:vault:16 --handle 136+=0,0,9 --reach 2 --fewest panels --report a.json");
  EXPECT_NE(err().find("--fewest: with nothing held a handle stops"), std::string::npos) << err();
  const json fewest = json::parse(contents(directory_ / "a.json"))["fewest"];
  EXPECT_EQ(fewest["reached"], false);
  EXPECT_EQ(fewest["held"], 0);
}

TEST_F(Cli, FewestRefusesInOneSentence) {
  for (const char* words :
       {"--fewest stones", "--within-handle 5%", "--fewest panels --within-handle 5",
        "--fewest panels --within-handle 0%", "--fewest panels --within-handle 150%",
        "--fewest panels --solver alm", "--fewest 0", "--fewest -3", "--fewest 2.5"}) {
    EXPECT_EQ(run(kEdit + words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << words << message;
  }
  EXPECT_EQ(run("edit sample:vault:8 --fewest panels"), 2);
}

}  // namespace
}  // namespace planish

#endif
