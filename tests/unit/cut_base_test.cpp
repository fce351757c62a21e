// SPDX-License-Identifier: MIT
/// What an edit starts from after cuts: supports that go with added points, and symmetry.
#include "planish/design/cut_base.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "planish/design/design.hpp"
#include "planish/design/design_text.hpp"
#include "support/cut_checks.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::parsed_cut;

/// 4 × 4 points, 3 × 3 quads: point 4 · row + column.
Mesh small_grid() { return testing::quad_grid(4, 4); }

CutMesh cut_grid(const std::vector<std::string>& texts) {
  std::vector<Cut> cuts;
  for (const std::string& text : texts) cuts.push_back(parsed_cut(text));
  return std::get<CutMesh>(cut_mesh(small_grid(), cuts));
}

/// The point that was added on the side between two points.
int added_on(const CutMesh& cut, int from, int to) {
  for (const AddedPoint& point : cut.added) {
    if (point.from == from && point.to == to) return point.vertex;
  }
  return -1;
}

std::string carried(const std::string& support, const CutMesh& cut) {
  const auto all = supports_after_cuts({*parse_point_support(support)}, cut);
  return point_support_text(all.front());
}

TEST(SupportsAfterCuts, TakeAlongWhatIsAddedOnASideOfTheirs) {
  // Across the sides 0-1, 4-5, 8-9 and 12-13.
  const CutMesh cut = cut_grid({"strip=0-1@0.25"});
  ASSERT_EQ(cut.added.size(), 4u);
  EXPECT_EQ(carried("plane=0,0,1,0:0,1,2", cut),
            "plane=0,0,1,0:0,1,2," + std::to_string(added_on(cut, 0, 1)));
  EXPECT_EQ(carried("spring=4:4,5", cut), "spring=4:4,5," + std::to_string(added_on(cut, 4, 5)));
  EXPECT_EQ(carried("level=z:0,2,3", cut), "level=z:0,2,3") << "only one end of a side";
  EXPECT_EQ(carried("outline:boundary", cut), "outline:boundary") << "says it already";
}

TEST(SupportsAfterCuts, OutlinesTakeNoPointInside) {
  const CutMesh cut = cut_grid({"strip=0-4"});
  for (const AddedPoint& point : cut.added) {
    const std::string ends = std::to_string(point.from) + "," + std::to_string(point.to);
    const bool on_boundary = point.from % 4 == 0 || point.from % 4 == 3;
    std::string more;
    if (on_boundary) more.append(",").append(std::to_string(point.vertex));
    EXPECT_EQ(carried("outline:" + ends, cut), "outline:" + ends + more);
  }
}

TEST(SupportsAfterCuts, PolylinesHaveThemInTheirPlace) {
  const std::string once = std::to_string(added_on(cut_grid({"strip=4-5@0.6"}), 4, 5));
  const CutMesh cut = cut_grid({"strip=4-5@0.6", "strip=1-2", "strip=4-" + once});
  ASSERT_GE(cut.added.size(), 12u);
  for (const bool forward : {true, false}) {
    const auto all = supports_after_cuts(
        {*parse_point_support(forward ? "polyline:4,5,6,7" : "polyline:7,6,5,4")}, cut);
    const std::vector<int>& line = all.front().vertices;
    ASSERT_EQ(line.size(), 7u);
    for (std::size_t k = 1; k < line.size(); ++k) {
      const double step = cut.mesh.positions(0, line[k]) - cut.mesh.positions(0, line[k - 1]);
      EXPECT_GT(forward ? step : -step, 0.0);
    }
    EXPECT_EQ(find_problem(all, cut.mesh), std::nullopt);
  }
}

TEST(CutDesign, WithoutCutsIsTheTextThatItWas) {
  Design design;
  design.source = SampleSource{"vault", 8};
  EXPECT_EQ(write_design(design).find("cuts"), std::string::npos);
  design.cuts = {parsed_cut("strip=0-1"), parsed_cut("trim=0,0,1,2.5")};
  const std::string text = write_design(design);
  EXPECT_NE(text.find(R"("unit":"m","cuts":["strip=0-1","trim=0,0,1,2.5"],"handles":[])"),
            std::string::npos);
  EXPECT_EQ(std::get<Design>(read_design(text)).cuts, design.cuts);
}

TEST(CutDesign, RefusesWhatIsNoCutInASentence) {
  const std::string head =
      R"({"format":"planish-design","version":1,"source":{"sample":"vault","size":8},"cuts":)";
  const auto problem = [&](const std::string& cuts) {
    return std::get<std::string>(read_design(head + cuts + "}"));
  };
  EXPECT_EQ(problem(R"("strip=0-1")"), "cuts must be a list");
  EXPECT_EQ(problem("[7]"), "cuts[0] must be a text");
  EXPECT_NE(problem(R"(["saw=3"])").find("cuts: \"saw=3\" is no cut: there are split=F:A,B"),
            std::string::npos);
  EXPECT_EQ(problem(R"(["strip=0-1@2"])"),
            "cuts: strip=0-1@2: the share T must be above 0 and below 1, by a millionth at least");
}

TEST(CutDesign, SaysWhyItsMeshCannotBeCutSo) {
  Design design;
  design.source = SampleSource{"vault", 8};
  design.cuts = {parsed_cut("split=5000:0,2")};
  const auto result = replay(design);
  ASSERT_TRUE(std::holds_alternative<std::string>(result));
  EXPECT_EQ(std::get<std::string>(result).find("split=5000:0,2: there is no panel 5000"), 0u);
}

TEST(CutDesign, WithoutHandlesIsTheCutMesh) {
  Design design;
  design.source = SampleSource{"vault", 8};
  design.cuts = {parsed_cut("refine=3,4:collar")};
  const auto result = std::get<Replay>(replay(design));
  const Mesh given = testing::sample("vault", 8);
  const auto cut = std::get<CutMesh>(cut_mesh(given, design.cuts));
  EXPECT_TRUE(testing::same_bits(result.base, cut.mesh));
  EXPECT_TRUE(testing::same_bits(result.shape, cut.mesh.positions));
  EXPECT_EQ(result.mark.moved, 0);
  ASSERT_TRUE(result.cut.has_value());
  EXPECT_EQ(result.cut->parents, cut.parents);
}

}  // namespace
}  // namespace planish
