// SPDX-License-Identifier: MIT
#include "planish/fabrication/ifc.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

IfcModel model_of(const Mesh& mesh, const Mesh* base = nullptr,
                  const CuttingOptions& options = {}) {
  return write_ifc(make_cutting_plan(mesh, base, options));
}

std::vector<std::string> all_of(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

std::vector<std::string> identifiers(const std::string& text) {
  return all_of(text, R"(=IFC[A-Z]+\('([0-9A-Za-z_$]{22})',)");
}

TEST(Ifc, HasAPlateForEachPanelOverSharedPoints) {
  const Mesh mesh = testing::sample("trihex", 6);
  const IfcModel model = model_of(mesh);
  EXPECT_EQ(model.report.drawn, mesh.face_count());
  EXPECT_EQ(all_of(model.text, "(=IFCPLATE)").size(), static_cast<std::size_t>(mesh.face_count()));
  EXPECT_EQ(all_of(model.text, "(=IFCCARTESIANPOINTLIST3D)").size(), 1U);
  EXPECT_EQ(all_of(model.text, "(=IFCCURTAINWALL)").size(), 1U);
  const auto faces = all_of(model.text, R"(=IFCINDEXEDPOLYGONALFACE\(\(([0-9,]+)\)\))");
  ASSERT_EQ(faces.size(), static_cast<std::size_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::string expected;
    for (const int v : mesh.face(f)) {
      if (!expected.empty()) expected += ',';
      expected += std::to_string(v + 1);
    }
    EXPECT_EQ(faces[static_cast<std::size_t>(f)], expected);
  }
}

TEST(Ifc, HasATypeForPlatesThatAreAlike) {
  const Mesh mesh = testing::sample("vault", 8);
  CuttingOptions options;
  options.types.emplace();
  options.types->within = 1.0;  // mm
  const CuttingPlan plan = make_cutting_plan(mesh, nullptr, options);
  const IfcModel model = write_ifc(plan);
  const std::vector<PanelType>& types = plan.types->panels.types;
  ASSERT_LT(types.size(), static_cast<std::size_t>(mesh.face_count()));
  const auto names = all_of(model.text, R"(=IFCPLATETYPE\('[^']+',\$,'(T-\d+)',)");
  ASSERT_EQ(names.size(), types.size());
  const auto lists = all_of(model.text, R"(=IFCRELDEFINESBYTYPE\('[^']+',\$,\$,\$,\(([#0-9,]+)\))");
  ASSERT_EQ(lists.size(), types.size());
  std::set<std::string> plates;
  for (std::size_t k = 0; k < types.size(); ++k) {
    EXPECT_EQ(names[k], type_name(static_cast<int>(k)));
    const auto listed = all_of(lists[k], "(#[0-9]+)");
    EXPECT_EQ(listed.size(), types[k].panels.size());
    plates.insert(listed.begin(), listed.end());
  }
  const auto all = all_of(model.text, "(#[0-9]+)=IFCPLATE\\(");
  EXPECT_EQ(plates, std::set<std::string>(all.begin(), all.end()));
  EXPECT_EQ(all_of(model_of(mesh).text, "(=IFCPLATETYPE)").size(), 0U);
}

TEST(Ifc, IdentifiersAreOfTheStandardDifferFromEachOtherAndStayInAnEdit) {
  const Mesh base = testing::sample("vault", 8);
  Mesh mesh = base;
  mesh.positions(2, 20) += 0.1;
  const auto before = identifiers(model_of(base).text);
  EXPECT_EQ(before.size(), 8U + 3U * static_cast<std::size_t>(base.face_count()));
  EXPECT_EQ(std::set(before.begin(), before.end()).size(), before.size());
  for (const std::string& id : before) EXPECT_LE(id[0], '3') << id;  // 128 bits, not 132
  EXPECT_EQ(identifiers(model_of(mesh, &base).text), before);
  CuttingOptions solid;
  solid.thickness = 8.0;
  EXPECT_EQ(identifiers(model_of(mesh, &base, solid).text), before);
  const auto other = identifiers(model_of(mesh).text);  // another design
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NE(other[k], before[k]);
}

TEST(Ifc, WritesAnyNameAndUnit) {
  CuttingOptions options;
  options.name = "Dôme d'été \\ 𝄞";
  options.unit = "in";
  const IfcModel model = model_of(testing::quad_grid(2, 2), nullptr, options);
  EXPECT_NE(
      model.text.find(R"('D\X2\00F4\X0\me d''\X2\00E9\X0\t\X2\00E9\X0\ \\ \X4\0001D11E\X0\')"),
      std::string::npos);
  EXPECT_NE(model.text.find("IFCLENGTHMEASURE(0.0254)"), std::string::npos);
  EXPECT_NE(model.text.find("IFCAREAMEASURE(1.)"), std::string::npos) << "areas are square metres";
}

TEST(Ifc, APlateThatFallsApartHasAShapeForEachPiece) {
  const Mesh mesh = testing::make_mesh({{0, 0, 0},
                                        {1, 0, 0},
                                        {1, 0.495, 0},
                                        {2, 0.495, 0},
                                        {2, 0, 0},
                                        {3, 0, 0},
                                        {3, 1, 0},
                                        {2, 1, 0},
                                        {2, 0.505, 0},
                                        {1, 0.505, 0},
                                        {1, 1, 0},
                                        {0, 1, 0}},
                                       {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
  CuttingOptions options;
  options.gap = 20.0;
  for (const double thickness : {0.0, 8.0}) {
    options.thickness = thickness;
    const IfcModel model = model_of(mesh, nullptr, options);
    EXPECT_EQ(model.report.drawn, 1);
    ASSERT_EQ(model.report.apart.size(), 1U);
    EXPECT_EQ(model.report.apart[0].pieces, 2);
    const std::string shape = thickness > 0.0 ? "=IFCEXTRUDEDAREASOLID(" : "=IFCPOLYGONALFACESET(";
    const std::size_t first = model.text.find(shape);
    ASSERT_NE(first, std::string::npos);
    EXPECT_NE(model.text.find(shape, first + 1), std::string::npos);
  }
}

TEST(Ifc, LeavesOutWhatTheGapLeavesNothingOfAndSaysSo) {
  const Mesh mesh =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.05, 0, 0}, {1.05, 1, 0}},
                         {{0, 1, 2, 3}, {1, 4, 5, 2}});
  CuttingOptions options;
  options.gap = 60.0;
  const IfcModel model = model_of(mesh, nullptr, options);
  EXPECT_EQ(model.report.vanished, std::vector{1});
  EXPECT_EQ(model.report.drawn, 1);
  EXPECT_EQ(nlohmann::json::parse(model.header)["vanished"], nlohmann::json{"P-0002"});
  options.gap = 0.0;
  options.panels = {1};
  EXPECT_EQ(model_of(mesh, nullptr, options).report.drawn, 1);
}

}  // namespace
}  // namespace planish
