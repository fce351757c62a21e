// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../../core/src/numeric/trigonometry.hpp"
#include "planish/edit/handle_edit.hpp"
#include "support/mesh_builders.hpp"
#include "support/offset_checks.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// A roof: two panels of 2 × 1 m that rise by 45 degrees to a ridge, and a vertical gable.
Mesh ridge_roof() {
  const double h = std::sqrt(0.5);
  return testing::make_mesh(
      {{0, 0, 0}, {2, 0, 0}, {2, h, h}, {0, h, h}, {2, 2 * h, 0}, {0, 2 * h, 0}},
      {{0, 1, 2, 3}, {3, 2, 4, 5}, {1, 4, 2}});
}

TEST(PanelTables, MeasureARoof) {
  CuttingOptions options;
  options.thickness = 10.0;
  const CuttingPlan plan = make_cutting_plan(ridge_roof(), nullptr, options);
  const nlohmann::json panels = nlohmann::json::parse(panel_table(plan).json);
  ASSERT_EQ(panels.size(), 3U);
  const nlohmann::json& first = panels[0];
  EXPECT_EQ(first["panel"], "P-0001");
  EXPECT_EQ(first["nodes"], (nlohmann::json{"N-0001", "N-0002", "N-0003", "N-0004"}));
  EXPECT_EQ(first["edges"], (nlohmann::json{"E-0001", "E-0002", "E-0003", "E-0004"}));
  EXPECT_EQ(first["neighbours"], (nlohmann::json{"-", "P-0003", "P-0002", "-"}));
  EXPECT_NEAR(first["area"].get<double>(), 2e6, 1e-6);
  EXPECT_NEAR(first["perimeter"].get<double>(), 6000.0, 1e-9);
  EXPECT_NEAR(first["volume"].get<double>(), 2e7, 1e-5);
  EXPECT_NEAR(first["rectangle"][0].get<double>(), 2000.0, 1e-9);
  EXPECT_NEAR(first["rectangle"][1].get<double>(), 1000.0, 1e-9);
  for (const nlohmann::json& angle : first["angles"]) EXPECT_NEAR(angle.get<double>(), 90.0, 1e-12);
  EXPECT_EQ(first["change"], "");
  const nlohmann::json edges = nlohmann::json::parse(edge_table(plan).json);
  EXPECT_EQ(edges[2]["panel"], "P-0001");
  EXPECT_EQ(edges[2]["neighbour"], "P-0002");
  EXPECT_NEAR(edges[2]["dihedral"].get<double>(), 90.0, 1e-12);
  EXPECT_NEAR(edges[2]["mitre"].get<double>(), 45.0, 1e-12);
  EXPECT_EQ(edges[2]["fold"], "convex");
  EXPECT_EQ(edges[0]["fold"], "boundary");
  EXPECT_EQ(edges[0]["neighbour_side"], -1);
}

/// At the ridge's end: the ridge, a rafter on each side of the gable.
TEST(PanelTables, MeasureANode) {
  const CuttingPlan plan = make_cutting_plan(ridge_roof(), nullptr, {});
  const nlohmann::json node = nlohmann::json::parse(node_table(plan).json)[2];
  EXPECT_EQ(node["vertex"], 2);
  EXPECT_EQ(node["valence"], 3);
  EXPECT_EQ(node["azimuths"].size(), 3U);
  EXPECT_EQ(node["azimuths"][0], 0.0);
  const Eigen::Vector3d axis(node["axis"][0], node["axis"][1], node["axis"][2]);
  EXPECT_NEAR(axis.norm(), 1.0, 1e-15);
  EXPECT_GT(axis.z(), 0.0);
  EXPECT_NEAR(axis.y(), 0.0, 1e-15);
  for (std::size_t k = 0; k < 3; ++k) {
    const nlohmann::json edge = nlohmann::json::parse(
        edge_table(plan).json)[std::stoul(node["arms"][k].get<std::string>().substr(2)) - 1];
    const int other = edge["from"] == "N-0003"
                          ? std::stoi(edge["to"].get<std::string>().substr(2))
                          : std::stoi(edge["from"].get<std::string>().substr(2));
    const Eigen::Vector3d arm =
        (plan.mesh.positions.col(plan.vertex_of_node[static_cast<std::size_t>(other - 1)]) -
         plan.mesh.positions.col(2))
            .normalized();
    EXPECT_NEAR(std::sin(node["elevations"][k].get<double>() * kPi / 180.0), axis.dot(arm), 1e-12);
  }
}

std::vector<Eigen::Vector3d> node_axes(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> axes;
  const std::string table = node_table(make_cutting_plan(mesh, nullptr, {})).json;
  for (const nlohmann::json& node : nlohmann::json::parse(table)) {
    axes.emplace_back(node["axis"][0], node["axis"][1], node["axis"][2]);
  }
  return axes;
}

/// Two slopes and a gable, moved outwards by 1, meet at (1, 0, √2) from the ridge's end; the other
/// end has two planes, and so the mean of both areas.
TEST(PanelTables, AxesAreThoseOfTheOffsetWhereThereIsOne) {
  const std::vector<Eigen::Vector3d> axes = node_axes(ridge_roof());
  EXPECT_LT((axes[2] - Eigen::Vector3d(1.0, 0.0, std::sqrt(2.0)).normalized()).norm(), 1e-14);
  EXPECT_LT((axes[3] - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
  const Mesh hex = testing::sample("hex", 9);
  const std::vector<Eigen::Vector3d> there = node_axes(hex);
  const MeshOffset offset = testing::offset_of(hex, 1.0);
  const CuttingPlan plan = make_cutting_plan(hex, nullptr, {});
  int compared = 0;
  for (std::size_t node = 0; node < there.size(); ++node) {
    const int v = plan.vertex_of_node[node];
    if (std::count(hex.face_vertices.begin(), hex.face_vertices.end(), v) < 3) continue;
    EXPECT_LT((there[node] - offset.axes.col(v).normalized()).norm(), 1e-9) << v;
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(PanelTables, CsvAndJsonHoldTheSameCells) {
  const CuttingPlan plan = make_cutting_plan(testing::sample("trihex", 6), nullptr, {});
  for (const TableText& table : {panel_table(plan), edge_table(plan), node_table(plan)}) {
    const auto rows = nlohmann::ordered_json::parse(table.json);
    std::string csv;
    for (const auto& [field, value] : rows[0].items()) csv += (csv.empty() ? "" : ",") + field;
    for (const auto& row : rows) {
      std::string line;
      for (const auto& [field, value] : row.items()) {
        if (!line.empty()) line += ',';
        std::string cell = value.is_string() ? value.get<std::string>() : value.dump();
        cell.erase(std::remove_if(cell.begin(), cell.end(),
                                  [](char c) { return c == '[' || c == ']' || c == '"'; }),
                   cell.end());
        std::replace(cell.begin(), cell.end(), ',', ' ');
        line += cell;
      }
      csv += "\r\n" + line;
    }
    // Numbers are written in other ways by the two; whoever reads them gets the same bits.
    EXPECT_EQ(std::count(table.csv.begin(), table.csv.end(), ','),
              std::count(csv.begin(), csv.end(), ','));
    EXPECT_EQ(std::count(table.csv.begin(), table.csv.end(), ' '),
              std::count(csv.begin(), csv.end(), ' '));
    EXPECT_EQ(table.csv.substr(0, table.csv.find('\r')), csv.substr(0, csv.find('\r')));
  }
}

TEST(PanelTables, AnEditTurnsNoOutline) {
  const Mesh base = testing::sample("vault", 12);
  Mesh mesh = base;
  mesh.positions = apply(base, solve_handle_edit(base, testing::pull(base, 66, {0, 0, 0.4})));
  const CuttingPlan before = make_cutting_plan(base, nullptr, {});
  const CuttingPlan after = make_cutting_plan(mesh, &base, {});
  for (std::size_t f = 0; f < before.panels.size(); ++f) {
    EXPECT_GT(before.panels[f].frame.x.dot(after.panels[f].frame.x), 0.5) << f;
    if (after.remake->panels[f] != PanelChange::kOutline) {
      EXPECT_EQ(before.panels[f].outline, after.panels[f].outline) << f;
    }
  }
}

TEST(CuttingOptions, AreRefusedByName) {
  const Mesh mesh = ridge_roof();
  CuttingOptions options;
  EXPECT_FALSE(find_problem(options, mesh, false));
  options.unit = "yard";
  EXPECT_NE(find_problem(options, mesh, false)->find("unit"), std::string::npos);
  options = {};
  options.gap = -1.0;
  EXPECT_NE(find_problem(options, mesh, false)->find("gap"), std::string::npos);
  options = {};
  options.thickness = std::nan("");
  EXPECT_NE(find_problem(options, mesh, false)->find("thickness"), std::string::npos);
  options = {};
  options.sheet_width = 100.0;
  EXPECT_NE(find_problem(options, mesh, false)->find("sheet"), std::string::npos);
  options = {};
  options.remake_only = true;
  EXPECT_NE(find_problem(options, mesh, false)->find("scope"), std::string::npos);
  EXPECT_FALSE(find_problem(options, mesh, true));
  options = {};
  options.panels = {3};
  EXPECT_NE(find_problem(options, mesh, true)->find("panel 3"), std::string::npos);
}

TEST(FlatPanel, HasTheSmallestRectangleAroundIt) {
  Outline outline(2, 4);
  const Eigen::Vector2d along(0.8, 0.6), up(-0.6, 0.8);
  outline << Eigen::Vector2d(1, 2), Eigen::Vector2d(1, 2) + 3 * along,
      Eigen::Vector2d(1, 2) + 3 * along + up, Eigen::Vector2d(1, 2) + up;
  const BoundingRectangle rectangle = bounding_rectangle(outline);
  EXPECT_NEAR(rectangle.width, 3.0, 1e-14);
  EXPECT_NEAR(rectangle.height, 1.0, 1e-14);
  EXPECT_LE((rectangle.corner - outline.col(0)).norm(), 1e-14);
  EXPECT_EQ(setting_out_corners(outline).size(), 3U);
  EXPECT_NEAR(interior_angle(outline, 2), kPi / 2, 1e-14);
  EXPECT_NEAR(area_of(outline), 3.0, 1e-14);
}

}  // namespace
}  // namespace planish
