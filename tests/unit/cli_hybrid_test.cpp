// SPDX-License-Identifier: MIT
// What `planish project --split` writes, reports and refuses.
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

/// One bent quad whose corners are to stay.
const std::string kBent = "v 0 0 0\nv 1 0 0\nv 1 1 0.4\nv 0 1 0\nf 1 2 3 4\n";

TEST_F(Cli, HybridProjectionWritesTheSplitMesh) {
  save("bent.obj", kBent);
  ASSERT_EQ(run("project bent.obj --pin 0,1,2,3 --split 1 -o flat.obj --report a.json"), 0)
      << err();
  EXPECT_NE(err().find("--split: 1 panel is split, and the mesh is flat"), std::string::npos)
      << err();
  const Mesh mesh = load("flat.obj");
  EXPECT_EQ(mesh.face_count(), 2);
  const json report = json::parse(contents(directory_ / "a.json"));
  EXPECT_EQ(report["split"]["panels"], 1);
  EXPECT_EQ(report["split"]["reached"], true);
  EXPECT_EQ(report["split"]["tried"], 2);
  const json& curve = report["split"]["curve"];
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_EQ(curve[0]["panels"], 0);
  EXPECT_EQ(curve[0]["failing_faces"], 1);
  EXPECT_EQ(curve[1]["panels"], 1);
  EXPECT_EQ(curve[1]["failing_faces"], 0);
  EXPECT_EQ(report["mesh"]["faces"], 2);
  EXPECT_EQ(report["cuts"].size(), 1U);
  EXPECT_EQ(report["panel_parents"][0]["name"], "P-0001a");
  ASSERT_EQ(run("project bent.obj --pin 0,1,2,3 --split 100% -o again.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "flat.obj"), contents(directory_ / "again.obj"));
}

TEST_F(Cli, HybridProjectionOfAFlatMeshSplitsNothing) {
  ASSERT_EQ(run("project sample:vault:8 --split 10% -o flat.obj --report a.json"), 0) << err();
  EXPECT_EQ(json::parse(contents(directory_ / "a.json"))["split"]["panels"], 0);
  EXPECT_EQ(load("flat.obj").face_count(), 49);
}

TEST_F(Cli, HybridProjectionRefusesInOneSentence) {
  save("bent.obj", kBent);
  for (const char* words : {"--split 0", "--split few", "--split 0%", "--split 120%", "--split 10%",
                            "--split 1 --reference bent.obj", "--split 1 --solver alm"}) {
    EXPECT_EQ(run(std::string("project bent.obj ") + words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << words << message;
  }
}

}  // namespace
}  // namespace planish

#endif
