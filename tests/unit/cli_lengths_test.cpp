// SPDX-License-Identifier: MIT
// Lengths with a unit behind them, wherever the command line reads a length.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "support/cli.hpp"

namespace planish {
namespace {

using testing::Cli;
using testing::contents;

class CliLengths : public Cli {
 protected:
  /// What `words` write with either spelling of a length in place of $.
  void expect_same(const std::string& words, const std::string& plain, const std::string& unit) {
    std::vector<std::string> written;
    for (const std::string& length : {plain, unit}) {
      std::string command = words;
      command.replace(command.find('$'), 1, length);
      ASSERT_EQ(run(command + " -o out.obj"), 0) << command << "\n" << err();
      written.push_back(contents(directory_ / "out.obj"));
    }
    EXPECT_EQ(written[0], written[1]) << words;
  }
};

TEST_F(CliLengths, AnEditReadsThemInEveryOption) {
  const std::string edit = "edit sample:vault:9 --handle 40+=0,0,0.3 ";
  ASSERT_EQ(run(edit + "-o out.obj"), 0);
  const std::string free = contents(directory_ / "out.obj");
  for (const auto& [option, plain, unit] : std::vector<std::array<std::string, 3>>{
           {"--bound slide=$", "0.07", "70mm"},
           {"--bound edge=0.5:$", "1.0625", "1062.5mm"},
           {"--bound sheet=1.0625x$", "1.125", "112.5cm"},
           {"--bound area=$", "1.125", "11250cm2"},
           {"--keep-out above=$", "1.625", "1625mm"},
           {"--keep-out plane=0,0,1,$", "1.625", "162.5cm"},
           {"--keep-out above=1.75 --clearance $", "0.125", "125mm"}}) {
    expect_same(edit + option, plain, unit);
    EXPECT_NE(contents(directory_ / "out.obj"), free) << option;  // it does something
  }
  expect_same("edit sample:vault:9 --handle 40+=0,0,$", "0.25", "25cm");
  expect_same("edit sample:vault:9 --handle 40+=0,0,0.3 --cut trim=1,0,0,$", "6.5", "650cm");
}

TEST_F(CliLengths, TheyAreInTheUnitOfTheModel) {
  expect_same("edit sample:vault:9 --handle 40+=0,0,0.3 --model-unit mm --bound slide=$", "0.25",
              "0.025cm");
  expect_same("project sample:vault:6 --model-unit mm --move $ --within 2%", "0.25", "0.025cm");
  expect_same("offset sample:dome:9 --model-unit cm --distance $", "0.25", "2.5mm");
}

TEST_F(CliLengths, DrawingsAndTypesReadThem) {
  const auto drawn = [this](const std::string& where) {
    EXPECT_EQ(run("drawings sample:vault:9 -o d.zip --report r.json " + where), 0) << err();
    return contents(directory_ / "r.json");
  };
  const std::string plain = drawn("--axis x=1.5:5m --section x=2.5");
  EXPECT_EQ(plain, drawn("--axis x=1500mm:5m --section x=250cm"));
  EXPECT_NE(plain.find("\"5m\""), std::string::npos);  // a name is no length
  ASSERT_EQ(run("types sample:vault:9 --within 25 --report a.json"), 0) << err();
  ASSERT_EQ(run("types sample:vault:9 --within 2.5cm --report b.json"), 0) << err();
  EXPECT_EQ(contents(directory_ / "a.json"), contents(directory_ / "b.json"));
}

TEST_F(CliLengths, AWordThatIsNoUnitIsNamed) {
  for (const auto& [words, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"--bound slide=50parsec", "\"slide=50parsec\" is not slide=MAX"},
           {"--bound area=5m", "\"area=5m\" is not area=MAX"},
           {"--bound fold=5mm", "\"fold=5mm\" is not fold=MAX"},
           {"--reach 5parsec", "--reach: \"parsec\" is none of mm, cm, m, km, in, ft"},
           {"--keep-out above=3 --clearance 2l", "--clearance: \"l\" is none of mm"},
           {"--bound slide=1m --model-unit yd", "--model-unit: \"yd\" is none of mm"}}) {
    EXPECT_EQ(run("edit sample:vault:9 --handle 40+=0,0,0.3 " + words), 2) << words;
    EXPECT_NE(err().find(sentence), std::string::npos) << err();
  }
}

}  // namespace
}  // namespace planish

#endif
