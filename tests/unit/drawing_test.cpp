// SPDX-License-Identifier: MIT
#include "planish/fabrication/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "planish/fabrication/assembly_map.hpp"
#include "planish/fabrication/panel_drawing.hpp"
#include "planish/fabrication/sheet_layout.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

std::string six_decimals(double value) {
  std::string text;
  append_decimals(text, value);
  return text;
}

Outline outline_of(const std::vector<std::pair<double, double>>& corners) {
  Outline outline(2, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    outline.col(static_cast<Eigen::Index>(k)) << corners[k].first, corners[k].second;
  }
  return outline;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(AppendDecimals, KeepsSixAndNoMore) {
  EXPECT_EQ(six_decimals(0.0), "0");
  EXPECT_EQ(six_decimals(-0.0), "0");
  EXPECT_EQ(six_decimals(-1e-7), "0");
  EXPECT_EQ(six_decimals(1.5), "1.5");
  EXPECT_EQ(six_decimals(-12.000001), "-12.000001");
  EXPECT_EQ(six_decimals(0.0000005), "0.000001");
  EXPECT_EQ(six_decimals(1234567.25), "1234567.25");
  EXPECT_EQ(six_decimals(1e20), "1e+20");
}

TEST(WriteDxf, HoldsClosedPolylinesOfVersion12Only) {
  Drawing drawing;
  drawing.loops.push_back({DrawingLayer::kCut, outline_of({{0, 0}, {2, 0}, {1, 1.25}})});
  drawing.texts.push_back({{1, 0.5}, 0.25, 90.0, "P-0001"});
  const std::string dxf = write_dxf(drawing, "mm");
  EXPECT_NE(dxf.find("9\n$ACADVER\n1\nAC1009\n"), std::string::npos);
  EXPECT_EQ(dxf.find("LWPOLYLINE"), std::string::npos);
  EXPECT_NE(dxf.find("0\nPOLYLINE\n8\nCUT\n66\n1\n10\n0\n20\n0\n30\n0\n70\n1\n0\nVERTEX\n8\nCUT\n10"
                     "\n0\n20\n0\n30\n0\n"),
            std::string::npos);
  EXPECT_NE(dxf.find("10\n1\n20\n1.25\n30\n0\n0\nSEQEND\n8\nCUT\n"), std::string::npos);
  EXPECT_EQ(occurrences(dxf, "\nVERTEX\n"), 3U);
  EXPECT_NE(dxf.find("40\n0.25\n1\nP-0001\n50\n90\n"), std::string::npos);
  EXPECT_EQ(occurrences(dxf, "0\nLAYER\n2\n"), 2U);  // those that something is on
  EXPECT_NE(dxf.find("0\nLTYPE\n2\nCONTINUOUS\n"), std::string::npos);
  EXPECT_EQ(dxf.substr(dxf.size() - 6), "0\nEOF\n");
}

TEST(WriteDxf, NamesItsUnitInTheHeader) {
  const auto header_of = [](const char* unit) {
    const std::string dxf = write_dxf({}, unit);
    return dxf.substr(0, dxf.find("0\nENDSEC\n"));
  };
  const auto ends_with = [](const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
  };
  const auto units = [](int insunits, int measurement) {
    return "9\n$INSUNITS\n70\n" + std::to_string(insunits) + "\n9\n$MEASUREMENT\n70\n" +
           std::to_string(measurement) + "\n";
  };
  EXPECT_TRUE(ends_with(header_of("mm"), units(4, 1)));
  EXPECT_TRUE(ends_with(header_of("cm"), units(5, 1)));
  EXPECT_TRUE(ends_with(header_of("m"), units(6, 1)));
  EXPECT_TRUE(ends_with(header_of("km"), units(7, 1)));
  EXPECT_TRUE(ends_with(header_of("in"), units(1, 0)));
  EXPECT_TRUE(ends_with(header_of("ft"), units(2, 0)));
  EXPECT_TRUE(ends_with(header_of("ell"), "9\n$ACADVER\n1\nAC1009\n"));
}

TEST(WriteSvg, HasTheSheetInItsUnitWithTheOriginBelow) {
  Drawing drawing;
  drawing.loops.push_back({DrawingLayer::kCut, outline_of({{0, 0}, {2, 0}, {1, 3}})});
  const std::string svg = write_svg(drawing, 20, 10, "mm");
  EXPECT_NE(svg.find("width=\"20mm\" height=\"10mm\" viewBox=\"0 0 20 10\""), std::string::npos);
  EXPECT_NE(svg.find("points=\"0,10 2,10 1,7\""), std::string::npos);
  EXPECT_NE(write_svg(drawing, 20, 10, "ft").find("width=\"20\""), std::string::npos);
}

/// In pixels of the screen, whatever the scale is: the cut is heavier than what lies behind it.
TEST(WriteSvg, DrawsSectionsHeavierThanPanelsAndThoseHeavierThanSizes) {
  const auto width = [](DrawingLayer layer) {
    Drawing drawing;
    drawing.loops.push_back({layer, outline_of({{0, 0}, {2, 0}, {1, 3}})});
    const std::string svg = write_svg(drawing, 20, 10, "mm"), key = "stroke-width:";
    return std::stod(svg.substr(svg.find(key) + key.size()));
  };
  EXPECT_GT(width(DrawingLayer::kSection), width(DrawingLayer::kOutside));
  EXPECT_GT(width(DrawingLayer::kOutside), width(DrawingLayer::kInside));
  EXPECT_GT(width(DrawingLayer::kInside), width(DrawingLayer::kSize));
  EXPECT_EQ(width(DrawingLayer::kSize), width(DrawingLayer::kAxis));
}

TEST(PlanarMotion, TurnsAndShiftsOutlinesAndTexts) {
  Drawing part;
  part.loops.push_back({DrawingLayer::kCut, outline_of({{1, 0}, {2, 0}, {1, 1}})});
  part.texts.push_back({{1, 0}, 1.0, 0.0, "x"});
  Drawing drawing;
  add_moved(drawing, part, {Eigen::Vector2d(0, 1), Eigen::Vector2d(10, 20)});
  EXPECT_EQ(drawing.loops[0].points, outline_of({{10, 21}, {10, 22}, {9, 21}}));
  EXPECT_EQ(drawing.texts[0].position, Eigen::Vector2d(10, 21));
  EXPECT_NEAR(drawing.texts[0].degrees, 90.0, 1e-12);
}

TEST(DrawPanel, KeepsItsTextsInsideItself) {
  for (const char* name : {"dome", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, 9);
    CuttingOptions options;
    options.gap = 20.0;
    const CuttingPlan plan = make_cutting_plan(mesh, nullptr, options);
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto panel = draw_panel(plan, f);
      ASSERT_TRUE(panel) << name << f;
      EXPECT_EQ(panel->drawing.loops.size(), 3U);  // what is cut, the panel, the notch
      EXPECT_EQ(panel->drawing.texts[0].text, panel_name(f));
      EXPECT_EQ(panel->drawing.texts[1].text, "OUTSIDE UP mm");
      for (const DrawnText& text : panel->drawing.texts) {
        const Outline& cut = panel->pieces[0].corners;
        for (Eigen::Index k = 0; k < cut.cols(); ++k) {
          const Eigen::Vector2d a = cut.col(k), b = cut.col((k + 1) % cut.cols());
          const Eigen::Vector2d side = (b - a).normalized(), from = text.position - a;
          EXPECT_GT(side.x() * from.y() - side.y() * from.x(), 0.5 * text.height)
              << name << f << text.text;
        }
      }
    }
  }
}

TEST(DrawPanel, WritesAsHighAsAskedWhereThereIsRoom) {
  CuttingOptions options;
  options.text_height = 12.5;
  const CuttingPlan plan = make_cutting_plan(testing::quad_grid(3, 2), nullptr, options);
  int asked = 0;
  const auto panel = draw_panel(plan, 0);
  ASSERT_TRUE(panel);
  for (const DrawnText& text : panel->drawing.texts) {
    EXPECT_LE(text.height, 12.5);
    asked += text.height == 12.5 ? 1 : 0;
  }
  EXPECT_EQ(asked, 2);           // its name and its neighbour's; the note below the name is smaller
  options.text_height = 5000.0;  // no room
  const auto large = draw_panel(make_cutting_plan(testing::quad_grid(3, 2), nullptr, options), 0);
  for (const DrawnText& text : large->drawing.texts) EXPECT_LT(text.height, 250.0);
}

TEST(ArrangeOnSheets, OverlapsNothingAndStaysOnTheSheet) {
  const Eigen::Matrix3Xd random = testing::random_points(5, 400).cwiseAbs();
  std::vector<SheetItem> items;
  for (const auto p : random.colwise()) items.push_back({0.1 + p.x(), 0.05 + 0.5 * p.y()});
  const SheetSize sheet{5.0, 3.0, 0.02};
  const std::vector<SheetPlace> places = arrange_on_sheets(items, sheet);
  ASSERT_EQ(places.size(), items.size());
  const auto width = [&](std::size_t k) {
    return places[k].turned ? items[k].height : items[k].width;
  };
  const auto height = [&](std::size_t k) {
    return places[k].turned ? items[k].width : items[k].height;
  };
  constexpr double kRounding = 1e-12;
  for (std::size_t k = 0; k < places.size(); ++k) {
    ASSERT_GE(places[k].sheet, 0);
    EXPECT_GE(std::min(places[k].x, places[k].y), 0.02 - kRounding);
    EXPECT_LE(places[k].x + width(k), 4.98 + kRounding);
    EXPECT_LE(places[k].y + height(k), 2.98 + kRounding);
    for (std::size_t j = 0; j < k; ++j) {
      if (places[j].sheet != places[k].sheet) continue;
      const bool apart = places[j].x + width(j) + 0.02 <= places[k].x + kRounding ||
                         places[k].x + width(k) + 0.02 <= places[j].x + kRounding ||
                         places[j].y + height(j) + 0.02 <= places[k].y + kRounding ||
                         places[k].y + height(k) + 0.02 <= places[j].y + kRounding;
      EXPECT_TRUE(apart) << j << " " << k;
    }
  }
}

TEST(ArrangeOnSheets, TurnsWhatFitsUprightOnlyAndNamesWhatDoesNotFit) {
  const auto places = arrange_on_sheets({{4.0, 1.0}, {6.0, 1.0}, {2.0, 1.0}}, {3.0, 5.0, 0.0});
  EXPECT_TRUE(places[0].turned);
  EXPECT_EQ(places[0].sheet, 0);
  EXPECT_EQ(places[1].sheet, -1);
  EXPECT_FALSE(places[2].turned);
}

TEST(AssemblyMap, ShowsEveryPanelOnce) {
  const Mesh mesh = testing::sample("dome", 9);
  const std::string svg = write_assembly_map(make_cutting_plan(mesh, nullptr, {}));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::string label = std::string(">").append(panel_name(f)).append("<");
    EXPECT_EQ(occurrences(svg, label), 1U) << f;
  }
}

}  // namespace
}  // namespace planish
