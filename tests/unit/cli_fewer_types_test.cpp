// SPDX-License-Identifier: MIT
// What `planish project --move` writes, reports and refuses.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "support/cli.hpp"

namespace planish {
namespace {

using nlohmann::json;
using testing::Cli;
using testing::contents;

TEST_F(Cli, FewerTypesAreWrittenAndTold) {
  ASSERT_EQ(run("project sample:freeform:6 --within 1% --move 20% -o f.obj --report a.json"), 0)
      << err();
  const json report = json::parse(contents(directory_ / "a.json"));
  const json& types = report["types"];
  const Mesh mesh = load("f.obj");
  EXPECT_EQ(types["panels"], mesh.face_count());
  EXPECT_LT(types["after"], types["before"]);
  EXPECT_EQ(types["within_mean_edges"], 0.01);
  EXPECT_LE(types["worst_fit"], types["within"]);
  EXPECT_LE(types["sharpest_fold"]["growth"], 5.1) << "where no limit is stated";
  const std::vector<int> sizes = types["sizes"];
  EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), 0), mesh.face_count());
  EXPECT_EQ(types["templates"].size(), types["after"]);
  EXPECT_LE(report["planarity_mm_per_m"]["after_max"], 1e-6);
  EXPECT_EQ(report["spoilt_faces"], json::object());
  const std::string line = std::to_string(mesh.face_count()) + " panels are of " +
                           std::to_string(types["after"].get<int>()) + " types, " +
                           std::to_string(types["before"].get<int>()) + " before";
  EXPECT_NE(err().find(line), std::string::npos) << err();
  EXPECT_EQ(err().find("identical"), std::string::npos);
  // What `types` finds in the file that was written, in its own unit.
  ASSERT_EQ(run("types f.obj --within 1% --report b.json"), 0) << err();
  EXPECT_LE(json::parse(contents(directory_ / "b.json"))["types"]["types"], types["before"]);
  ASSERT_EQ(run("project sample:freeform:6 --within 1% --move 20% -o g.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "f.obj"), contents(directory_ / "g.obj"));
}

TEST_F(Cli, FewerTypesAreAskedForByTheirNumber) {
  ASSERT_EQ(run("project sample:freeform:5 --types 4 --move 20% --mirrored --report a.json"), 0)
      << err();
  const json types = json::parse(contents(directory_ / "a.json"))["types"];
  EXPECT_LE(types["after"], 4);
  EXPECT_GT(types["before"], 4);
  EXPECT_EQ(types["mirrored"], true);
}

TEST_F(Cli, FewerTypesAreRefusedInOneSentence) {
  save("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.4\nv 0 1 0\nf 1 2 3 4\n");
  for (const char* words :
       {"sample:vault:6 --move 20%", "sample:vault:6 --types 5", "sample:vault:6 --mirrored",
        "sample:vault:6 --move 20% --types 0", "sample:vault:6 --move 20% --types 3 --within 1%",
        "sample:vault:6 --move few --types 3", "sample:vault:6 --move 0 --types 3",
        "sample:vault:6 --move 20% --within 1% --smooth 3",
        "sample:vault:6 --move 20% --within 1% --split 3", "sample:vault:6 --within 1%",
        "sample:vault:6 --move 20% --within 1% --bound shape=off",
        "sample:vault:6 --move 20% --within 1% --bound flat=2"}) {
    EXPECT_EQ(run(std::string("project ") + words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << words << message;
  }
  EXPECT_EQ(run("project bent.obj --move 20% --within 1%"), 3);
  EXPECT_EQ(err(), "planish: the mesh is not flat: planish project makes it so\n");
}

}  // namespace
}  // namespace planish

#endif
