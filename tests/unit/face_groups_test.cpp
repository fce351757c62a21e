// SPDX-License-Identifier: MIT
#include "planish/io/face_groups.hpp"

#include <gtest/gtest.h>

#include <string>

namespace planish {
namespace {

TEST(FaceGroups, AsTextComeBack) {
  const std::vector<FaceGroup> groups = {{"North wall", 0}, {"", 3}, {"a\nb", 7}};
  const std::string text = face_groups_text(groups);
  EXPECT_EQ(text, "0 North wall\n3 \n7 a b\n");
  const auto read = parse_face_groups(text, 8);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 3U);
  EXPECT_EQ((*read)[0].name, "North wall");
  EXPECT_EQ((*read)[1].name, "");
  EXPECT_EQ((*read)[2].first_face, 7);
}

TEST(FaceGroups, ANameWithBlanksOfItsOwnIsMarkedByATab) {
  const std::string text = face_groups_text({{"North roof", 0, true}, {"a b", 3}});
  EXPECT_EQ(text, "0 \tNorth roof\n3 a b\n");
  const auto read = parse_face_groups(text, 8);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->front().name, "North roof");
  EXPECT_TRUE(read->front().one_name);
  EXPECT_FALSE(read->back().one_name);
}

TEST(FaceGroups, OfOtherFacesAreNone) {
  for (const char* text : {"8 a", "-1 a", "x a", "3 a\n3 b", "3 a\n2 b", " a"}) {
    EXPECT_FALSE(parse_face_groups(text, 8)) << text;
  }
  EXPECT_TRUE(parse_face_groups("", 0)->empty());
  EXPECT_EQ(parse_face_groups("5", 8)->front().name, "");
}

}  // namespace
}  // namespace planish
