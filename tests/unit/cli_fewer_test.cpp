// SPDX-License-Identifier: MIT
// What `planish cut --merge` and `--collapse` write, report and refuse.
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

/// Three quads in a row, in one plane.
const std::string kRow =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
    "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n";

TEST_F(Cli, MergedPanelsAreOneAndCollapsedStripsGo) {
  save("row.obj", kRow);
  ASSERT_EQ(run("cut row.obj --merge 0,1 -o merged.obj --report a.json"), 0) << err();
  EXPECT_EQ(load("merged.obj").face_count(), 2);
  const json report = json::parse(contents(directory_ / "a.json"));
  EXPECT_EQ(report["fewer"][0]["op"], "merge=0,1");
  EXPECT_EQ(report["fewer"][0]["moved_points"].size(), 0U);
  EXPECT_EQ(report["panel_parents"][0]["parent"], 2);
  EXPECT_EQ(report["panel_parents"][0]["name"], "P-0003");
  ASSERT_EQ(run("cut row.obj --collapse 1-2 --merge 0,1 --reach 1 -o less.obj"), 0) << err();
  EXPECT_EQ(load("less.obj").face_count(), 1);
  EXPECT_NE(err().find("belong to no panel"), std::string::npos) << err();
}

TEST_F(Cli, MergesAreRefusedInOneSentence) {
  save("row.obj", kRow);
  for (const char* words :
       {"--merge 0", "--merge 0,2", "--merge 0,9", "--merge 1,1", "--collapse 0", "--collapse 0-6",
        "--merge 0,1 --reach -1", "--merge 0,1 --reach 101", "--merge 0,1 --design d.json",
        "--merge 0,1 --corner 0:0", "--corner 0:0 --reach 2"}) {
    EXPECT_EQ(run(std::string("cut row.obj ") + words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << words << message;
  }
}

}  // namespace
}  // namespace planish

#endif
