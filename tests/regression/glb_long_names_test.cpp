// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "planish/io/gltf.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/glb_chunks.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

/// tinygltf quotes what it cannot read: a type of 600 characters went into the refusal whole.
TEST(GlbLongNames, DoNotFillTheRefusal) {
  testing::Chunks chunks = testing::take_apart(write_glb(*make_sample("vault", 4)));
  std::string type(600, 'x');
  type += "\x01\t\xc3\xa9";
  chunks.json["accessors"][0]["type"] = type;
  const std::string sentence = testing::error_text(read_glb(testing::put_together(chunks)));
  EXPECT_NE(sentence.find("xxx"), std::string::npos) << sentence;
  EXPECT_LT(sentence.size(), 400U);
  EXPECT_TRUE(std::none_of(sentence.begin(), sentence.end(),
                           [](char c) { return static_cast<unsigned char>(c) < ' '; }));
}

}  // namespace
}  // namespace planish
