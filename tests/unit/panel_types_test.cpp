// SPDX-License-Identifier: MIT
// Types of panels, nodes and bars on meshes whose types are known.
#include "planish/fabrication/panel_types.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "planish/fabrication/bar_types.hpp"
#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/node_types.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "support/mesh_builders.hpp"
#include "support/offset_checks.hpp"
#include "support/scenes.hpp"
#include "support/type_checks.hpp"

namespace planish {
namespace {

using testing::make_mesh;
using testing::types_of;
using testing::types_within;

TypeOptions within(double distance, bool mirrored = false) {
  TypeOptions options;
  options.within = distance;
  options.mirrored = mirrored;
  return options;
}

/// Quads beside one another, each apart from the others: heights of its two sides.
Mesh strips(const std::vector<std::pair<double, double>>& heights) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const double x = 3.0 * static_cast<double>(k);
    const int first = static_cast<int>(points.size());
    points.insert(
        points.end(),
        {{x, 0, 0}, {x + 1.0, 0, 0}, {x + 1.0, heights[k].second, 0}, {x, heights[k].first, 0}});
    faces.push_back({first, first + 1, first + 2, first + 3});
  }
  return make_mesh(points, faces);
}

TEST(PanelTypes, OfACubeAreOne) {
  const PanelTypes types = types_within(testing::cube(), 1e-6);
  ASSERT_EQ(types.types.size(), 1u);
  EXPECT_EQ(types.types[0].panels.size(), 6u);
  EXPECT_EQ(types.seams.size(), 12u);
  EXPECT_NEAR(types.widths.min, 0.0, 1e-12);
  EXPECT_NEAR(types.widths.max, 0.0, 1e-12);
}

TEST(PanelTypes, OfMirrorImagesAreOneOnlyWhereAllowed) {
  // A quad without symmetry and its image.
  const Mesh mesh = make_mesh({{0, 0, 0},
                               {2, 0, 0},
                               {1.7, 1.2, 0},
                               {0.1, 0.9, 0},
                               {5, 0, 0},
                               {3, 0, 0},
                               {3.3, 1.2, 0},
                               {4.9, 0.9, 0}},
                              {{0, 1, 2, 3}, {4, 7, 6, 5}});
  EXPECT_EQ(types_of(mesh, within(1e-9)).types.size(), 2u);
  const PanelTypes types = types_of(mesh, within(1e-9, true));
  ASSERT_EQ(types.types.size(), 1u);
  EXPECT_NE(types.panels[0].mirrored, types.panels[1].mirrored);
  EXPECT_LE(testing::worst_fit(mesh, types), 1e-12);
}

TEST(PanelTypes, ShareATemplateBetweenThem) {
  // No panel is within 0.06 of both others, what lies between them is within that of all.
  const Mesh mesh = strips({{1.0, 1.0}, {1.1, 1.1}, {1.2, 1.2}});
  EXPECT_EQ(types_of(mesh, within(0.02)).types.size(), 3u);
  EXPECT_EQ(types_of(mesh, within(0.051)).types.size(), 1u);
  EXPECT_LE(testing::worst_fit(mesh, types_of(mesh, within(0.051))), 0.051);
}

TEST(PanelTypes, OfAnotherNumberOfCornersAreOthers) {
  EXPECT_EQ(types_of(testing::three_panels(), within(100.0)).types.size(), 3u);
}

TEST(PanelTypes, TellHowEachPanelLiesOnItsTemplate) {
  const Mesh mesh = testing::sample("trihex", 10);
  std::vector<FlatPanel> panels;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    panels.push_back(flatten_panel(mesh.positions, face, longest_side(mesh.positions, face)));
  }
  const PanelTypes types = find_panel_types(panels, joint_table(mesh), within(0.02, true));
  for (std::size_t f = 0; f < panels.size(); ++f) {
    const FamilyMember& member = types.panels[f];
    const Outline& outline = types.types[static_cast<std::size_t>(member.family)].outline;
    const int k = static_cast<int>(outline.cols());
    EXPECT_NEAR(member.rotation.determinant(), member.mirrored ? -1.0 : 1.0, 1e-12);
    double farthest = 0.0;
    for (int i = 0; i < k; ++i) {
      const Eigen::Vector2d laid =
          member.rotation * outline.col(member.template_column(i, k)) + member.shift;
      farthest = std::max(farthest, (laid - panels[f].outline.col(i)).norm());
    }
    EXPECT_NEAR(farthest, member.distance, 1e-12);
    EXPECT_LE(farthest, 0.02);
  }
}

TEST(PanelTypes, LieWithTheirLongestSideAlongX) {
  for (const PanelType& type : types_within(testing::sample("hex", 10), 0.01).types) {
    EXPECT_EQ(type.outline.col(0), Eigen::Vector2d::Zero());
    double longest = 0.0, along = 0.0;
    for (Eigen::Index k = 0; k < type.outline.cols(); ++k) {
      longest = std::max(longest, side_length(type.outline, k));
      const Eigen::Vector2d side =
          type.outline.col((k + 1) % type.outline.cols()) - type.outline.col(k);
      if (std::abs(side.y()) < 1e-9 && side.x() > 0.0) along = std::max(along, side.x());
    }
    EXPECT_NEAR(along, longest, 1e-8);
    EXPECT_GT(area_of(type.outline), 0.0);
  }
}

TEST(PanelTypes, KeepASeamInTheJointThatTheyAreAskedFor) {
  const Mesh mesh = testing::sample("vault", 12);
  TypeOptions options;
  options.joint = JointRange{0.01, 0.05};
  const PanelTypes types = types_of(mesh, options);
  EXPECT_DOUBLE_EQ(types.within, 0.01);
  EXPECT_DOUBLE_EQ(types.designed, 0.03);
  EXPECT_GE(types.widths.min, 0.01);
  EXPECT_LE(types.widths.max, 0.05);
  EXPECT_LT(types.types.size(), static_cast<std::size_t>(mesh.face_count()));
}

TEST(PanelTypes, AreInTheTableOfAPackageThatAsksForThem) {
  CuttingOptions options;
  const Mesh mesh = testing::sample("hex", 8);
  EXPECT_EQ(panel_table(make_cutting_plan(mesh, nullptr, options)).csv.find("turned_over"),
            std::string::npos);
  options.types = within(20.0, true);  // mm
  ASSERT_FALSE(find_problem(options, mesh, false).has_value());
  const CuttingPlan plan = make_cutting_plan(mesh, nullptr, options);
  const auto rows = nlohmann::json::parse(panel_table(plan).json);
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(mesh.face_count()));
  for (std::size_t f = 0; f < rows.size(); ++f) {
    const FamilyMember& member = plan.types->panels.panels[f];
    EXPECT_EQ(rows[f]["type"], type_name(member.family));
    EXPECT_EQ(rows[f]["turned_over"], member.mirrored ? "yes" : "no");
    EXPECT_EQ(rows[f]["fit"], member.distance);
    EXPECT_LE(member.distance, 20.0);
  }
  const auto nodes = nlohmann::json::parse(node_table(plan).json);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int vertex = plan.vertex_of_node[k];
    EXPECT_EQ(nodes[k]["type"],
              node_type_name(plan.types->nodes.of_vertex[static_cast<std::size_t>(vertex)]));
  }
  const auto edges = nlohmann::json::parse(edge_table(plan).json);
  ASSERT_EQ(edges.size(), plan.types->bars.of_joint.size());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    EXPECT_EQ(edges[k]["type"], bar_type_name(plan.types->bars.of_joint[k]));
  }
  options.types->within = 0.0;
  EXPECT_TRUE(find_problem(options, mesh, false).has_value());
}

TEST(PanelTypes, OfNoPanelsAreNone) {
  const PanelTypes types = find_panel_types({}, {}, within(1.0));
  EXPECT_TRUE(types.types.empty());
  EXPECT_TRUE(types.seams.empty());
}

TEST(PanelTypes, OfDegeneratePanelsAreFinite) {
  // Points at one place, panels on a line, a panel that crosses itself, coordinates of any size.
  for (const double scale : {1e-90, 1.0, 1e90}) {
    const Mesh mesh = make_mesh({scale * Eigen::Vector3d(0, 0, 0), scale * Eigen::Vector3d(1, 0, 0),
                                 scale * Eigen::Vector3d(2, 0, 0), scale * Eigen::Vector3d(2, 0, 0),
                                 scale * Eigen::Vector3d(0, 1, 0), scale * Eigen::Vector3d(1, 1, 0),
                                 scale * Eigen::Vector3d(2, 0, 0)},
                                {{0, 1, 2}, {1, 0, 4, 5}, {2, 3, 6}, {0, 5, 1, 4}, {2, 6, 5, 1}});
    for (const bool mirrored : {false, true}) {
      const PanelTypes types = types_of(mesh, within(0.01 * scale, mirrored));
      testing::expect_partition(mesh, types);
      for (const PanelType& type : types.types) {
        EXPECT_TRUE(type.outline.allFinite());
        EXPECT_LE(type.worst, 0.01 * scale);
      }
    }
  }
}

TEST(PanelTypes, RefuseWhatCannotBeMeant) {
  EXPECT_TRUE(find_problem(within(0.0)).has_value());
  EXPECT_TRUE(find_problem(within(-1.0)).has_value());
  EXPECT_TRUE(find_problem(within(std::nan(""))).has_value());
  EXPECT_FALSE(find_problem(within(1.0)).has_value());
  TypeOptions options;
  for (const auto& [min, max] : {std::pair(-1.0, 1.0), {2.0, 1.0}, {1.0, 1.0}, {0.0, HUGE_VAL}}) {
    options.joint = JointRange{min, max};
    EXPECT_TRUE(find_problem(options).has_value()) << min << " " << max;
  }
  options.joint = JointRange{0.0, 1.0};
  EXPECT_FALSE(find_problem(options).has_value());
  options.degrees = 0.0;
  EXPECT_TRUE(find_problem(options).has_value());
}

TEST(NodeTypes, OfACubeAreOneAndItsBarsToo) {
  const Mesh cube = testing::cube();
  const JointTable joints = joint_table(cube);
  EXPECT_EQ(find_node_types(cube, joints, 0.1, false).sizes, std::vector<int>{8});
  EXPECT_EQ(find_bar_types(joints, 1e-6, 0.1).sizes, std::vector<int>{12});
}

TEST(NodeTypes, OfAFlatGridAreInsideSideAndCorner) {
  const Mesh grid = testing::quad_grid(6, 5);
  const JointTable joints = joint_table(grid);
  const NodeTypes nodes = find_node_types(grid, joints, 0.1, false);
  EXPECT_EQ(nodes.sizes, (std::vector<int>{14, 12, 4}));
  // 49 edges, 18 of them on the boundary.
  EXPECT_EQ(find_bar_types(joints, 1e-6, 0.1).sizes, (std::vector<int>{31, 18}));
  for (const FamilyShape& cycle : node_cycles(grid, joints)) {
    double sum = 0.0;
    int open = 0;
    for (Eigen::Index k = 0; k < cycle.cols(); ++k) {
      if (cycle(0, k) < 0.0) {
        ++open;
      } else {
        sum += cycle(0, k);
      }
    }
    EXPECT_NEAR(sum, open == 0 ? 2.0 * M_PI : cycle.cols() == 2 ? M_PI / 2 : M_PI, 1e-12);
  }
}

TEST(NodeTypes, DoNotDependOnTheOrderOfPointsAndPanels) {
  for (const char* name : {"vault", "hex", "trihex", "roof"}) {
    const Mesh mesh = testing::sample(name, 14);
    const Mesh other = testing::renumbered(mesh, 7);
    for (const bool mirrored : {false, true}) {
      EXPECT_EQ(find_node_types(mesh, joint_table(mesh), 0.5, mirrored).sizes.size(),
                find_node_types(other, joint_table(other), 0.5, mirrored).sizes.size())
          << name;
    }
    EXPECT_EQ(find_bar_types(joint_table(mesh), 0.01, 0.5).sizes.size(),
              find_bar_types(joint_table(other), 0.01, 0.5).sizes.size())
        << name;
  }
}

TEST(NodeTypes, HaveAllTheirAnglesWithinTheTolerance) {
  const Mesh mesh = testing::sample("freeform", 12);
  const JointTable joints = joint_table(mesh);
  const double degrees = 2.0, radians = degrees * M_PI / 180.0;
  const NodeTypes types = find_node_types(mesh, joints, degrees, false);
  const std::vector<FamilyShape> cycles = node_cycles(mesh, joints);
  // Two nodes that are within the tolerance of one are within twice of each other.
  for (std::size_t a = 0; a < cycles.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (types.of_vertex[a] != types.of_vertex[b]) continue;
      const Eigen::Index k = cycles[a].cols();
      ASSERT_EQ(k, cycles[b].cols());
      double least = HUGE_VAL;
      for (Eigen::Index turn = 0; turn < k; ++turn) {
        double most = 0.0;
        for (Eigen::Index i = 0; i < k; ++i) {
          const Eigen::Vector2d apart = cycles[a].col(i) - cycles[b].col((i + turn) % k);
          most = std::max(most, apart.cwiseAbs().maxCoeff());
        }
        least = std::min(least, most);
      }
      EXPECT_LE(least, 2.0 * radians + 1e-12);
    }
  }
}

}  // namespace
}  // namespace planish
