// SPDX-License-Identifier: MIT
// Keep-outs of an edit: kept, reported, replayed, refused.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "planish/io/obj.hpp"
#include "support/cli.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;

TEST_F(Cli, KeepOutsAreKeptReportedAndReplayed) {
  const auto parsed = [&](const std::string& name) {
    return nlohmann::json::parse(contents(directory_ / name));
  };
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  const Positions before = load("v.obj").positions;
  const double top = before(2, 66) + 0.3;
  const std::string out = " --keep-out above=" + std::to_string(top) + " --keep-out below=0.2";
  const std::string edit = "edit v.obj --handle 66+=0.2,0,1 --report r.json" + out;
  ASSERT_EQ(run(edit + " --clearance 0.05 -o edited.glb --design d.json"), 0) << err();
  const Positions after = load("edited.glb").positions;
  EXPECT_LE(after.row(2).maxCoeff(), std::stod(std::to_string(top)) - 0.05 + 1e-9);
  EXPECT_GT(after(2, 66), before(2, 66) + 0.2);
  for (int v = 0; v < after.cols(); ++v) {
    EXPECT_GE(after(2, v), std::min(0.25, before(2, v)) - 1e-9) << v;
  }
  const auto report = parsed("r.json");
  ASSERT_EQ(report["bounds"].size(), 1u);
  EXPECT_EQ(report["bounds"][0]["name"], "keep-out");
  const auto points = report["bounds"][0]["binding"].get<std::vector<int>>();
  EXPECT_NE(std::find(points.begin(), points.end(), 66), points.end());
  EXPECT_EQ(report["status"], "converged");
  for (const std::string design : {"d.json", "edited.glb"}) {
    ASSERT_EQ(run("replay " + design + " --report again.json"), 0) << err();
    EXPECT_EQ(parsed("again.json")["verified"], true);
  }
}

TEST_F(Cli, AMeshThatIsAKeepOutItselfReplaysTheSameBits) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  const std::string edit = "edit v.obj --handle 66+=0.2,0,0.6";
  ASSERT_EQ(run(edit + " --keep-out self --design d.json -o with.obj"), 0) << err();
  ASSERT_EQ(run(edit + " -o without.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "with.obj"), contents(directory_ / "without.obj"));
  EXPECT_NE(contents(directory_ / "d.json").find("\"self\""), std::string::npos);
  ASSERT_EQ(run("replay d.json --report again.json"), 0) << err();
  EXPECT_NE(contents(directory_ / "again.json").find("\"verified\": true"), std::string::npos);
}

TEST_F(Cli, ABoxIsKeptOutOfAndReplayed) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  const Positions before = load("v.obj").positions;
  const double low = before(2, 66) + 0.35;
  const std::string box = std::to_string(before(0, 66) - 0.3) + "," +
                          std::to_string(before(1, 66) - 0.3) + "," + std::to_string(low) + "," +
                          std::to_string(before(0, 66) + 0.3) + "," +
                          std::to_string(before(1, 66) + 0.3) + "," + std::to_string(low + 1.0);
  ASSERT_EQ(run("edit v.obj --handle 66+=0,0,1 --keep-out box=" + box +
                " --clearance 0.05 -o e.glb --design d.json"),
            0)
      << err();
  const Positions after = load("e.glb").positions;
  EXPECT_LE(after(2, 66), std::stod(std::to_string(low)) - 0.05 + 1e-9);
  EXPECT_GT(after(2, 66), before(2, 66) + 0.1);
  ASSERT_EQ(run("replay d.json --report again.json"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(contents(directory_ / "again.json"))["verified"], true);
}

/// The model rides along in the design: who replays it needs no other file.
TEST_F(Cli, AModelIsKeptOutOfAndReplayedWithoutItsFile) {
  ASSERT_EQ(run("sample vault --size 12 -o v.obj"), 0);
  Mesh ceiling;
  const Positions before = load("v.obj").positions;
  const double level = before(2, 66) + 0.35;
  ceiling.positions.resize(3, 4);
  ceiling.positions << -1e3, 1e3, 1e3, -1e3, -1e3, -1e3, 1e3, 1e3, level, level, level, level;
  ceiling.face_offsets = {0, 4};
  ceiling.face_vertices = {0, 1, 2, 3};
  std::ofstream(directory_ / "ceiling.obj") << write_obj(ceiling);
  ASSERT_EQ(run("edit v.obj --handle 66+=0,0,1 --keep-out mesh=ceiling.obj --clearance 0.05 "
                "-o e.glb --design d.json"),
            0)
      << err();
  const Positions after = load("e.glb").positions;
  EXPECT_LE(after.row(2).maxCoeff(), std::max(before.row(2).maxCoeff(), level - 0.05) + 1e-9);
  EXPECT_GT(after(2, 66), before(2, 66) + 0.1);
  std::filesystem::remove(directory_ / "ceiling.obj");
  ASSERT_EQ(run("replay d.json --report again.json"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(contents(directory_ / "again.json"))["verified"], true);
  EXPECT_NE(run("edit v.obj --handle 66+=0,0,1 --keep-out mesh=ceiling.obj"), 0);
  EXPECT_NE(err().find("ceiling.obj"), std::string::npos) << err();
}

TEST_F(Cli, AWrongKeepOutIsSaidByItsName) {
  const auto said = [&](const std::string& words) {
    EXPECT_EQ(run("edit sample:vault:12 --handle 66+=0,0,1 " + words), 2);
    return err();
  };
  EXPECT_NE(said("--keep-out meshes").find("--keep-out: \"meshes\" is none of below=Z"),
            std::string::npos);
  EXPECT_NE(said("--keep-out self=1").find("is none of"), std::string::npos);
  EXPECT_NE(said("--keep-out plane=0,0,0,1").find("its direction has no length"),
            std::string::npos);
  EXPECT_NE(said("--clearance 1").find("there is none"), std::string::npos);
  EXPECT_NE(said("--keep-out below=0 --clearance -1").find("clearance must be"), std::string::npos);
  EXPECT_NE(said("--keep-out below=0 --solver alm").find("it needs newton"), std::string::npos);
}

}  // namespace
}  // namespace planish

#endif  // __EMSCRIPTEN__
