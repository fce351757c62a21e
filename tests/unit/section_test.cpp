// SPDX-License-Identifier: MIT
#include "planish/fabrication/section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "planish/fabrication/panel_frame.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

std::vector<SectionLine> section_of(const Mesh& mesh, const SectionPlane& plane) {
  return cut_by(mesh, joint_table(mesh), plane);
}

double length_of(const SectionLine& line) {
  double length = 0.0;
  for (Eigen::Index k = 0; k + 1 < line.points.cols(); ++k) {
    length += (line.points.col(k + 1) - line.points.col(k)).norm();
  }
  if (line.closed) length += (line.points.col(0) - line.points.rightCols<1>()).norm();
  return length;
}

double total_length(const std::vector<SectionLine>& lines) {
  double length = 0.0;
  for (const SectionLine& line : lines) length += length_of(line);
  return length;
}

/// Length of a convex panel's section: between the first and last point where its sides cross.
double panel_section(const Mesh& mesh, int face, const SectionPlane& plane) {
  std::vector<Eigen::Vector3d> points;
  const auto corners = mesh.face(face);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d a = mesh.positions.col(corners[k]);
    const Eigen::Vector3d b = mesh.positions.col(corners[(k + 1) % corners.size()]);
    const double ha = plane.normal.dot(a) - plane.offset;
    const double hb = plane.normal.dot(b) - plane.offset;
    if (ha * hb < 0.0) points.emplace_back((hb * a - ha * b) / (hb - ha));
  }
  return points.size() == 2 ? (points[0] - points[1]).norm() : 0.0;
}

Mesh unit_cube() {
  return testing::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

class SectionOn : public ::testing::TestWithParam<const char*> {};

/// Every point is in the plane and on an edge; the pieces together are all that the panels give.
TEST_P(SectionOn, ASampleIsExactAndWhole) {
  const Mesh mesh = testing::sample(GetParam(), 12);
  const double size = mesh.positions.cwiseAbs().maxCoeff();
  const Eigen::Vector3d middle = mesh.positions.rowwise().mean();
  for (const Eigen::Vector3d& towards :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0.3, -0.5, 0.81)}) {
    const Eigen::Vector3d normal = towards.normalized();
    const SectionPlane plane{normal, normal.dot(middle) + 1e-3};
    const auto lines = section_of(mesh, plane);
    ASSERT_FALSE(lines.empty());
    double expected = 0.0;
    for (int f = 0; f < mesh.face_count(); ++f) expected += panel_section(mesh, f, plane);
    EXPECT_NEAR(total_length(lines), expected, 1e-12 * size * expected);
    for (const SectionLine& line : lines) {
      EXPECT_EQ(line.panels.size(),
                static_cast<std::size_t>(line.points.cols()) - (line.closed ? 0 : 1));
      for (Eigen::Index k = 0; k < line.points.cols(); ++k) {
        const Eigen::Vector3d p = line.points.col(k);
        EXPECT_LE(std::abs(normal.dot(p) - plane.offset), 1e-14 * size);
        const int face = line.panels[std::min(static_cast<std::size_t>(k), line.panels.size() - 1)];
        const auto corners = mesh.face(face);
        double nearest = size;
        for (std::size_t c = 0; c < corners.size(); ++c) {
          const Eigen::Vector3d a = mesh.positions.col(corners[c]);
          const Eigen::Vector3d side = mesh.positions.col(corners[(c + 1) % corners.size()]) - a;
          const double along = std::clamp(side.dot(p - a) / side.squaredNorm(), 0.0, 1.0);
          nearest = std::min(nearest, (p - a - along * side).norm());
        }
        EXPECT_LE(nearest, 1e-14 * size);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, SectionOn,
                         ::testing::Values("vault", "dome", "freeform", "hex", "trihex"));

TEST(Section, OfACubeIsAClosedSquare) {
  const auto lines = section_of(unit_cube(), {Eigen::Vector3d::UnitZ(), 0.25});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].points.cols(), 4);
  EXPECT_NEAR(length_of(lines[0]), 4.0, 1e-15);
}

/// Through corners: corners in the plane are above it, no point comes twice.
TEST(Section, ThroughCornersHasEachOnce) {
  const auto across = section_of(unit_cube(), {Eigen::Vector3d(1, -1, 0).normalized(), 0.0});
  ASSERT_EQ(across.size(), 1U);
  EXPECT_TRUE(across[0].closed);
  EXPECT_EQ(across[0].points.cols(), 4);
  EXPECT_NEAR(length_of(across[0]), 2.0 + 2.0 * std::sqrt(2.0), 1e-15);
  const auto top = section_of(unit_cube(), {Eigen::Vector3d::UnitZ(), 1.0});
  ASSERT_EQ(top.size(), 1U);  // the walls below it end there
  EXPECT_NEAR(length_of(top[0]), 4.0, 1e-15);
  EXPECT_TRUE(section_of(unit_cube(), {Eigen::Vector3d::UnitZ(), 0.0}).empty());
  EXPECT_TRUE(section_of(unit_cube(), {Eigen::Vector3d(1, 1, 1).normalized(), 0.0}).empty());
}

TEST(Section, OfAnOpenStripEndsAtItsBoundary) {
  const auto lines = section_of(testing::quad_grid(4, 2), {Eigen::Vector3d::UnitY(), 0.5});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_EQ(lines[0].points.cols(), 4);
  EXPECT_EQ(lines[0].panels, (std::vector{0, 1, 2}));
}

/// A U, cut across both its legs.
TEST(Section, OfAConcavePanelIsInsideItTwice) {
  const Mesh mesh = testing::make_mesh(
      {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
      {{0, 1, 2, 3, 4, 5, 6, 7}});
  const auto lines = section_of(mesh, {Eigen::Vector3d::UnitY(), 1.5});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(length_of(lines[0]), 1.0, 1e-15);
  EXPECT_NEAR(length_of(lines[1]), 1.0, 1e-15);
}

TEST(Section, EndsWhereThreePanelsShareAnEdge) {
  const Mesh mesh = testing::make_mesh(
      {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 1, 1}},
      {{0, 2, 3, 1}, {0, 1, 5, 4}, {0, 1, 7, 6}});
  const auto lines = section_of(mesh, {Eigen::Vector3d::UnitY(), 0.5});
  EXPECT_EQ(lines.size(), 3U);
  EXPECT_NEAR(total_length(lines), 3.0, 1e-15);
}

}  // namespace
}  // namespace planish
