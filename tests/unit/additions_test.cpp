// SPDX-License-Identifier: MIT
/// The options and the format of tests/additions, added in the build for sanitizers: who reads,
/// writes, checks or lists options and formats has them.
#if defined(PLANISH_EXAMPLES) && !defined(__EMSCRIPTEN__)

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "planish/design/design_text.hpp"
#include "planish/io/mesh_format.hpp"
#include "session.hpp"
#include "support/cli.hpp"
#include "support/scenes.hpp"

namespace planish::testing {
namespace {

class Additions : public Cli {
 protected:
  /// What the edit with `words` says as its options in its design.
  nlohmann::json options_after(const std::string& words) {
    EXPECT_EQ(run(kEdit + words + " --design d.json -o e.obj"), 0) << err();
    return nlohmann::json::parse(contents(directory_ / "d.json")).at("options");
  }

  const std::string kEdit = "edit sample:dome:8 --handle 27+=0,0,0.1 ";
};

TEST_F(Additions, ANumberOptionIsReadCheckedAndKeptInTheDesign) {
  EXPECT_EQ(options_after("--example-number 2.5").at("example_number"), 2.5);
  EXPECT_EQ(run("replay d.json"), 0) << err();
  EXPECT_FALSE(options_after("").contains("example_number")) << "written only where it is on";
  EXPECT_EQ(run(kEdit + "--example-number=-1"), 2);
  EXPECT_NE(err().find("example_number must be a number of at least 0"), std::string::npos)
      << err();
}

TEST_F(Additions, AListOptionIsReadCheckedAndKeptInTheDesign) {
  const nlohmann::json options = options_after("--example-item 3 --example-item 0.5");
  EXPECT_EQ(options.at("example_item"), nlohmann::json({"3", "0.5"}));
  EXPECT_EQ(run("replay d.json"), 0) << err();
  EXPECT_EQ(run(kEdit + "--example-item 0"), 2);
  EXPECT_NE(err().find("example_item must be greater than 0"), std::string::npos) << err();
  const auto read =
      read_design(R"({"version":1,"format":"planish-design","source":{"sample":"dome","size":9},)"
                  R"("options":{"example_item":["x"]}})");
  const auto* sentence = std::get_if<std::string>(&read);
  ASSERT_NE(sentence, nullptr);
  EXPECT_EQ(*sentence, "options.example_item[0] must be one of NUMBER");
}

TEST_F(Additions, AFormatIsReadAndWrittenByTheCommandTheSessionAndDesigns) {
  ASSERT_EQ(run("convert sample:dome:8 -o roof.example"), 0) << err();
  const std::string bytes = contents(directory_ / "roof.example");
  ASSERT_TRUE(bytes.starts_with("example\n"));
  EXPECT_TRUE(same_bits(load("roof.example"), sample("dome", 8)));
  ASSERT_EQ(run("edit roof.example --handle 27+=0,0,0.1 -o e.obj --design d.json"), 0) << err();
  ASSERT_EQ(run("replay d.json -o again.obj"), 0) << err();
  EXPECT_EQ(contents(directory_ / "again.obj"), contents(directory_ / "e.obj"));
  ASSERT_EQ(run("convert --help"), 0);
  EXPECT_NE(out().find(".example"), std::string::npos);
  EXPECT_EQ(run("info roof.none"), 2);
  EXPECT_NE(err().find(".obj, .off, .ply, .example or .glb"), std::string::npos) << err();
  Session session;
  ASSERT_EQ(session.open_file(bytes, "example"), std::nullopt);
  EXPECT_EQ(session.write("example"), bytes);
}

}  // namespace
}  // namespace planish::testing

#endif
