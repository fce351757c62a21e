// SPDX-License-Identifier: MIT
#include "planish/fabrication/structure_drawings.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

nlohmann::json header_of(const Mesh& mesh, const DrawingOptions& options) {
  return nlohmann::json::parse(write_drawings(mesh, options).header);
}

TEST(StructureDrawings, ArePlanElevationsAndSections) {
  DrawingOptions options;
  options.sections = {{Eigen::Vector3d::UnitX(), 1.5}, {Eigen::Vector3d::UnitZ(), 99.0}};
  const StructureDrawings drawings = write_drawings(testing::quad_grid(4, 3), options);
  EXPECT_EQ(drawings.missed, std::vector{1});
  const auto header = nlohmann::json::parse(drawings.header);
  EXPECT_EQ(header["drawings"],
            (nlohmann::json{"plan", "elevation-front", "elevation-right", "elevation-back",
                            "elevation-left", "section-1", "section-2"}));
  EXPECT_EQ(header["missed"], nlohmann::json{1});
  EXPECT_TRUE(write_drawings(testing::quad_grid(4, 3), options).zip == drawings.zip);
}

/// A plan of 3 × 2 m with its sizes on 400 × 277 mm: 1 : 10 is the first that fits.
TEST(StructureDrawings, TakeTheFirstUsualScaleThatFits) {
  EXPECT_EQ(header_of(testing::quad_grid(4, 3), {})["scale"], 10.0);
  DrawingOptions options;
  options.model_unit = "mm";
  EXPECT_EQ(header_of(testing::quad_grid(4, 3), options)["scale"], 1.0);
  options.model_unit = "km";
  EXPECT_EQ(header_of(testing::quad_grid(4, 3), options)["scale"], 10000.0);
  options.model_unit = "m";
  EXPECT_EQ(header_of(testing::quad_grid(8, 3), options)["scale"], 20.0);
  EXPECT_EQ(header_of(testing::quad_grid(9, 3), options)["scale"], 25.0);
  options.scale = 33.0;
  EXPECT_EQ(header_of(testing::quad_grid(10, 3), options)["scale"], 33.0);
}

/// A tall structure's plan need not be as small as its elevations.
TEST(StructureDrawings, MayEachHaveTheFirstScaleAtWhichItFits) {
  Mesh tall = testing::quad_grid(4, 3);  // 3 × 2
  for (Eigen::Index v = 0; v < tall.positions.cols(); ++v) {
    tall.positions(2, v) = 20.0 * tall.positions(0, v);
  }
  DrawingOptions options;
  const auto common = header_of(tall, options);
  EXPECT_EQ(common["scales"], nlohmann::json(std::vector<double>(5, common["scale"])));
  options.own_scales = true;
  const auto own = header_of(tall, options);
  EXPECT_TRUE(own["scale"].is_null());
  ASSERT_EQ(own["scales"].size(), own["drawings"].size());
  EXPECT_EQ(own["scales"][0], 10.0);
  EXPECT_EQ(own["scales"][1], common["scale"]);
  EXPECT_GT(common["scale"], 100.0);
}

/// And the levels of the lowest and the highest point, in the unit of the drawing.
TEST(StructureDrawings, ShowStatedAxesAndLevelsAndThoseOfTheStructure) {
  DrawingOptions options;
  const Mesh flat = testing::quad_grid(4, 3);
  EXPECT_EQ(header_of(flat, options)["axes"],
            nlohmann::json::parse(R"([{"axis": "z", "at": 0.0, "name": ""}])"));
  options.axes = {*parse_drawing_axis("x=1.5:A"), *parse_drawing_axis("z=-0.25:Eaves")};
  options.unit = "cm";
  EXPECT_EQ(header_of(flat, options)["axes"],
            nlohmann::json::parse(R"([{"axis": "x", "at": 150.0, "name": "A"},
                                      {"axis": "z", "at": -25.0, "name": "Eaves"},
                                      {"axis": "z", "at": 0.0, "name": ""}])"));
  options.axes = {*parse_drawing_axis("z=0:Floor")};
  EXPECT_EQ(header_of(flat, options)["axes"].size(), 1U) << "a level stands there already";
}

TEST(DrawingAxis, IsReadFromACoordinateANumberAndAName) {
  const auto axis = parse_drawing_axis("y=-4.5:B:1");
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->coordinate, 1);
  EXPECT_EQ(axis->at, -4.5);
  EXPECT_EQ(axis->name, "B:1");
  EXPECT_EQ(parse_drawing_axis("z=3:")->name, "");
  for (const char* text : {"", "x", "x=", "x=:A", "w=1", "x=nan", "x=inf:A", "x =1", "xy=1"}) {
    EXPECT_FALSE(parse_drawing_axis(text)) << text;
  }
}

/// Millimetres that were meant for a mesh in metres would leave a dot of it.
TEST(DrawingOptions, AreRefusedWithAnAxisFarOffTheStructure) {
  const Mesh flat = testing::quad_grid(4, 3);  // 3 × 2
  DrawingOptions options;
  for (const char* near : {"x=33", "x=-30", "z=30", "y=2"}) {
    options.axes = {*parse_drawing_axis(near)};
    EXPECT_FALSE(find_problem(options, flat)) << near;
  }
  for (const char* far : {"x=1500:A", "y=-30.1", "z=3200"}) {
    options.axes = {*parse_drawing_axis("x=1"), *parse_drawing_axis(far)};
    const auto problem = find_problem(options, flat);
    ASSERT_TRUE(problem) << far;
    EXPECT_EQ(problem->find("axis " + std::string(far).substr(0, 2)), 0U) << *problem;
    EXPECT_NE(problem->find("in the unit of the model, m"), std::string::npos) << *problem;
  }
}

TEST(DrawingOptions, AreRefusedByName) {
  DrawingOptions options;
  EXPECT_FALSE(find_problem(options));
  options.unit = "yard";
  EXPECT_NE(find_problem(options)->find("unit"), std::string::npos);
  options = {};
  options.scale = -1.0;
  EXPECT_NE(find_problem(options)->find("scale"), std::string::npos);
  options = {};
  options.sections = {{Eigen::Vector3d::Zero(), 0.0}};
  EXPECT_NE(find_problem(options)->find("section"), std::string::npos);
  options = {};
  options.axes = {{3, 0.0, "A"}};
  EXPECT_NE(find_problem(options)->find("axis"), std::string::npos);
}

}  // namespace
}  // namespace planish
