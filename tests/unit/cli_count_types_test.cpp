// SPDX-License-Identifier: MIT
// How edits say what becomes of the types of panels.
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

const std::string kCountedEdit =
    "edit sample:vault:12 --handle 78+=0,0,0.3 --softness 5 --reach 3 --keep-boundary ";

class CountTypes : public Cli {
 protected:
  /// By the command that is for types.
  int types_of(const std::string& mesh, const std::string& words) {
    EXPECT_EQ(run("types " + mesh + " " + words + " --report t.json"), 0) << err();
    return json::parse(contents(directory_ / "t.json"))["types"]["types"].get<int>();
  }
};

TEST_F(CountTypes, SaysWhatTheCommandForTypesFindsBeforeAndAfter) {
  ASSERT_EQ(run("sample vault --size 12 -o before.obj"), 0) << err();
  for (const char* mirrored : {"", " --mirrored"}) {
    const std::string counting = std::string("--count-types 0.5%") + mirrored;
    ASSERT_EQ(run(kCountedEdit + counting + " -o after.obj --report r.json"), 0) << err();
    const std::string said = err();
    const json types = json::parse(contents(directory_ / "r.json"))["types"];
    EXPECT_EQ(types["panels"], 121);
    EXPECT_EQ(types["before"], types_of("before.obj", std::string("--within 0.5%") + mirrored));
    // The length is that of the mesh before, whose edges are others.
    const std::string within = "--unit m --within " + types["within"].dump() + mirrored;
    EXPECT_EQ(types["after"], types_of("after.obj", within));
    EXPECT_GT(types["after"], types["before"]);
    EXPECT_NE(said.find("panels are of " + types["after"].dump() + " types, " +
                        types["before"].dump() + " before"),
              std::string::npos)
        << said;
  }
}

TEST_F(CountTypes, IsNotThereWhereNobodyAsked) {
  ASSERT_EQ(run(kCountedEdit + "--report r.json"), 0) << err();
  EXPECT_FALSE(json::parse(contents(directory_ / "r.json")).contains("types"));
  EXPECT_EQ(err().find("types"), std::string::npos) << err();
}

TEST_F(CountTypes, OfAVariationIsThatOfItsShape) {
  const std::string explore =
      "explore sample:vault:12 --handle 78+=0,0,0.3 --dimension 1 --exact --count-types 1% ";
  ASSERT_EQ(run(explore + "--coefficients 0.5 --report r.json -o v.obj"), 0) << err();
  const json types = json::parse(contents(directory_ / "r.json"))["types"];
  EXPECT_EQ(types["after"], types_of("v.obj", "--unit m --within " + types["within"].dump()));
}

TEST_F(CountTypes, AreColumnsOfASweep) {
  ASSERT_EQ(run(kCountedEdit + "--design d.json"), 0) << err();
  const json design = json::parse(contents(directory_ / "d.json"));
  save("plan.json", json{{"design", design}, {"values", {{"options.softness", {3, 8}}}}}.dump());
  ASSERT_EQ(run("sweep plan.json --part 1/1 -o some --count-types 0.5%"), 0) << err();
  ASSERT_EQ(run("gather some -o some.csv"), 0) << err();
  const std::string table = contents(directory_ / "some.csv");
  EXPECT_NE(table.find(",design,types_before,types_after\n"), std::string::npos) << table;
  ASSERT_EQ(run("sweep plan.json --part 1/1 -o none"), 0) << err();
  ASSERT_EQ(run("gather none -o none.csv"), 0) << err();
  EXPECT_EQ(contents(directory_ / "none.csv").find("types"), std::string::npos);
}

TEST_F(CountTypes, RefusesInOneSentence) {
  for (const char* words :
       {"--count-types 0", "--count-types -1%", "--count-types some", "--mirrored"}) {
    EXPECT_EQ(run(kCountedEdit + words), 2) << words;
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << words << message;
  }
}

}  // namespace
}  // namespace planish

#endif
