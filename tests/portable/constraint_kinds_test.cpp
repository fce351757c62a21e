// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "planish/constraints/kept_kinds.hpp"
#include "planish/constraints/registry.hpp"
#include "support/constraint_checks.hpp"
#include "support/equal_diagonals.hpp"
#include "support/places.hpp"

namespace planish {
namespace {

/// [CON-1] for whatever is registered.
TEST(ConstraintKinds, HaveTheirDerivativesAndTheirMeasure) {
  ConstraintKinds::for_each(
      [](auto tag) { testing::expect_sound_kind<typename decltype(tag)::type>(); });
}

/// The example of docs/extending.md is a kind: it satisfies the concept and every check.
TEST(ConstraintKinds, TheExampleIsOne) {
  using WithExample = KindList<PlanarPolygon, testing::EqualDiagonals>;
  static_assert(WithExample::index_of<testing::EqualDiagonals>() == 1);
  WithExample::for_each(
      [](auto tag) { testing::expect_sound_kind<typename decltype(tag)::type>(); });
}

std::string text_of(const std::string& path) {
  std::ifstream file(testing::in_tree(path));
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ConstraintKinds, TheExampleIsTheOneThatIsShown) {
  const std::string code = text_of("tests/support/equal_diagonals.hpp");
  ASSERT_FALSE(code.empty());
  EXPECT_NE(text_of("docs/extending.md").find("```cpp\n" + code + "```"), std::string::npos);
  EXPECT_LE(std::count(code.begin(), code.end(), '\n'), 60);
}

/// What ends the exact finish is what it keeps its best attempt by.
TEST(KeptKinds, AreWithinWhereTheStrainIsAtMostOne) {
  const KeptKinds kept(1e-6);
  Violations violations;
  violations[0] = {.measure = 1e-4, .excess = 0.0};  // far from the origin: rounding
  EXPECT_TRUE(is_within(violations, kept));
  EXPECT_EQ(strain(violations, kept), 0.0);
  violations[0] = {.measure = 2e-6, .excess = 2e-6};
  EXPECT_FALSE(is_within(violations, kept));
  EXPECT_EQ(strain(violations, kept), 2.0);
}

/// Rows are numbered through, batch after batch, in the order of the list.
TEST(RowBatches, NumberTheirRowsThrough) {
  RowBatches<KindList<PlanarPolygon, testing::EqualDiagonals>> rows;
  rows.of<testing::EqualDiagonals>().resize(3);
  rows.of<PlanarPolygon>().resize(2);
  EXPECT_EQ(rows.size(), 5u);
  std::vector<int> numbers, planar;
  rows.for_each([&]<class Row>(int number, const Row&) {
    numbers.push_back(number);
    if constexpr (std::is_same_v<Row, FlatnessEquation>) planar.push_back(number);
  });
  EXPECT_EQ(numbers, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(planar, (std::vector<int>{0, 1}));
  rows.clear();
  EXPECT_TRUE(rows.empty());
}

/// Kinds of one name follow each other, and are one to whoever asks and whoever is told.
TEST(ConstraintKinds, HaveNamesOfTheirOwnOrShareAllThatIsSaid) {
  std::set<std::string_view> names;
  std::string_view last, unit;
  double tolerance = 0.0;
  ConstraintKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName == last) {
      EXPECT_EQ(Kind::kUnit, unit) << Kind::kName;
      EXPECT_EQ(Kind::kTolerance, tolerance) << Kind::kName;
    } else {
      EXPECT_TRUE(names.insert(Kind::kName).second) << Kind::kName;
    }
    last = Kind::kName;
    unit = Kind::kUnit;
    tolerance = Kind::kTolerance;
    EXPECT_FALSE(Kind::kUnit.empty()) << Kind::kName;
    EXPECT_GT(Kind::kTolerance, 0.0) << Kind::kName;
  });
}

}  // namespace
}  // namespace planish
