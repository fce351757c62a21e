// SPDX-License-Identifier: MIT
// What `planish cut` reads, writes, reports and refuses; and an edit of what it wrote.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/cli.hpp"
#include "support/cut_checks.hpp"

namespace planish {
namespace {

using nlohmann::json;
using testing::Cli;
using testing::contents;

TEST_F(Cli, CutsInTheOrderGiven) {
  ASSERT_EQ(run("sample vault --size 6 -o v.obj"), 0);
  ASSERT_EQ(run("cut v.obj --strip 7-8@0.25 --refine 0,1 --collar --corner=12:14 -o c.obj "
                "--report r.json"),
            0)
      << err();
  EXPECT_EQ(err(), "");
  const auto report = json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["status"], "done");
  std::vector<std::string> ops;
  for (const auto& cut : report["cuts"]) ops.push_back(cut["op"]);
  EXPECT_EQ(ops, (std::vector<std::string>{"strip=7-8@0.25", "refine=0,1:collar", "corner=12:14"}));
  const Mesh given = load("v.obj"), cut = load("c.obj");
  EXPECT_EQ(report["mesh"]["faces"], cut.face_count());
  EXPECT_EQ(report["added_points"].size(),
            static_cast<std::size_t>(cut.vertex_count() - given.vertex_count()));
  EXPECT_EQ(report["cuts"][2]["panels"][0], 12);
  const auto& parents = report["panel_parents"];
  EXPECT_EQ(parents[0]["panel"], 0);
  EXPECT_EQ(parents[0]["name"], "P-0001a");
  EXPECT_EQ(parents.back()["parent"], 12);
  EXPECT_EQ(parents.back()["name"], "P-0013b");
  EXPECT_TRUE(
      testing::same_bits(Positions(cut.positions.leftCols(given.vertex_count())), given.positions));
}

TEST_F(Cli, CutsWhatItReadsAndWritesEveryFormat) {
  ASSERT_EQ(run("sample hex --size 8 -o m.obj"), 0);
  ASSERT_EQ(run("edit m.obj --handle 40+=0,0,0.3 --design d.json -o d.glb"), 0) << err();
  ASSERT_EQ(run("cut m.obj --corner 3:" + std::to_string(load("m.obj").face(3)[0]) + " -o a.ply"),
            0);
  for (const char* input : {"a.ply", "d.json", "d.glb", "sample:hex:8"}) {
    for (const char* output : {"o.obj", "o.off", "o.ply", "o.glb"}) {
      ASSERT_EQ(run(std::string("cut ") + input + " --trim 1,0,0,0.11 -o " + output), 0) << err();
      EXPECT_GT(load(output).face_count(), 0);
    }
  }
  // Of a design it is the result that is cut.
  ASSERT_EQ(run("cut d.json --refine 0 -o cut.obj"), 0);
  ASSERT_EQ(run("replay d.json -o whole.obj"), 0);
  const Mesh whole = load("whole.obj"), cut = load("cut.obj");
  EXPECT_TRUE(
      testing::same_bits(Positions(cut.positions.leftCols(whole.vertex_count())), whole.positions));
}

TEST_F(Cli, SaysWhyACutCannotBeMade) {
  save("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"cut m.obj -o o.obj",
       "a cut is missing: there are split=F:A,B, strip=V-W@T, corner=F:V@T, refine=F,F,... and "
       "trim=a,b,c,d"},
      {"cut m.obj --collar -o o.obj", "--collar goes behind a --refine"},
      {"cut m.obj --split 0:0,1 -o o.obj",
       "split=0:0,1: points 0 and 1 are neighbours on the outline of panel 0"},
      {"cut m.obj --split 0:0 -o o.obj",
       "\"split=0:0\" is not of the form split=F:A,B (A and B: a corner V, or V-W@T on a side)"},
      {"cut m.obj --strip 0-1@2 -o o.obj",
       "strip=0-1@2: the share T must be above 0 and below 1, by a millionth at least"},
      {"cut m.obj --corner 0:0 -o o.stl", "o.stl: the extension must be " + all_extensions()},
      {"cut --corner 0:0 -o o.obj", "MESH or DESIGN is missing"}};
  for (const auto& [words, sentence] : cases) {
    EXPECT_EQ(run(words), 2) << words;
    EXPECT_EQ(err(), "planish: " + sentence + "\n") << words;
    EXPECT_FALSE(testing::fs::exists(directory_ / "o.obj")) << words;
  }
  EXPECT_EQ(run("cut m.obj --trim 1,0,0,0.5 -o o.obj"), 0);
  EXPECT_EQ(err(), "planish: 2 points belong to no panel any more and stay, so that numbers do\n");
}

/// Straight corners bind an edit to nothing that it cannot keep.
TEST_F(Cli, AnEditOfACutMeshIsExact) {
  ASSERT_EQ(run("cut sample:vault:16 --refine 112 --strip 20-21 --corner 120:128 -o cut.obj"), 0)
      << err();
  ASSERT_EQ(
      run("edit cut.obj --handle 136+=0,0,0.2 --softness 5 --reach 4 -o e.obj --report r.json"), 0)
      << err();
  const auto report = json::parse(contents(directory_ / "r.json"));
  EXPECT_EQ(report["status"], "converged");
  EXPECT_LE(report["planarity_mm_per_m"]["after_max"].get<double>(), 1e-6);
  EXPECT_TRUE(report["spoilt_faces"].empty()) << report["spoilt_faces"];
}

}  // namespace
}  // namespace planish

#endif
