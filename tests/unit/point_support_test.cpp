// SPDX-License-Identifier: MIT
#include "planish/supports/point_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/scenes.hpp"

namespace planish {
namespace {

TEST(PointSupports, AreReadAndWritten) {
  for (const std::string text :
       {"level=z:boundary", "level=x:all", "level=y:3,4,5", "plane=0,0,1,3:boundary",
        "plane=0.10000000000000001,1e-30,-2,3.5:7", "line=0,0,0,1,0.25,0:1,2", "outline:boundary",
        "polyline:5,4,3", "polyline:5,4,3,5", "surface:boundary", "surface:3,4",
        "surface=0,0,0;1,0,0.5;1,1,0;0,1,0/0,1,2;0,2,3:boundary"}) {
    const auto support = parse_point_support(text);
    ASSERT_TRUE(support.has_value()) << text;
    const auto again = parse_point_support(point_support_text(*support));
    ASSERT_TRUE(again.has_value()) << point_support_text(*support);
    EXPECT_EQ(*support, *again);
  }
  EXPECT_EQ(*parse_point_support("level:4"), *parse_point_support("level=z:4"));
}

TEST(PointSupports, RefuseWhatIsNone) {
  for (const std::string text : {"",
                                 "level",
                                 "level:",
                                 "level=w:3",
                                 "level=:3",
                                 "level=xy:3",
                                 "level:-1",
                                 "level:3,",
                                 "level:3.5",
                                 "level:99999999999",
                                 "plane=0,0,1:3",
                                 "plane=0,0,1,2,3:3",
                                 "plane=a,0,0,1:3",
                                 "line=0,0,0,1,1:2",
                                 "sphere=1:2",
                                 "polyline:boundary",
                                 "polyline:all",
                                 "polyline=3:4",
                                 "polyline:",
                                 ":3",
                                 "=:3",
                                 "surface=:3",
                                 "surface=roof.obj:3",
                                 "surface=0,0,0;1,0,0/0,1:",
                                 "surface=0,0,0;1,0,0/0,1,x:3"}) {
    EXPECT_FALSE(parse_point_support(text).has_value()) << text;
  }
}

TEST(PointSupports, NameTheRuleTheyBreak) {
  const Mesh mesh = testing::quad_grid(4, 4, [](double x, double) { return x; });
  const auto problem = [&](const std::string& text) {
    return find_problem({*parse_point_support(text)}, mesh).value_or("");
  };
  EXPECT_EQ(problem("level:boundary"), "");
  EXPECT_EQ(problem("plane=1,0,-1,0:all"), "");
  EXPECT_NE(problem("plane=0,0,0,1:3").find("no length"), std::string::npos);
  EXPECT_NE(problem("line=0,0,0,0,0,0:3").find("no length"), std::string::npos);
  EXPECT_NE(problem("plane=0,0,inf,1:3").find("finite"), std::string::npos);
  EXPECT_NE(problem("level:16").find("no vertex 16"), std::string::npos);
  EXPECT_NE(problem("outline:5").find("vertex 5 is not on the boundary"), std::string::npos);
  EXPECT_EQ(problem("polyline:5,6,10,9,5"), "");
  EXPECT_NE(problem("polyline:5").find("2 vertices or more"), std::string::npos);
  EXPECT_NE(problem("polyline:5,6,5").find("comes twice"), std::string::npos);
  EXPECT_NE(problem("polyline:4,5,6,5").find("comes twice"), std::string::npos);
  EXPECT_NE(problem("polyline:5,6,11").find("no edge joins the vertices 6 and 11"),
            std::string::npos);
  EXPECT_NE(problem("polyline:5,16").find("no vertex 16"), std::string::npos);
  const std::string off = problem("plane=0,0,1,0:3");
  EXPECT_NE(off.find("plane=0,0,1,0: vertex 3 is 3 away"), std::string::npos) << off;
}

TEST(PointSupports, LinesMeetOnlyWhereOneEnds) {
  const Mesh mesh = testing::quad_grid(4, 4, [](double x, double) { return x; });
  const auto problem = [&](const std::string& one, const std::string& other) {
    return find_problem({*parse_point_support(one), *parse_point_support(other)}, mesh)
        .value_or("");
  };
  EXPECT_EQ(problem("polyline:4,5,6,7", "outline:boundary"), "");
  EXPECT_EQ(problem("outline:boundary", "polyline:4,5,6,7"), "");
  EXPECT_EQ(problem("polyline:4,5,6", "polyline:2,6,10"), "");
  EXPECT_NE(problem("polyline:4,5,6", "polyline:1,5,9").find("vertex 5 stands on another line"),
            std::string::npos);
  EXPECT_NE(problem("polyline:0,1,2", "outline:boundary").find("vertex 1"), std::string::npos);
  EXPECT_NE(problem("polyline:5,6", "surface:6").find("supports: surface: vertex 6"),
            std::string::npos);
}

TEST(PointSupports, MeasureTheDistanceAcross) {
  const Mesh mesh = testing::quad_grid(3, 3);
  Positions shape = mesh.positions;
  shape.col(4) += Eigen::Vector3d(0.3, 0.4, 1.2);
  const auto distance = [&](const std::string& text) {
    return largest_distance(*parse_point_support(text), mesh, shape);
  };
  EXPECT_DOUBLE_EQ(distance("level:all"), 1.2);
  EXPECT_DOUBLE_EQ(distance("level=x:4"), 0.3);
  EXPECT_DOUBLE_EQ(distance("plane=0,0,2,0:4"), 1.2);
  EXPECT_NEAR(distance("line=1,1,0,0,0,-3:4"), 0.5, 1e-15);
  EXPECT_DOUBLE_EQ(distance("level:boundary"), 0.0);
  shape.col(1) += Eigen::Vector3d(0.25, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(distance("outline:boundary"), 0.0);
  shape.col(1) += Eigen::Vector3d(0.0, 0.3, 0.4);
  EXPECT_DOUBLE_EQ(distance("outline:boundary"), 0.5);
  EXPECT_DOUBLE_EQ(distance("polyline:3,4,5"), std::hypot(0.4, 1.2));
}

}  // namespace
}  // namespace planish
