// SPDX-License-Identifier: MIT
#include "planish/fabrication/inset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace planish {
namespace {

using PointPairs = std::vector<std::pair<double, double>>;

Outline outline_of(const PointPairs& corners) {
  Outline outline(2, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    outline.col(static_cast<Eigen::Index>(k)) << corners[k].first, corners[k].second;
  }
  return outline;
}

/// Turned by 0.7 and moved: no side lies along an axis.
Outline askew(const Outline& outline) {
  Eigen::Matrix2d turn;
  turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  return (turn * outline).colwise() + Eigen::Vector2d(123.456, -78.9);
}

/// What is left, in the same order and from the same corner on, to the rounding of the numbers.
void expect_pieces(const PointPairs& outline, double distance,
                   const std::vector<PointPairs>& expected) {
  for (const bool turned : {false, true}) {
    const Outline whole = turned ? askew(outline_of(outline)) : outline_of(outline);
    const auto pieces = inset(whole, distance);
    ASSERT_EQ(pieces.size(), expected.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      Outline piece = outline_of(expected[k]);
      if (turned) piece = askew(piece);
      ASSERT_EQ(pieces[k].corners.cols(), piece.cols()) << pieces[k].corners;
      EXPECT_LE((pieces[k].corners - piece).cwiseAbs().maxCoeff(), 1e-11) << pieces[k].corners;
    }
  }
}

const PointPairs kSquare = {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
const PointPairs kSmaller = {{10, 10}, {990, 10}, {990, 990}, {10, 990}};

TEST(Inset, MovesEverySideByTheDistance) {
  const Outline square = outline_of({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_LE((inset(square, 0.5).at(0).corners -
             outline_of({{0.5, 0.5}, {3.5, 0.5}, {3.5, 2.5}, {0.5, 2.5}}))
                .norm(),
            1e-15);
  const Outline angle = outline_of({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});
  EXPECT_LE(
      (inset(angle, 0.25).at(0).corners -
       outline_of(
           {{0.25, 0.25}, {3.75, 0.25}, {3.75, 0.75}, {0.75, 0.75}, {0.75, 3.75}, {0.25, 3.75}}))
          .norm(),
      1e-15);
  EXPECT_EQ(inset(square, 0.0).at(0).corners, square);
  EXPECT_EQ(inset(square, 0.5).at(0).sides, (std::vector{0, 1, 2, 3}));
  const Outline straight = outline_of({{0, 0}, {2, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_LE((inset(straight, 0.5).at(0).corners.col(1) - Eigen::Vector2d(2, 0.5)).norm(), 1e-15);
}

TEST(Inset, LeavesNothingOfWhatIsNarrowerThanTheGap) {
  const Outline square = outline_of({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_EQ(inset(square, 1.49).size(), 1U);
  for (const double distance : {1.5, 2.5, 1e9}) EXPECT_TRUE(inset(square, distance).empty());
  EXPECT_TRUE(inset(outline_of({{0, 0}, {100, 0}, {50, 15}}), 8.0).empty());
}

TEST(Inset, LeavesNothingOfWhatCrossesItself) {
  for (const double distance : {0.0, 0.1}) {
    EXPECT_TRUE(inset(outline_of({{0, 0}, {4, 4}, {4, 0}, {0, 3}}), distance).empty());
    EXPECT_TRUE(inset(outline_of({{0, 0}, {4, 0}, {4, 4}, {2, -1}, {0, 4}}), distance).empty());
    // Through a corner: no two sides cross between their ends.
    const PointPairs ears = {{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}};
    EXPECT_TRUE(inset(outline_of({ears[0], ears[1], ears[3], ears[2], ears[4], ears[5]}), distance)
                    .empty());
    // Twice around.
    EXPECT_TRUE(inset(outline_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                      distance)
                    .empty());
  }
}

TEST(Inset, ANeckNarrowerThanTheGapCutsInTwo) {
  const auto necked = [](double low, double high) {
    return PointPairs{{0, 0},       {1000, 0},    {1000, low},  {2000, low},
                      {2000, 0},    {3000, 0},    {3000, 1000}, {2000, 1000},
                      {2000, high}, {1000, high}, {1000, 1000}, {0, 1000}};
  };
  const PointPairs right = {{2010, 10}, {2990, 10}, {2990, 990}, {2010, 990}};
  for (const double half : {0.0, 1e-7, 1.0, 7.5, 9.99, 10.0}) {
    SCOPED_TRACE(half);
    expect_pieces(necked(500 - half, 500 + half), 10.0, {kSmaller, right});
  }
  EXPECT_EQ(inset(outline_of(necked(489, 511)), 10.0).size(), 1U);
  EXPECT_EQ(inset(outline_of(necked(489, 511)), 10.0)[0].corners.cols(), 12);
}

TEST(Inset, ThreeRoomsFallIntoThree) {
  expect_pieces({{0, 0},     {100, 0},   {100, 45}, {200, 45},  {200, 0},   {300, 0},  {300, 45},
                 {400, 45},  {400, 0},   {500, 0},  {500, 100}, {400, 100}, {400, 55}, {300, 55},
                 {300, 100}, {200, 100}, {200, 55}, {100, 55},  {100, 100}, {0, 100}},
                6.0,
                {{{6, 6}, {94, 6}, {94, 94}, {6, 94}},
                 {{206, 6}, {294, 6}, {294, 94}, {206, 94}},
                 {{406, 6}, {494, 6}, {494, 94}, {406, 94}}});
}

TEST(Inset, ASmallChamferGoes) {
  expect_pieces({{0, 0}, {1000, 0}, {1000, 995}, {995, 1000}, {0, 1000}}, 10.0, {kSmaller});
  // All four, of different sizes; corner 0 is the one nearest to where it was.
  expect_pieces(
      {{5, 0}, {998, 0}, {1000, 2}, {1000, 990}, {990, 1000}, {1, 1000}, {0, 999}, {0, 5}}, 20.0,
      {{{20, 20}, {980, 20}, {980, 980}, {20, 980}}});
  const auto pieces =
      inset(outline_of({{0, 0}, {1000, 0}, {1000, 995}, {995, 1000}, {0, 1000}}), 10.0);
  EXPECT_EQ(pieces.at(0).sides, (std::vector{0, 1, 3, 4}));
}

TEST(Inset, AThinTabGoes) {
  expect_pieces({{0, 0},
                 {1000, 0},
                 {1000, 1000},
                 {600, 1000},
                 {600, 1300},
                 {585, 1300},
                 {585, 1000},
                 {0, 1000}},
                10.0, {kSmaller});
  // Of no width at all, and a blunt one on the side that starts at corner 0.
  expect_pieces({{0, 0}, {1000, 0}, {1000, 1000}, {600, 1000}, {600, 1300}, {600, 1000}, {0, 1000}},
                10.0, {kSmaller});
  expect_pieces(
      {{0, 0}, {300, 0}, {306, -90}, {310, -90}, {316, 0}, {1000, 0}, {1000, 1000}, {0, 1000}},
      10.0, {kSmaller});
}

TEST(Inset, ABluntTipBecomesWhereItsSidesMeet) {
  // A triangle of 1000 by 500 cut off 3 before its tip: the sides' lines meet where the whole one's
  // do.
  const Outline whole = outline_of({{0, 0}, {1000, 250}, {0, 500}});
  const Outline blunt = outline_of({{0, 0}, {988, 247}, {988, 253}, {0, 500}});
  const auto expected = inset(whole, 10.0), pieces = inset(blunt, 10.0);
  ASSERT_EQ(pieces.size(), 1U);
  ASSERT_EQ(pieces[0].corners.cols(), 3);
  EXPECT_LE((pieces[0].corners - expected[0].corners).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_EQ(pieces[0].sides, (std::vector{0, 2, 3}));
}

TEST(Inset, AStraightCornerStaysWhereAnotherSideGoes) {
  expect_pieces({{0, 0}, {400, 0}, {1000, 0}, {1000, 995}, {995, 1000}, {0, 1000}}, 10.0,
                {{{10, 10}, {400, 10}, {990, 10}, {990, 990}, {10, 990}}});
}

TEST(Inset, SidesInOneLineDoNotCrossHoweverTheyAreTurned) {
  const Outline comb = outline_of({{0, 0},
                                   {500, 0},
                                   {500, 100},
                                   {400, 100},
                                   {400, 50},
                                   {300, 50},
                                   {300, 100},
                                   {200, 100},
                                   {200, 50},
                                   {100, 50},
                                   {100, 100},
                                   {0, 100}});
  for (int k = 0; k < 1000; ++k) {
    Eigen::Matrix2d turn;
    turn << std::cos(k), -std::sin(k), std::sin(k), std::cos(k);
    const auto pieces = inset(turn * comb, 5.0);
    ASSERT_EQ(pieces.size(), 1U) << k;
    EXPECT_EQ(pieces[0].corners.cols(), 12) << k;
  }
}

TEST(Inset, ASlotMeetsTheFarSide) {
  expect_pieces(
      {{0, 0}, {1000, 0}, {1000, 1000}, {510, 1000}, {510, 15}, {490, 15}, {490, 1000}, {0, 1000}},
      10.0,
      {{{10, 10}, {480, 10}, {480, 990}, {10, 990}},
       {{520, 10}, {990, 10}, {990, 990}, {520, 990}}});
}

TEST(Inset, SidesThatLieOnEachOtherAreNoWayThrough) {
  // A key hole without width, from the outline to a square hole: what is left has that cut in it.
  const PointPairs hole = {{0, 0},     {500, 0},   {500, 400}, {400, 400}, {400, 600},   {600, 600},
                           {600, 400}, {500, 400}, {500, 0},   {1000, 0},  {1000, 1000}, {0, 1000}};
  expect_pieces(hole, 10.0,
                {{{10, 10},
                  {490, 10},
                  {490, 390},
                  {390, 390},
                  {390, 610},
                  {610, 610},
                  {610, 390},
                  {510, 390},
                  {510, 10},
                  {990, 10},
                  {990, 990},
                  {10, 990}}});
  EXPECT_TRUE(inset(outline_of(hole), 0.0).empty());  // a cut on itself
}

TEST(Inset, KeepsItsDigitsFarFromTheOriginAndAtAnySize) {
  const Outline chamfered = outline_of({{0, 0}, {1000, 0}, {1000, 995}, {995, 1000}, {0, 1000}});
  for (const double size : {1e-6, 1e-3, 1.0, 1e6}) {
    const auto pieces = inset(size * chamfered, size * 10.0);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_LE((pieces[0].corners - size * outline_of(kSmaller)).norm(), 1e-12 * size * 1000.0);
  }
}

}  // namespace
}  // namespace planish
