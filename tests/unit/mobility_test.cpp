// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mobility_map.hpp"
#include "planish/measures/folds.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/mobility/best_places.hpp"
#include "planish/mobility/mobility_meter.hpp"
#include "planish/shapes/shapes.hpp"

namespace planish {
namespace {

using Rows = std::array<MobilityRow, kMobilityRows>;

bool same(const Rows& one, const Rows& other) {
  return std::equal(one.begin(), one.end(), other.begin(), [](const auto& a, const auto& b) {
    return a.vertex == b.vertex && a.direction == b.direction && a.distance == b.distance &&
           a.limit == b.limit && a.remake == b.remake && a.sharpest_fold == b.sharpest_fold;
  });
}

double sharpest(const Mesh& mesh) {
  const std::vector<double> folds = face_folds(mesh, mesh.positions);
  return *std::max_element(folds.begin(), folds.end());
}

TEST(Mobility, OfAVertexDoesNotDependOnWhatWasMeasuredBefore) {
  const Mesh mesh = *make_sample("freeform", 8);
  MobilityMeter meter(mesh, {});
  const Rows first = meter.measure(27);
  static_cast<void>(meter.measure(12));
  static_cast<void>(meter.measure(36));
  EXPECT_TRUE(same(first, meter.measure(27)));
  EXPECT_TRUE(same(first, MobilityMeter(mesh, {}).measure(27)));
}

TEST(Mobility, GoesUpDownAndAlongTheSurface) {
  const Mesh mesh = *make_sample("dome", 8);
  const Rows rows = MobilityMeter(mesh, {}).measure(27);
  EXPECT_EQ(rows[0].direction, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(rows[1].direction, Eigen::Vector3d(0, 0, -1));
  const Adjacency adjacency = build_adjacency(mesh);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const int f : adjacency.faces[27]) normal += area_vector(mesh.positions, mesh.face(f));
  for (const MobilityRow& row : {rows[2], rows[3]}) {
    EXPECT_NEAR(row.direction.norm(), 1.0, 1e-12);
    EXPECT_NEAR(row.direction.dot(normal.normalized()), 0.0, 1e-12);
  }
  EXPECT_GE(rows[2].distance, rows[3].distance);
}

TEST(Mobility, EndsWherePanelsFoldTooMuch) {
  const Mesh mesh = *make_sample("vault", 10);
  MobilityMeter meter(mesh, {});
  int ended = 0;
  for (const int v : {33, 44, 55}) {
    for (const MobilityRow& row : meter.measure(v)) {
      EXPECT_GT(row.distance, 0.0);
      EXPECT_LE(row.distance, mean_edge_length(mesh));
      EXPECT_GT(row.remake, 0);
      EXPECT_LE(row.sharpest_fold, sharpest(mesh) + 10.0 + 1e-9);
      ended += row.limit == "fold" ? 1 : 0;
    }
  }
  EXPECT_GT(ended, 0);
}

TEST(Mobility, GoesFartherWithWiderLimits) {
  const Mesh mesh = *make_sample("vault", 10);
  MobilityOptions tight, wide;
  tight.edit.bounds.front().most = 3.0;
  wide.edit.bounds.clear();
  const MobilityRow near = MobilityMeter(mesh, tight).measure(44)[0];
  const MobilityRow far = MobilityMeter(mesh, wide).measure(44)[0];
  EXPECT_EQ(near.limit, "fold");
  EXPECT_LT(near.distance, 0.5 * far.distance);
}

TEST(Mobility, IsAWholePartOfTheRange) {
  const Mesh mesh = *make_sample("roof", 8);
  MobilityOptions options;
  options.range = 0.4;
  options.steps = 4;
  for (const MobilityRow& row : MobilityMeter(mesh, options).measure(30)) {
    const double parts = row.distance / 0.4 * 16.0;
    EXPECT_NEAR(parts, std::round(parts), 1e-9);
  }
}

TEST(Mobility, RefusesWrongOptionsByName) {
  MobilityOptions options;
  options.range = -1.0;
  EXPECT_EQ(find_problem(options), "range must be 0 (the mean edge) or greater");
  options.range = 1.0;
  options.steps = 0;
  EXPECT_EQ(find_problem(options), "steps must be from 1 to 1000");
  options.steps = 8;
  options.edit.engine = Engine::kAugmentedLagrangian;
  EXPECT_EQ(find_problem(options), "mobility: the engine alm knows none; it needs newton");
}

MobilityRow place(int vertex, const Eigen::Vector3d& direction, double distance, int remake = 9) {
  return {vertex, direction, distance, "fold", remake, 12.0};
}

TEST(BestPlaces, AreTheFarthestUpOrDownAndApartFromEachOther) {
  const Mesh mesh = *make_sample("vault", 12);  // 12 points a row
  const Adjacency adjacency = build_adjacency(mesh);
  const Eigen::Vector3d up(0, 0, 1);
  const Eigen::Vector3d down(0, 0, -1);
  const Eigen::Vector3d along(1, 0, 0);
  const auto places =
      best_places(adjacency,
                  {place(0, up, 0.2), place(3, down, 0.5), place(60, up, 0.4),
                   place(64, along, 0.9), place(67, up, 0.4, 5), place(143, down, 0.0)},
                  5);
  // 0 is three edges from 3; 64 slides along the surface; 143 does not move.
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[0].vertex, 3);
  EXPECT_EQ(places[1].vertex, 67);  // as far as 60 with fewer panels
  EXPECT_EQ(places[2].vertex, 60);
  EXPECT_EQ(best_places(adjacency, {place(3, down, 0.5), place(67, up, 0.4)}, 1).size(), 1U);
}

TEST(MobilityMap, MeasuresAsTheMeterDoesUnderTheSettingsOfThePage) {
  const Mesh mesh = *make_sample("vault", 10);
  HandleEditOptions settings;
  settings.softness = 5.0;
  settings.reach = 9;
  const MobilityOptions options = map_options(settings);
  EXPECT_EQ(options.edit.reach, MobilityOptions::default_edit().reach);
  ASSERT_EQ(options.edit.bounds.size(), 1U);  // fold=+10
  EXPECT_EQ(find_map_problem(mesh, options), std::nullopt);
  MobilityMap map(mesh, options);
  EXPECT_TRUE(map.best(3).empty());
  const auto rows = map.measure(44);
  const Rows expected = MobilityMeter(mesh, options).measure(44);
  ASSERT_EQ(rows.size(), expected.size());
  Rows measured;
  std::copy(rows.begin(), rows.end(), measured.begin());
  EXPECT_TRUE(same(measured, expected));
  const auto best = map.best(3);
  ASSERT_EQ(best.size(), 1U);
  EXPECT_EQ(best[0].distance, std::max(rows[0].distance, rows[1].distance));
}

TEST(MobilityMap, LeavesALimitOnFoldsThatIsStated) {
  HandleEditOptions settings;
  settings.bounds = MobilityOptions::default_edit().bounds;
  settings.bounds[0].most = 25.0;
  const auto bounds = map_options(settings).edit.bounds;
  ASSERT_EQ(bounds.size(), 1U);
  EXPECT_EQ(bounds[0].most, 25.0);
}

}  // namespace
}  // namespace planish
