// SPDX-License-Identifier: MIT
#include "json_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace planish {
namespace {

TEST(JsonText, AnotherReaderGetsTheSameValues) {
  const std::string text = JsonText()
                               .add("number", 0.1)
                               .add("tiny", -5e-324)
                               .add("count", 3)
                               .add("yes", true)
                               .add("word", "flat")
                               .add("awkward", std::string("\"Größe\"\\\n\x01"))
                               .add("list", std::vector<double>{1.0 / 3.0, 2.0})
                               .add("none", std::vector<int>{})
                               .add("words", std::vector<std::string>{"a", "b"})
                               .add("inside", JsonText().add("x", 1))
                               .text();
  const nlohmann::json expected = {{"number", 0.1},
                                   {"tiny", -5e-324},
                                   {"count", 3},
                                   {"yes", true},
                                   {"word", "flat"},
                                   {"awkward", "\"Größe\"\\\n\x01"},
                                   {"list", {1.0 / 3.0, 2.0}},
                                   {"none", nlohmann::json::array()},
                                   {"words", {"a", "b"}},
                                   {"inside", {{"x", 1}}}};
  EXPECT_EQ(nlohmann::json::parse(text), expected) << text;
}

TEST(JsonText, WhatIsNotFiniteIsNull) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(JsonText().add("x", infinite).add("y", -infinite * 0.0).text(),
            "{\"x\":null,\"y\":null}");
  EXPECT_EQ(JsonText().text(), "{}");
}

}  // namespace
}  // namespace planish
