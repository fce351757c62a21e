// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/io/ply.hpp"

namespace planish {
namespace {

/// The name of an element that the reader skips went into the refusal as it was.
TEST(PlyElementNames, CannotBreakTheSentence) {
  const auto result = read_ply(
      "ply\nformat ascii 1.0\n"
      "element fac\x18\x1b 1\nproperty float x\n"
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\n"
      "end_header\nhalf\n");
  const auto* error = std::get_if<ReadError>(&result);
  ASSERT_NE(error, nullptr);
  for (const char c : error->message) EXPECT_GE(static_cast<unsigned char>(c), ' ');
  EXPECT_NE(error->message.find("is not a number"), std::string::npos);
}

}  // namespace
}  // namespace planish
