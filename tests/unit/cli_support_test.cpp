// SPDX-License-Identifier: MIT
// Supports of an edit: kept, reported, replayed, refused.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/cli.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;

TEST_F(Cli, SupportsAreKeptReportedAndReplayed) {
  const auto read = [&](const std::string& name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  const std::string edit = "edit sample:vault:12 --handle 66+=0.2,0,0.6 --report r.json ";
  ASSERT_EQ(run(edit + "--support outline:boundary --support level=x:65,67 -o edited.glb "
                       "--design d.json"),
            0)
      << err();
  const auto supports = read("r.json")["supports"];
  ASSERT_EQ(supports.size(), 2u);
  EXPECT_EQ(supports[0]["name"], "outline:boundary");
  EXPECT_LE(supports[0]["distance_max"].get<double>(), 1e-9);
  EXPECT_EQ(supports[1], (nlohmann::json{{"name", "level=x:65,67"}, {"distance_max", 0.0}}));
  EXPECT_EQ(read("d.json")["supports"], (nlohmann::json{"outline:boundary", "level=x:65,67"}));
  for (const std::string design : {"d.json", "edited.glb"}) {
    ASSERT_EQ(run("replay " + design + " --report again.json"), 0) << err();
    EXPECT_EQ(read("again.json")["verified"], true);
    EXPECT_EQ(read("again.json")["supports"], supports);
    EXPECT_EQ(read("again.json")["spoilt_faces"], read("r.json")["spoilt_faces"]);
  }
}

TEST_F(Cli, AHandleThatStopsShortSaysWhatHoldsIt) {
  ASSERT_EQ(run("edit sample:vault:12 --handle 6+=0,0,0.6 --support level:boundary -o b.obj"), 0)
      << err();
  EXPECT_NE(err().find("handle 6 stops 0.6 short of its target (units of the mesh): it stands on "
                       "level=z:boundary"),
            std::string::npos)
      << err();
  ASSERT_EQ(run("edit sample:vault:12 --handle 66+=0,0,0.6 --attraction 1e6 -o b.obj"), 0);
  EXPECT_EQ(err().find("stops"), std::string::npos) << err();
}

TEST_F(Cli, PlanarisingFirstSaysWhatItDidToSupports) {
  ASSERT_EQ(run("sample dome --size 10 -o a.obj"), 0);
  Mesh bent = load("a.obj");
  bent.positions(2, 5) += 0.05;
  save("bent.obj", write_mesh(bent, MeshFormat::kObj));
  const std::string edit =
      " --handle 55+=0,0,0.2 --attraction 1e4 --support level:boundary -o b.obj";
  ASSERT_EQ(run("edit bent.obj" + edit), 0) << err();
  EXPECT_NE(err().find("bent.obj: that moved points of level=z:boundary by up to "),
            std::string::npos)
      << err();
  ASSERT_EQ(run("project bent.obj --support level:boundary -o flat.obj"), 0) << err();
  ASSERT_EQ(run("edit flat.obj" + edit), 0) << err();
  EXPECT_EQ(err().find("moved points"), std::string::npos) << err();
}

TEST_F(Cli, VariationsMovePointsAlongTheirSupports) {
  const std::string explore =
      "explore sample:vault:12 --handle 66+=0,0,0.6 --support level=x:65,67 --dimension 2 --exact "
      "--coefficients ";
  ASSERT_EQ(run(explore + "0,0 -o edit.obj"), 0) << err();
  ASSERT_EQ(run(explore + "0.3,0.2 -o variation.obj --design d.json"), 0) << err();
  const auto points = [&](const std::string& name) {
    std::istringstream text(contents(directory_ / name));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("v ")) lines.push_back(line);
    }
    return lines;
  };
  const auto edit = points("edit.obj"), variation = points("variation.obj");
  ASSERT_EQ(edit.size(), 144u);
  EXPECT_NE(edit, variation);
  const auto x_of = [](const std::string& line) { return line.substr(0, line.find(' ', 2)); };
  for (const std::size_t v : {65u, 67u}) {
    EXPECT_NE(edit[v], variation[v]) << "along its level";
    EXPECT_EQ(x_of(edit[v]), x_of(variation[v]));
  }
  ASSERT_EQ(run("replay d.json --report again.json"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(contents(directory_ / "again.json"))["verified"], true);
}

TEST_F(Cli, MakingFlatKeepsSupports) {
  ASSERT_EQ(run("sample vault --size 9 -o flat.obj"), 0) << err();
  std::istringstream text(contents(directory_ / "flat.obj"));
  std::ofstream bent(directory_ / "bent.obj");
  int point = 0;
  for (std::string line; std::getline(text, line);) {
    const bool moved = line.starts_with("v ") && ++point % 3 == 0;
    bent << (moved ? "v " + line.substr(2, line.rfind(' ') - 2) + " 1.25" : line) << "\n";
  }
  bent.close();
  ASSERT_EQ(run("project bent.obj --bound shape=off --support outline:boundary -o on.obj "
                "--report r.json"),
            0)
      << err();
  const auto report = nlohmann::json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["supports"][0]["name"], "outline:boundary");
  EXPECT_LE(report["supports"][0]["distance_max"].get<double>(), 1e-9);
  EXPECT_GT(report["max_move"].get<double>(), 0.0);
  EXPECT_EQ(run("project bent.obj --support spring=3:4"), 2);
  EXPECT_NE(err().find("springs are for edits"), std::string::npos) << err();
  EXPECT_EQ(run("project bent.obj --support plane=0,0,1,99:boundary"), 2);
  EXPECT_NE(err().find("away from it"), std::string::npos) << err();
  EXPECT_EQ(run("project bent.obj --support level:boundary --solver alm"), 2);
  EXPECT_NE(err().find("supports: the engine alm knows none; they need newton"), std::string::npos)
      << err();
}

TEST_F(Cli, ASupportThatIsNoneIsRefused) {
  const std::string edit = "edit sample:vault:12 --handle 66+=0,0,0.3 --support ";
  EXPECT_EQ(run(edit + "roof:boundary"), 2);
  EXPECT_NE(err().find("\"roof:boundary\" is none of level:POINTS"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "plane=0,0,1,99:boundary"), 2);
  EXPECT_NE(err().find("away from it"), std::string::npos) << err();
  EXPECT_EQ(run(edit + "level:boundary --solver alm"), 2);
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
