// SPDX-License-Identifier: MIT
#include "planish/fabrication/cutting_package.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "planish/fabrication/assembly_map.hpp"
#include "planish/fabrication/type_table.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// The names in the directory of an archive.
std::vector<std::string> names_in(const std::string& zip) {
  const auto number = [&](std::size_t at, int size) {
    std::size_t value = 0;
    for (int k = size - 1; k >= 0; --k) {
      value = value << 8 | static_cast<unsigned char>(zip.at(at + static_cast<std::size_t>(k)));
    }
    return value;
  };
  std::vector<std::string> names;
  std::size_t entry = number(zip.size() - 6, 4);
  while (entry < zip.size() - 22) {
    names.push_back(zip.substr(entry + 46, number(entry + 28, 2)));
    entry += 46 + names.back().size();
  }
  return names;
}

struct WholePackage : CuttingPackage {
  std::string zip;
};

WholePackage whole_package(const Mesh& mesh, const Mesh* base, const CuttingOptions& options) {
  std::string zip;
  const auto keep = [&](std::string_view piece) { zip += piece; };
  return {write_cutting_package(mesh, base, options, keep), zip};
}

TEST(CuttingPackage, HoldsTablesDrawingsSheetsAndAMap) {
  CuttingOptions options;
  options.sheet_width = 3000.0;
  options.sheet_height = 2000.0;
  const WholePackage package = whole_package(testing::quad_grid(4, 3), nullptr, options);
  EXPECT_EQ(
      names_in(package.zip),
      (std::vector<std::string>{
          "package.json", "panels.csv", "edges.csv", "nodes.csv", "map.svg", "labels.html",
          "panels-mm.dxf", "panels/P-0001-mm.dxf", "panels/P-0002-mm.dxf", "panels/P-0003-mm.dxf",
          "panels/P-0004-mm.dxf", "panels/P-0005-mm.dxf", "panels/P-0006-mm.dxf",
          "sheets/sheet-001-mm.dxf", "sheets/sheet-001-mm.svg", "sheets/sheet-002-mm.dxf",
          "sheets/sheet-002-mm.svg", "sheets/sheet-003-mm.dxf", "sheets/sheet-003-mm.svg"}));
  EXPECT_EQ(package.report.sheets, 3);  // two squares of a metre on each
  EXPECT_NEAR(package.report.used_fraction, 1.0 / 3.0, 1e-12);
  const auto header = nlohmann::json::parse(package.header);
  EXPECT_EQ(header["format"], "planish-cutting-package");
  EXPECT_EQ(header["counts"]["edges"], 17);
  EXPECT_TRUE(header["remake"].is_null());
}

TEST(CuttingPackage, ByTypeHasQuantitiesOfBarsAndNodesAndAMapOfBoth) {
  CuttingOptions options;
  options.types = TypeOptions{};
  options.types->within = 1.0;
  options.by_type = true;
  const CuttingPlan plan = make_cutting_plan(testing::quad_grid(4, 3), nullptr, options);
  const auto bars = nlohmann::json::parse(bar_type_table(plan).json);
  const auto nodes = nlohmann::json::parse(node_type_table(plan).json);
  int bar_count = 0, node_count = 0;
  double length = 0.0;
  for (const auto& row : bars) {
    bar_count += row["bars"].get<int>();
    length += row["length_of_all"].get<double>();
    EXPECT_LE(row["length_min"], row["length_max"]);
  }
  for (const auto& row : nodes) node_count += row["nodes"].get<int>();
  EXPECT_EQ(bar_count, 17);
  EXPECT_EQ(node_count, 12);
  double all = 0.0;
  for (const Joint& joint : plan.joints.joints) all += joint.length;
  EXPECT_NEAR(length, all, 1e-9 * all);
  EXPECT_EQ(nodes[0]["type"], "NT-0001");
  const std::string map = write_assembly_map(plan);
  for (const char* name : {">P-0006<", ">T-0001<", ">N-0001<", ">N-0012<"}) {
    EXPECT_NE(map.find(name), std::string::npos) << name;
  }
  const WholePackage package = whole_package(testing::quad_grid(4, 3), nullptr, options);
  EXPECT_NE(package.zip.find("bar-types.csv"), std::string::npos);
  EXPECT_NE(package.zip.find("node-types.csv"), std::string::npos);
}

TEST(CuttingPackage, IsTheSameBytesAgain) {
  const Mesh mesh = testing::sample("trihex", 7);
  CuttingOptions options;
  options.sheet_width = options.sheet_height = 4000.0;
  EXPECT_TRUE(whole_package(mesh, &mesh, options).zip == whole_package(mesh, &mesh, options).zip);
}

TEST(CuttingPackage, DrawsWhatIsInItsScope) {
  const Mesh base = testing::quad_grid(4, 2);
  Mesh mesh = base;
  mesh.positions(2, 3) = mesh.positions(2, 7) = 0.25;
  CuttingOptions options;
  options.remake_only = true;
  const WholePackage remade = whole_package(mesh, &base, options);
  EXPECT_EQ(remade.report.drawn, 2);
  const auto names = names_in(remade.zip);
  EXPECT_EQ(std::count(names.begin(), names.end(), "panels/P-0001-mm.dxf"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "panels/P-0002-mm.dxf"), 1);
  EXPECT_EQ(nlohmann::ordered_json::parse(remade.header)["remake"].dump(),
            R"({"outline":1,"bevel":1,"new":0,"nodes_moved":2,"nodes_arms":2,"nodes_new":0})");
  options = {};
  options.panels = {0};
  EXPECT_EQ(whole_package(mesh, nullptr, options).report.drawn, 1);
}

TEST(CuttingPackage, NamesWhatItCannotDraw) {
  const Mesh mesh =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.05, 0, 0}, {1.05, 1, 0}},
                         {{0, 1, 2, 3}, {1, 4, 5, 2}});
  CuttingOptions options;
  options.gap = 60.0;
  options.sheet_width = options.sheet_height = 500.0;
  const WholePackage package = whole_package(mesh, nullptr, options);
  EXPECT_EQ(package.report.vanished, std::vector{1});
  EXPECT_EQ(package.report.oversize, std::vector{0});
  EXPECT_EQ(package.report.sheets, 0);
  EXPECT_EQ(nlohmann::json::parse(package.header)["vanished"], nlohmann::json{"P-0002"});
}

}  // namespace
}  // namespace planish
