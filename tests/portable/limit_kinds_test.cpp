// SPDX-License-Identifier: MIT
/// What every kind of limit must keep: derivatives against differences, a base that it never
/// blocks, a text that reads back. A new kind is checked by being registered.
#include "planish/constraints/limit_kinds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "planish/constraints/inequality_rows.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/central_difference.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// A limit of each kind that these panels keep, but not by much.
StatedLimit limit_of(std::string_view name) {
  const std::string text = name == "fold"    ? "fold=+20"
                           : name == "angle" ? "angle=30:150"
                           : name == "edge"  ? "edge=0.5:1.6"
                           : name == "area"  ? "area=2.5"
                           : name == "sheet" ? "sheet=2.6x2.4"
                                             : "slide=0.3";
  return *parse_stated_limit(text);
}

template <class Row>
RowPoints<Row::kArity> points_of(const Row& row, const Positions& positions) {
  RowPoints<Row::kArity> points(3, static_cast<Eigen::Index>(row.vertices.size()));
  for (std::size_t k = 0; k < row.vertices.size(); ++k) {
    points.col(static_cast<Eigen::Index>(k)) = positions.col(row.vertices[k]);
  }
  return points;
}

template <class Row>
void expect_derivatives(const Row& row, const RowPoints<Row::kArity>& here) {
  constexpr double kStep = 1e-5;
  const auto slope = gradient(row, here);
  const auto curvature = hessian(row, here);
  using Points = RowPoints<Row::kArity>;
  const auto height = [&](const Points& points) { return value(row, points); };
  const auto rise = [&](const Points& points) { return gradient(row, points); };
  for (Eigen::Index k = 0; k < here.size(); ++k) {
    EXPECT_NEAR(slope.data()[k], testing::central_difference(here, k, kStep, height),
                1e-8 * (1.0 + slope.norm()));
    const Points column = testing::central_difference(here, k, kStep, rise);
    for (Eigen::Index l = 0; l < here.size(); ++l) {
      EXPECT_NEAR(curvature(l, k), column.data()[l], 1e-7 * (1.0 + curvature.norm()));
    }
  }
}

TEST(LimitKinds, HaveTheDerivativesOfTheirValues) {
  const Mesh mesh = testing::three_panels();
  const Adjacency adjacency = build_adjacency(mesh);
  LimitKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    SCOPED_TRACE(Kind::kName);
    const MeshLimits limits({mesh, adjacency, mesh.positions, 1.0}, {limit_of(Kind::kName)});
    int rows = 0;
    for (int f = 0; f < mesh.face_count(); ++f) {
      limits.for_each_row(f, [&](auto, const auto& row, int, int) {
        const Positions shaken =
            mesh.positions + 0.1 * testing::random_points(7u + static_cast<unsigned>(f),
                                                          static_cast<int>(mesh.vertex_count()));
        expect_derivatives(row, points_of(row, shaken));
        ++rows;
      });
    }
    EXPECT_GE(rows, 3);
  });
}

/// At rest no limit pushes, however badly the base breaks it, and it may not get worse.
TEST(LimitKinds, NeverBlockTheirBase) {
  const Mesh mesh = testing::three_panels();
  const Adjacency adjacency = build_adjacency(mesh);
  for (const char* text : {"fold=1", "fold=+1", "angle=85:95", "edge=1:1.01", "area=0.1",
                           "sheet=0.2x0.1", "fold=170", "edge=0:100", "area=100", "slide=0.001"}) {
    SCOPED_TRACE(text);
    const auto limit = parse_stated_limit(text);
    ASSERT_TRUE(limit);
    const MeshLimits limits({mesh, adjacency, mesh.positions, 1.0}, {*limit});
    int rows = 0;
    for (int f = 0; f < mesh.face_count(); ++f) {
      limits.for_each_row(f, [&](auto, const auto& row, int, int) {
        EXPECT_GE(row.scale.share(value(row, points_of(row, mesh.positions))), 100 * kLimitMargin);
        EXPECT_TRUE(std::isfinite(row.scale.slope));
        ++rows;
      });
    }
    EXPECT_GT(rows, 0);
  }
}

/// The unit of the points does not matter: the same shares.
TEST(LimitKinds, MeanTheSameInAnyUnit) {
  const Mesh mesh = testing::three_panels();
  const Adjacency adjacency = build_adjacency(mesh);
  const Positions metres = mesh.positions / 1000.0;
  LimitKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    SCOPED_TRACE(Kind::kName);
    const std::vector<StatedLimit> asked{limit_of(Kind::kName)};
    const MeshLimits in_model({mesh, adjacency, mesh.positions, 1.0}, asked);
    const MeshLimits in_solver({mesh, adjacency, metres, 1000.0}, asked);
    std::vector<double> model, solver;
    for (int f = 0; f < mesh.face_count(); ++f) {
      in_model.for_each_row(f, [&](auto, const auto& row, int, int) {
        model.push_back(row.scale.share(value(row, points_of(row, mesh.positions))));
      });
      in_solver.for_each_row(f, [&](auto, const auto& row, int, int) {
        solver.push_back(row.scale.share(value(row, points_of(row, metres))));
      });
    }
    ASSERT_EQ(model.size(), solver.size());
    for (std::size_t k = 0; k < model.size(); ++k) EXPECT_NEAR(model[k], solver[k], 1e-9);
  });
}

TEST(StatedLimit, ReadsBackWhatItWrites) {
  for (const char* text : {"fold=30", "fold=+2.5", "angle=60:120", "edge=0.1:1.25", "edge=0:3",
                           "area=2.75", "sheet=1.25x2.5", "slide=0.125"}) {
    const auto limit = parse_stated_limit(text);
    ASSERT_TRUE(limit) << text;
    EXPECT_EQ(stated_limit_text(*limit), text);
    EXPECT_EQ(find_problem(std::vector<StatedLimit>{*limit}), std::nullopt) << text;
  }
  EXPECT_EQ(stated_limit_text(*parse_stated_limit("sheet=3x2")), "sheet=2x3");
}

TEST(StatedLimit, IsRefusedWithItsName) {
  for (const char* text :
       {"", "fold", "fold=", "fold=x", "fold=1:2", "angle=60", "sheet=2", "bend=3",
        "angle=60:", "edge=1x2", "shape=on", "slide", "slide=0:1", "slide=10%"}) {
    EXPECT_FALSE(parse_stated_limit(text)) << text;
  }
  const auto problem_of = [](const char* text) {
    return find_problem(std::vector<StatedLimit>{*parse_stated_limit(text)}).value_or("");
  };
  EXPECT_EQ(problem_of("fold=0"), "bounds: fold must be greater than 0");
  EXPECT_EQ(problem_of("fold=181"), "bounds: fold must be at most 180 degrees");
  EXPECT_EQ(problem_of("angle=120:60"),
            "bounds: angle: the first number must be less than the second");
  EXPECT_EQ(problem_of("edge=-1:2"), "bounds: edge must be greater than 0");
  EXPECT_EQ(problem_of("area=inf"), "bounds: area must be finite");
  EXPECT_EQ(problem_of("edge=nan:1"), "bounds: edge must be finite");
  EXPECT_EQ(problem_of("slide=0"), "bounds: slide must be greater than 0");
  EXPECT_EQ(problem_of("slide=+1"), "bounds: slide cannot be relative");
  EXPECT_EQ(problem_of("area=+1"), "bounds: area cannot be relative");
}

}  // namespace
}  // namespace planish
