// SPDX-License-Identifier: MIT
#include "planish/text/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fabrication/json_object.hpp"
#include "fabrication/step_file.hpp"

namespace planish {
namespace {

const std::string kMark = "\xEF\xBF\xBD";  // U+FFFD

TEST(Utf8, WhatIsNoneIsReplaced) {
  EXPECT_EQ(as_utf8("lat\xE4in"), "lat" + kMark + "in");
  EXPECT_EQ(as_utf8("\xE4\xF6\xFC"), kMark + kMark + kMark);
  EXPECT_EQ(as_utf8("cut \xE2\x82"), "cut " + kMark);
  EXPECT_EQ(as_utf8("\xC0\xAF"), kMark + kMark);               // too long a form of '/'
  EXPECT_EQ(as_utf8("\xED\xA0\x80"), kMark + kMark + kMark);   // half a pair of UTF-16
  EXPECT_EQ(as_utf8("\xF5\x80\x80\x80").substr(0, 3), kMark);  // beyond U+10FFFF
}

TEST(Utf8, WhatIsStays) {
  for (const std::string text :
       {"", "roof",
        "D\xC3\xA4"
        "cher",
        "\xE5\xB1\x8B\xE6\xA0\xB9", "\xF0\x9F\x8F\xA0", "\xEF\xBF\xBD", "\x7F\x01"}) {
    EXPECT_EQ(as_utf8(text), text);
  }
}

TEST(Utf8, EveryOutputHasTheSameMark) {
  EXPECT_EQ(json_quoted("lat\xE4in"), "\"lat" + kMark + "in\"");
  EXPECT_EQ(step_string("lat\xE4in").text, "'lat\\X2\\FFFD\\X0\\in'");
  EXPECT_EQ(step_string("D\xC3\xA4"
                        "cher")
                .text,
            "'D\\X2\\00E4\\X0\\cher'");
}

}  // namespace
}  // namespace planish
