// SPDX-License-Identifier: MIT
/// Cuts as text: read back as written, and refused in one sentence.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "planish/cuts/cut.hpp"
#include "support/cut_checks.hpp"

namespace planish {
namespace {

using testing::parsed_cut;

std::string why_no_cut(const std::string& text) {
  const auto cut = parse_cut(text);
  const auto* why = std::get_if<std::string>(&cut);
  return why != nullptr ? *why : "";
}

TEST(CutText, ReadsBackWhatItWrites) {
  for (const char* text :
       {"split=7:1,2", "split=0:1-2@0.25,3", "split=0:1,5-4@0.1", "split=3:1-2@0.3,4-5@0.7",
        "strip=4-5", "strip=5-4@0.3333333333333333", "corner=2:7", "corner=2:7@0.25", "refine=1",
        "refine=1,2,3:collar", "trim=0,0,1,2.5", "trim=-1,0.5,0,-1e-07"}) {
    const auto cut = parse_cut(text);
    ASSERT_TRUE(std::holds_alternative<Cut>(cut)) << text << why_no_cut(text);
    EXPECT_EQ(cut_text(std::get<Cut>(cut)), text);
  }
}

TEST(CutText, LeavesOutWhatGoesWithoutSaying) {
  EXPECT_EQ(cut_text(parsed_cut("strip=4-5@0.5")), "strip=4-5");
  EXPECT_EQ(cut_text(parsed_cut("corner=2:7@1")), "corner=2:7");
}

TEST(CutText, IsRefusedInOneSentence) {
  EXPECT_EQ(
      why_no_cut("halve=3"),
      "\"halve=3\" is no cut: there are split=F:A,B, strip=V-W@T, corner=F:V@T, refine=F,F,... "
      "and trim=a,b,c,d");
  EXPECT_EQ(why_no_cut("strip=4"), "\"strip=4\" is not of the form strip=V-W@T");
  EXPECT_EQ(why_no_cut("strip=4-5@1"),
            "strip=4-5@1: the share T must be above 0 and below 1, by a millionth at least");
  EXPECT_EQ(why_no_cut("strip=4-4"), "strip=4-4: a side needs two ends");
  EXPECT_EQ(
      why_no_cut("corner=1:2@1.5"),
      "corner=1:2@1.5: the share T must be above 0 and below 1, by a millionth at least, or 1");
  EXPECT_EQ(why_no_cut("split=1:3,3"), "split=1:3,3: A and B are one place");
  EXPECT_EQ(why_no_cut("refine=1,2,1"), "refine=1,2,1: panel 1 is named twice");
  EXPECT_EQ(why_no_cut("trim=0,0,0,1"), "trim=0,0,0,1: the plane's direction has no length");
  EXPECT_EQ(why_no_cut("trim=0,0,inf,1"), "trim=0,0,inf,1: its numbers must be finite");
  for (const char* text : {"",
                           "split",
                           "split=",
                           "split=1",
                           "split=1:2",
                           "split=1:2,",
                           "split=:2,3",
                           "split=1:2,3,4",
                           "split=1:2@0.5,3",
                           "split=-1:2,3",
                           "split=1:2-3,4",
                           "split=99999999999:1,2",
                           "strip=1-2@x",
                           "strip=1-2@nan",
                           "strip=-1-2",
                           "strip=1-2@0.5@0.5",
                           "corner=1",
                           "corner=1:",
                           "corner=1:2:3",
                           "refine=",
                           "refine=1,",
                           "refine=a",
                           "refine=:collar",
                           "refine=1:kollar",
                           "trim=1,2,3",
                           "trim=1,2,3,4,5",
                           "trim=1,2,3,",
                           "TRIM=0,0,1,1",
                           "trim=0,0,1,nan"}) {
    EXPECT_NE(why_no_cut(text), "") << text;
  }
}

/// Whatever the characters: one sentence, or a cut whose text reads back as the same cut.
TEST(CutText, TakesAnyCharacters) {
  const std::vector<std::string> pieces = {
      "split=", "strip=", "corner=", "refine=", "trim=", ":collar",    ":",
      ",",      "-",      "@",       "1",       "23",    "0.5",        "1e-3",
      "-0",     "inf",    "nan",     "\x80",    " ",     "99999999999"};
  testing::RandomCuts random(5);
  int read = 0;
  for (int k = 0; k < 50000; ++k) {
    std::string text = pieces[static_cast<std::size_t>(random.below(5))];
    for (int left = random.below(9); left >= 0; --left) {
      text += pieces[static_cast<std::size_t>(5 + random.below(15))];
    }
    const auto cut = parse_cut(text);
    if (const auto* why = std::get_if<std::string>(&cut)) {
      EXPECT_FALSE(why->empty()) << text;
      continue;
    }
    ++read;
    EXPECT_EQ(parsed_cut(cut_text(std::get<Cut>(cut))), std::get<Cut>(cut)) << text;
  }
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace planish
