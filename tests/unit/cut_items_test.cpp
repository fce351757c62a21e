// SPDX-License-Identifier: MIT
#include "planish/fabrication/cut_items.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "planish/fabrication/labels.hpp"
#include "planish/fabrication/type_table.hpp"
#include "planish/numeric/index.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// A plan in mm whose templates fit within `within`.
CuttingPlan by_type(const Mesh& mesh, double within, bool mirrored = true) {
  CuttingOptions options;
  options.types.emplace();
  options.types->within = within;
  options.types->mirrored = mirrored;
  options.by_type = true;
  EXPECT_FALSE(find_problem(options, mesh, false).has_value());
  return make_cutting_plan(mesh, nullptr, options);
}

TEST(CutItems, AreThePanelsInTheirOrder) {
  const Mesh mesh = testing::quad_grid(4, 3);
  CuttingReport report;
  const auto items = cut_items(make_cutting_plan(mesh, nullptr, {}), report);
  ASSERT_EQ(items.size(), 6u);
  EXPECT_EQ(report.drawn, 6);
  for (int f = 0; f < 6; ++f) {
    EXPECT_EQ(items[at(f)].name, panel_name(f));
    EXPECT_EQ(items[at(f)].faces, std::vector<int>{f});
  }
}

TEST(CutItems, ByTypeAreOneTemplateATypeAndAPieceForEveryPanel) {
  for (const char* name : {"vault", "hex", "trihex", "roof", "freeform"}) {
    const Mesh mesh = testing::sample(name, 10);
    const CuttingPlan plan = by_type(mesh, 20.0);
    CuttingReport report;
    const auto items = cut_items(plan, report);
    EXPECT_EQ(items.size(), plan.types->panels.types.size()) << name;
    EXPECT_LT(items.size(), at(mesh.face_count())) << name;
    EXPECT_EQ(report.drawn, mesh.face_count()) << name;
    std::set<int> cut;
    for (std::size_t k = 0; k < items.size(); ++k) {
      EXPECT_EQ(items[k].name, type_name(static_cast<int>(k)));
      EXPECT_EQ(items[k].faces, plan.types->panels.types[k].panels);
      EXPECT_NEAR(area_of(items[k].panel.pieces), area_of(plan.types->panels.types[k].outline),
                  1e-3);
      cut.insert(items[k].faces.begin(), items[k].faces.end());
    }
    EXPECT_EQ(cut.size(), at(mesh.face_count())) << name;
  }
}

TEST(CutItems, ByTypeSayHowManyAndHowManyTurnedOver) {
  const CuttingPlan plan = by_type(testing::sample("vault", 10), 20.0);
  CuttingReport report;
  int turned_over = 0;
  for (const CutItem& item : cut_items(plan, report)) {
    const auto& members = plan.types->panels.panels;
    const auto turned = std::count_if(item.faces.begin(), item.faces.end(),
                                      [&](int face) { return members[at(face)].mirrored; });
    turned_over += static_cast<int>(turned);
    std::string side = std::to_string(item.faces.size()) + " IN ALL ";
    side += turned == 0 ? "OUTSIDE UP mm" : std::to_string(turned) + " TURNED OVER mm";
    const auto& texts = item.panel.drawing.texts;
    ASSERT_EQ(texts.size(), 2u);
    EXPECT_EQ(texts[0].text, item.name);
    EXPECT_EQ(texts[1].text, side);
  }
  EXPECT_GT(turned_over, 0);
}

TEST(CutItems, ByTypeDrawOnlyWhatIsInTheScope) {
  const Mesh mesh = testing::quad_grid(4, 3);
  CuttingOptions options;
  options.types.emplace();
  options.types->within = 1.0;
  options.by_type = true;
  options.panels = {1, 4};
  CuttingReport report;
  const auto items = cut_items(make_cutting_plan(mesh, nullptr, options), report);
  ASSERT_EQ(items.size(), 1u);
  EXPECT_EQ(items[0].faces, (std::vector<int>{1, 4}));
  EXPECT_EQ(report.drawn, 2);
}

TEST(CutItems, OfATypeThatTheGapTakesAreVanishedPanels) {
  CuttingOptions options;
  options.types.emplace();
  options.types->within = 1.0;
  options.by_type = true;
  options.gap = 2500.0;
  CuttingReport report;
  EXPECT_TRUE(
      cut_items(make_cutting_plan(testing::quad_grid(4, 3), nullptr, options), report).empty());
  EXPECT_EQ(report.vanished, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(report.drawn, 0);
}

TEST(CutItems, LieOnSheetsAPieceForEveryPanel) {
  CuttingPlan plan = by_type(testing::quad_grid(4, 3), 1.0);
  plan.options.sheet_width = 3000.0;
  plan.options.sheet_height = 2000.0;
  CuttingReport report;
  const auto items = cut_items(plan, report);
  ASSERT_EQ(items.size(), 1u);
  const auto placed = place_pieces(plan, items, report);
  ASSERT_EQ(placed.size(), 6u);
  EXPECT_EQ(report.sheets, 3);  // two squares of a metre on each
  EXPECT_NEAR(report.used_fraction, 1.0 / 3.0, 1e-12);
  plan.options.sheet_width = plan.options.sheet_height = 500.0;
  CuttingReport small;
  EXPECT_TRUE(place_pieces(plan, items, small).empty());
  EXPECT_EQ(small.oversize, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(small.used_fraction, 0.0);
}

TEST(CutItems, ByTypeNeedTypesAndTheJointThatTheyAreFor) {
  const Mesh mesh = testing::quad_grid(3, 3);
  CuttingOptions options;
  options.by_type = true;
  EXPECT_TRUE(find_problem(options, mesh, false).has_value());
  options.types.emplace();
  options.types->joint = JointRange{6.0, 14.0};
  EXPECT_TRUE(find_problem(options, mesh, false).has_value());
  options.gap = 10.0;
  EXPECT_FALSE(find_problem(options, mesh, false).has_value());
}

TEST(TemplateTable, HoldsTheQuantities) {
  const CuttingPlan plan = by_type(testing::sample("hex", 8), 20.0);
  const auto rows = nlohmann::json::parse(template_table(plan).json);
  ASSERT_EQ(rows.size(), plan.types->panels.types.size());
  int panels = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const PanelType& type = plan.types->panels.types[k];
    EXPECT_EQ(rows[k]["type"], type_name(static_cast<int>(k)));
    EXPECT_EQ(rows[k]["panels"], type.panels.size());
    EXPECT_EQ(rows[k]["worst_fit"], type.worst);
    EXPECT_DOUBLE_EQ(rows[k]["area_of_all"].get<double>(),
                     rows[k]["area"].get<double>() * static_cast<double>(type.panels.size()));
    EXPECT_EQ(rows[k]["edge_lengths"].size(), rows[k]["corners"].get<std::size_t>());
    panels += rows[k]["panels"].get<int>();
  }
  EXPECT_EQ(panels, plan.mesh.face_count());
}

TEST(Labels, ByTypeSayAtWhichNodeTheTriangleBelongs) {
  const CuttingPlan plan = by_type(testing::sample("vault", 8), 20.0);
  const auto rows = nlohmann::json::parse(type_table(plan).json);
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    const std::string html = write_labels(plan, {f}, {});
    // Laid as the table says, corner 0 of the template, which is the origin, is the node's corner.
    const auto& placement = rows[at(f)]["placement"];
    const Eigen::Vector2d marked(placement[4].get<double>(), placement[5].get<double>());
    const Outline& outline = plan.panels[at(f)].outline;
    Eigen::Index corner = 0;
    EXPECT_LE((outline.colwise() - marked).colwise().norm().minCoeff(&corner), 20.0);
    const int vertex = plan.mesh.face(f)[at(corner)];
    const std::string turned = rows[at(f)]["turned_over"] == "yes" ? ", turned over" : "";
    EXPECT_NE(html.find("<p>" + rows[at(f)]["type"].get<std::string>() + turned +
                        "; its triangle belongs at " + node_name(plan.node_of_vertex[at(vertex)]) +
                        ".</p>"),
              std::string::npos)
        << html;
  }
}

}  // namespace
}  // namespace planish
