// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/design/design_text.hpp"

namespace planish {
namespace {

/// The name of an unknown field went into the refusal as it was, line ends and all.
TEST(DesignFieldNames, CannotBreakTheSentence) {
  const auto result = read_design(R"({"format":"planish-design","a\nb":1})");
  const auto* sentence = std::get_if<std::string>(&result);
  ASSERT_NE(sentence, nullptr);
  for (const char c : *sentence) EXPECT_GE(static_cast<unsigned char>(c), ' ');
  EXPECT_NE(sentence->find("is not a field of a design"), std::string::npos);
}

}  // namespace
}  // namespace planish
