// SPDX-License-Identifier: MIT
// What `planish edit --split-where-needed` reports, refuses, and hands to a design.
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

const std::string kPulledFar =
    "edit sample:vault:12 --handle 26+=0,0,0.9 --softness 3 --reach 2 --keep-boundary "
    "--bound fold=+12 ";

TEST_F(Cli, SplitWhereNeededReportsItsCurveAndTheDesignReplays) {
  ASSERT_EQ(run(kPulledFar + "--cut strip=100-101 --split-where-needed 1 -o a.obj --report a.json "
                             "--design d.json"),
            0)
      << err();
  EXPECT_NE(err().find("--split-where-needed: 1 line parts a panel"), std::string::npos) << err();
  const json report = json::parse(contents(directory_ / "a.json"));
  const json& curve = report["splits"]["curve"];
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_EQ(curve[0]["cuts"], 0);
  EXPECT_EQ(curve[1]["cuts"], 1);
  EXPECT_LT(curve[1]["handle_error"], curve[0]["handle_error"]);
  EXPECT_EQ(curve[1]["handle_error"], report["handle_error"]);
  EXPECT_EQ(curve[1]["moved_vertices"], report["moved_vertices"]);
  EXPECT_EQ(curve[1]["sharpest_fold"], report["sharpest_fold"]["after"]);
  EXPECT_GT(report["splits"]["tried"], 1);
  EXPECT_GT(report["splits"]["factorizations"], report["factorizations"]);
  EXPECT_EQ(report["cuts"].size(), 2U);
  const json design = json::parse(contents(directory_ / "d.json"));
  EXPECT_EQ(design["cuts"].size(), 2U);
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, SplitWhereNeededCutsImagesAndTheDesignReplays) {
  ASSERT_EQ(run(kPulledFar + "--symmetry x --split-where-needed 1 -o a.obj --report a.json "
                             "--design d.json"),
            0)
      << err();
  const json report = json::parse(contents(directory_ / "a.json"));
  ASSERT_EQ(report["splits"]["curve"].size(), 2U);
  EXPECT_EQ(report["splits"]["curve"][1]["cuts"], 1);
  EXPECT_EQ(report["cuts"].size(), 2U);
  EXPECT_EQ(json::parse(contents(directory_ / "d.json"))["cuts"].size(), 2U);
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

/// A while after the command catches SIGINT, whose bit ends SigCgt in its status.
TEST_F(Cli, SplitWhereNeededWritesWhatItFoundWhenItIsInterrupted) {
  const std::string line = "cd '" + directory_.string() + "' && { '" + program_.string() + "' " +
                           kPulledFar +
                           "--split-where-needed 4 -o a.obj --report a.json --design d.json "
                           ">out 2>err & } ; "
                           "until grep -q '^SigCgt:.*[2367abef]$' /proc/$!/status; do :; done; "
                           "sleep 2; kill -INT $!; wait $!";
  ASSERT_EQ(std::system(line.c_str()), 0) << err();
  const json report = json::parse(contents(directory_ / "a.json"));
  EXPECT_EQ(report["splits"]["reached"], false);
  EXPECT_EQ(report["splits"]["curve"].back()["handle_error"], report["handle_error"]);
  ASSERT_EQ(run("replay d.json -o b.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.obj"), contents(directory_ / "b.obj"));
}

TEST_F(Cli, SplitWhereNeededCutsNothingWhereTheHandleArrives) {
  ASSERT_EQ(run("edit sample:vault:12 --handle 66+=0,0,0.1 --reach 3 --split-where-needed 3 "
                "--report a.json"),
            0)
      << err();
  const json report = json::parse(contents(directory_ / "a.json"));
  EXPECT_EQ(report["splits"]["tried"], 1);
  EXPECT_EQ(report["splits"]["reached"], true);
  EXPECT_FALSE(report.contains("cuts"));
}

TEST_F(Cli, SplitWhereNeededRefusesInOneSentence) {
  for (const char* words :
       {"--split-where-needed 0", "--split-where-needed few", "--within-handle 5%",
        "--split-where-needed 2 --within-handle 5", "--split-where-needed 2 --within-handle 100%",
        "--split-where-needed 2 --solver alm", "--split-where-needed 2 --fewest panels"}) {
    EXPECT_EQ(run(kPulledFar + words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << words << message;
  }
}

}  // namespace
}  // namespace planish

#endif
