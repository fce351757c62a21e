// SPDX-License-Identifier: MIT
/// One cut and its images: what they leave has the symmetry, and none is made twice.
#include "planish/design/cut_images.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/design/cut_base.hpp"
#include "support/mesh_builders.hpp"
#include "support/symmetric_meshes.hpp"

namespace planish {
namespace {

constexpr double kImageTolerance = 1e-6;

/// A flat grid of n × n squares about the origin; vertex row · (n + 1) + column.
Mesh flat_squares(int n) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column <= n; ++column) {
      points.emplace_back(column - 0.5 * n, row - 0.5 * n, 0.0);
      const int v = row * (n + 1) + column;
      if (row < n && column < n) faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  }
  return testing::make_mesh(points, faces);
}

std::vector<std::string> cuts_of(const Mesh& mesh, const std::string& text,
                                 const std::string& symmetry) {
  const auto cut = parse_cut(text);
  EXPECT_TRUE(std::holds_alternative<Cut>(cut)) << text;
  const auto all = cut_with_images(mesh, std::get<Cut>(cut), testing::symmetry_of(mesh, symmetry));
  std::optional<MeshSymmetry> kept = testing::symmetry_of(mesh, symmetry);
  const auto made = cut_base(mesh, all, kept, kImageTolerance);
  if (const auto* why = std::get_if<std::string>(&made)) ADD_FAILURE() << text << ": " << *why;
  std::vector<std::string> texts;
  for (const Cut& one : all) texts.push_back(cut_text(one));
  return texts;
}

using CutTexts = std::vector<std::string>;

TEST(CutImages, OfASplitAreOnePerImageOfItsPanel) {
  const Mesh mesh = flat_squares(4);
  EXPECT_EQ(cuts_of(mesh, "split=0:0,6", "x"), (CutTexts{"split=0:0,6", "split=3:4,8"}));
  EXPECT_EQ(cuts_of(mesh, "split=0:0,6", "x,y").size(), 4U);
  EXPECT_EQ(cuts_of(mesh, "split=0:0,1-6@0.25", "axis:4").size(), 4U);
  // Its own image, from the other end.
  EXPECT_EQ(cuts_of(flat_squares(3), "split=4:5-9@0.25,6-10@0.25", "x").size(), 1U);
}

TEST(CutImages, OfAStripAreTheOtherLinesOnce) {
  const Mesh mesh = flat_squares(4);
  // Along the mirrored direction it is its own image, across it is not.
  EXPECT_EQ(cuts_of(mesh, "strip=0-5@0.25", "x"), (CutTexts{"strip=0-5@0.25"}));
  EXPECT_EQ(cuts_of(mesh, "strip=0-1@0.25", "x"), (CutTexts{"strip=0-1@0.25", "strip=4-3@0.25"}));
  EXPECT_EQ(cuts_of(mesh, "strip=0-1@0.25", "axis:4").size(), 4U);
}

TEST(CutImages, OfALineBesideTheMiddleOfAStripIsOneMoreInIt) {
  const Mesh mesh = flat_squares(3);
  const CutTexts texts = cuts_of(mesh, "strip=1-2@0.25", "x");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[1].substr(0, 9), "strip=2-1") << "to the point that the first one added";
  EXPECT_EQ(cuts_of(mesh, "strip=1-2", "x"), (CutTexts{"strip=1-2"}));
}

TEST(CutImages, MeetOnASideThatTheyShare) {
  const Mesh mesh = flat_squares(2);
  EXPECT_EQ(cuts_of(mesh, "split=0:0,1-4@0.25", "x"),
            (CutTexts{"split=0:0,1-4@0.25", "split=1:2,9"}));
  EXPECT_EQ(cuts_of(mesh, "corner=0:4@0.5", "x,y").size(), 4U);
  EXPECT_EQ(cuts_of(mesh, "corner=0:4", "axis:4").size(), 4U);
}

TEST(CutImages, OfCornersRefinedPanelsAndPlanes) {
  const Mesh mesh = flat_squares(4);
  EXPECT_EQ(cuts_of(mesh, "corner=0:0@0.5", "x,y").size(), 4U);
  EXPECT_EQ(cuts_of(flat_squares(3), "corner=4:5@0.25", "x,y").size(), 4U) << "of one panel";
  EXPECT_EQ(cuts_of(mesh, "refine=1,2", "x"), (CutTexts{"refine=1,2"}));
  EXPECT_EQ(cuts_of(mesh, "refine=0", "x,y"), (CutTexts{"refine=0,3,12,15"}));
  EXPECT_EQ(cuts_of(mesh, "trim=1,0,0,1.5", "x"), (CutTexts{"trim=1,0,0,1.5", "trim=-1,0,0,1.5"}));
  EXPECT_EQ(cuts_of(mesh, "trim=1,0,0,1.5", "y"), (CutTexts{"trim=1,0,0,1.5"}));
}

TEST(CutImages, WhatCannotBeMadeIsLeftAsItIs) {
  const Mesh mesh = flat_squares(4);
  const Cut cut = SplitCut{99, {0}, {6}};
  EXPECT_EQ(cut_with_images(mesh, cut, testing::symmetry_of(mesh, "x")), std::vector<Cut>{cut});
}

std::vector<std::string> listed_with_images(const Mesh& mesh,
                                            const std::vector<const char*>& texts) {
  std::vector<Cut> cuts;
  for (const char* text : texts) cuts.push_back(std::get<Cut>(parse_cut(text)));
  const MeshSymmetry symmetry = testing::symmetry_of(mesh, "x");
  const auto all = cuts_with_images(mesh, cuts, symmetry, kImageTolerance);
  std::vector<std::string> found;
  for (const Cut& one : all) found.push_back(cut_text(one));
  return found;
}

TEST(CutImages, OfAListFollowEachCut) {
  const Mesh mesh = flat_squares(4);
  EXPECT_EQ(listed_with_images(mesh, {"split=0:0,6", "corner=1:1"}),
            (CutTexts{"split=0:0,6", "split=3:4,8", "corner=1:1", "corner=2:3"}));
}

TEST(CutImages, OfAListThatHasTheSymmetryAreNotAdded) {
  const Mesh mesh = flat_squares(4);
  const CutTexts listed = listed_with_images(mesh, {"split=3:4,8", "split=0:0,6"});
  EXPECT_EQ(listed, (CutTexts{"split=3:4,8", "split=0:0,6"}));
}

TEST(CutImages, OfAListThatCannotBeMadeEndWithTheCutThatCannot) {
  const Mesh mesh = flat_squares(4);
  EXPECT_EQ(listed_with_images(mesh, {"split=0:0,6", "split=0:0,1"}),
            (CutTexts{"split=0:0,6", "split=3:4,8", "split=0:0,1"}));
}

}  // namespace
}  // namespace planish
