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

/// A plan of 3 × 2 m on 400 × 267 mm: 1 : 10 is the first that fits.
TEST(StructureDrawings, TakeTheFirstUsualScaleThatFits) {
  EXPECT_EQ(header_of(testing::quad_grid(4, 3), {})["scale"], 10.0);
  DrawingOptions options;
  options.model_unit = "mm";
  EXPECT_EQ(header_of(testing::quad_grid(4, 3), options)["scale"], 1.0);
  options.model_unit = "km";
  EXPECT_EQ(header_of(testing::quad_grid(4, 3), options)["scale"], 10000.0);
  options.model_unit = "m";
  EXPECT_EQ(header_of(testing::quad_grid(9, 3), options)["scale"], 20.0);
  EXPECT_EQ(header_of(testing::quad_grid(10, 3), options)["scale"], 25.0);
  options.scale = 33.0;
  EXPECT_EQ(header_of(testing::quad_grid(10, 3), options)["scale"], 33.0);
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
}

}  // namespace
}  // namespace planish
