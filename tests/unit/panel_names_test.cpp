// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/fabrication/ifc.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using NameList = std::vector<std::string>;

NameList names_of_all(const PanelNames& names, int count) {
  std::vector<int> panels;
  for (int f = 0; f < count; ++f) panels.push_back(f);
  return names.of(panels);
}

CutMesh grid_after(const Mesh& mesh, const std::vector<const char*>& texts) {
  std::vector<Cut> cuts;
  for (const char* text : texts) cuts.push_back(std::get<Cut>(parse_cut(text)));
  return std::get<CutMesh>(cut_mesh(mesh, cuts));
}

TEST(PanelNames, AreNumbersFromOne) {
  EXPECT_EQ(names_of_all({}, 2), (NameList{"P-0001", "P-0002"}));
  EXPECT_EQ(PanelNames().of(9999), "P-10000");
  EXPECT_TRUE(PanelNames().is_own_parent(3));
}

TEST(PanelNames, TellPartsByLetters) {
  const PanelNames names(std::vector<int>{0, 1, 2, 1, 1});
  EXPECT_EQ(names_of_all(names, 5),
            (NameList{"P-0001", "P-0002a", "P-0003", "P-0002b", "P-0002c"}));
  EXPECT_EQ(names.parent_of(4), "P-0002");
  EXPECT_TRUE(names.is_own_parent(2));
  EXPECT_FALSE(names.is_own_parent(1));
  const PanelNames many(std::vector<int>(28, 0));
  EXPECT_EQ(many.of(25), "P-0001z");
  EXPECT_EQ(many.of(27), "P-0001ab");
}

TEST(PanelNames, OfPartsStayWhereOneIsPartedAgain) {
  const Mesh mesh = testing::quad_grid(4, 3);
  const auto once = grid_after(mesh, {"split=1:1,6"});
  const auto twice = grid_after(mesh, {"split=1:1,6", "corner=1:1@0.5"});
  const PanelNames before(once.parents), after(twice.parents);
  for (int f = 0; f < once.mesh.face_count(); ++f) EXPECT_EQ(after.of(f), before.of(f));
  EXPECT_EQ(after.of(once.mesh.face_count()), "P-0002c");
}

TEST(PanelNames, StayWhereATrimClosesUpTheNumbers) {
  const auto cut = grid_after(testing::quad_grid(4, 3), {"trim=-1,0,0,-1"});
  const PanelNames names(cut.parents);
  ASSERT_LT(cut.mesh.face_count(), 6);
  for (int f = 0; f < cut.mesh.face_count(); ++f) {
    EXPECT_EQ(names.of(f), panel_name(cut.parents[static_cast<std::size_t>(f)]));
  }
}

TEST(PanelNames, AreInTablesAndModelsOfACutMesh) {
  const auto cut = grid_after(testing::quad_grid(4, 3), {"split=1:1,6"});
  CuttingOptions options;
  options.names = PanelNames(cut.parents);
  const CuttingPlan plan = make_cutting_plan(cut.mesh, nullptr, options);
  const std::string table = panel_table(plan).csv;
  EXPECT_EQ(table.substr(0, table.find(",change")), "panel,parent,face");
  EXPECT_NE(table.find("\nP-0002a,P-0002,1,"), std::string::npos);
  EXPECT_NE(table.find("\nP-0002b,P-0002,6,"), std::string::npos);
  EXPECT_NE(table.find("\nP-0003,P-0003,2,"), std::string::npos);
  EXPECT_NE(edge_table(plan).csv.find(",P-0002b,"), std::string::npos);
  const std::string model = write_ifc(plan).text;
  EXPECT_NE(model.find("'P-0002a'"), std::string::npos);
  EXPECT_EQ(model.find("'P-0007'"), std::string::npos);
}

}  // namespace
}  // namespace planish
