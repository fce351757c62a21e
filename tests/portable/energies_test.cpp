// SPDX-License-Identifier: MIT
#include "planish/measures/energies.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>
#include <utility>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kRounding = 1e-12;

FairnessOperator make_operator(const Mesh& mesh, FairnessKind kind) {
  return fairness_operator(mesh, build_adjacency(mesh), kind);
}

std::map<int, double> row_of(const FairnessOperator& matrix, int row) {
  std::map<int, double> entries;
  for (FairnessOperator::InnerIterator entry(matrix, row); entry; ++entry) {
    entries[static_cast<int>(entry.col())] = entry.value();
  }
  return entries;
}

/// Rows by the vertex with the most negative coefficient: the one that the row is about.
std::multimap<int, std::map<int, double>> rows_by_centre(const FairnessOperator& matrix) {
  std::multimap<int, std::map<int, double>> result;
  for (int r = 0; r < matrix.rows(); ++r) {
    const std::map<int, double> row = row_of(matrix, r);
    const auto centre = std::min_element(
        row.begin(), row.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    result.emplace(centre->first, row);
  }
  return result;
}

using KindAndMesh = std::tuple<FairnessKind, const char*>;

class EveryFairnessOperator : public ::testing::TestWithParam<KindAndMesh> {};

TEST_P(EveryFairnessOperator, AnnihilatesConstants) {
  const auto [kind, name] = GetParam();
  const Mesh mesh = testing::sample(name, 12);
  const FairnessOperator matrix = make_operator(mesh, kind);
  EXPECT_GT(matrix.rows(), 0);
  EXPECT_EQ(matrix.cols(), mesh.vertex_count());
  EXPECT_LT((matrix * Eigen::VectorXd::Ones(matrix.cols())).lpNorm<Eigen::Infinity>(), kRounding);
}

/// E has the scale of one edge, whatever the mesh: it does not look at positions.
TEST_P(EveryFairnessOperator, DependsOnTheFacesAlone) {
  const auto [kind, name] = GetParam();
  Mesh mesh = testing::sample(name, 12);
  const FairnessOperator before = make_operator(mesh, kind);
  mesh.positions = testing::random_points(5, mesh.vertex_count());
  EXPECT_EQ((before - make_operator(mesh, kind)).norm(), 0.0);
}

TEST_P(EveryFairnessOperator, DoesNotDependOnTheOrientationOfFaces) {
  const auto [kind, name] = GetParam();
  Mesh mesh = testing::sample(name, 12);
  const FairnessOperator before = make_operator(mesh, kind);
  for (int f = 0; f < mesh.face_count(); f += 3) {
    const auto offset = static_cast<std::size_t>(f);
    std::reverse(mesh.face_vertices.begin() + mesh.face_offsets[offset],
                 mesh.face_vertices.begin() + mesh.face_offsets[offset + 1]);
  }
  const FairnessOperator after = make_operator(mesh, kind);
  ASSERT_EQ(before.rows(), after.rows());
  const Eigen::MatrixXd gram = Eigen::MatrixXd(before.transpose() * before);
  EXPECT_LT((gram - Eigen::MatrixXd(after.transpose() * after)).norm(), kRounding * gram.norm());
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryFairnessOperator,
                         ::testing::Combine(::testing::Values(FairnessKind::kLaplacian,
                                                              FairnessKind::kSecondDifference,
                                                              FairnessKind::kThirdDifference),
                                            ::testing::Values("vault", "dome", "hex", "trihex")));

/// One row per interior vertex, one per boundary vertex that is not a corner.
TEST(Laplacian, IsUniformInsideAndOneDimensionalAlongTheBoundary) {
  const FairnessOperator matrix = make_operator(testing::quad_grid(5, 4), FairnessKind::kLaplacian);
  EXPECT_EQ(matrix.rows(), 5 * 4 - 4);
  const auto rows = rows_by_centre(matrix);
  EXPECT_EQ(rows.find(6)->second,
            (std::map<int, double>{{6, -1.0}, {1, 0.25}, {5, 0.25}, {7, 0.25}, {11, 0.25}}));
  EXPECT_EQ(rows.find(2)->second, (std::map<int, double>{{2, -1.0}, {1, 0.5}, {3, 0.5}}));
  for (const int corner : {0, 4, 15, 19}) EXPECT_EQ(rows.count(corner), 0u);
}

/// (32 − 2) · 32 rows each way: the 64 grid lines of the public scenes.
TEST(SecondDifference, FollowsTheLinesOfAGrid) {
  const FairnessOperator matrix =
      make_operator(testing::quad_grid(32, 32), FairnessKind::kSecondDifference);
  EXPECT_EQ(matrix.rows(), 2 * 32 * 30);
  const auto rows = rows_by_centre(matrix);
  EXPECT_EQ(rows.count(33), 2u);
  EXPECT_EQ(rows.count(1), 1u);
  EXPECT_EQ(rows.find(1)->second, (std::map<int, double>{{0, 1.0}, {1, -2.0}, {2, 1.0}}));
  EXPECT_EQ(rows.count(0), 0u);
}

TEST(SecondDifference, AnnihilatesLinearFieldsOnAGrid) {
  const Mesh mesh = testing::quad_grid(9, 7);
  for (const FairnessKind kind : {FairnessKind::kLaplacian, FairnessKind::kSecondDifference,
                                  FairnessKind::kThirdDifference}) {
    const FairnessOperator matrix = make_operator(mesh, kind);
    const Eigen::MatrixXd linear = mesh.positions.transpose();
    EXPECT_LT((matrix * linear).lpNorm<Eigen::Infinity>(), kRounding);
  }
}

/// Third differences let a parabola along a line pass, and only them.
TEST(ThirdDifference, AnnihilatesQuadraticFieldsOnAGrid) {
  const Mesh mesh = testing::quad_grid(9, 7);
  const Eigen::VectorXd square =
      mesh.positions.row(0).array().square() + 3.0 * mesh.positions.row(1).array().square();
  EXPECT_LT(
      (make_operator(mesh, FairnessKind::kThirdDifference) * square).lpNorm<Eigen::Infinity>(),
      kRounding);
  EXPECT_GT(
      (make_operator(mesh, FairnessKind::kSecondDifference) * square).lpNorm<Eigen::Infinity>(),
      1.0);
}

/// Every run of four vertices on a grid line: (9 − 3) · 7 + (7 − 3) · 9.
TEST(ThirdDifference, HasARowPerRunOfFourVertices) {
  const FairnessOperator matrix =
      make_operator(testing::quad_grid(9, 7), FairnessKind::kThirdDifference);
  EXPECT_EQ(matrix.rows(), 6 * 7 + 4 * 9);
  for (int r = 0; r < matrix.rows(); ++r) {
    std::vector<double> values;
    for (const auto& [vertex, value] : row_of(matrix, r)) values.push_back(std::abs(value));
    std::sort(values.begin(), values.end());
    EXPECT_EQ(values, (std::vector<double>{1.0, 1.0, 3.0, 3.0}));
  }
}

/// A flat kagome: its three families of lines are straight, so rows that follow them give zero
/// on the plane's coordinates.
TEST(SecondDifference, FollowsTheStraightLinesOfAKagome) {
  Mesh mesh = testing::sample("trihex", 14);
  const Adjacency adjacency = build_adjacency(mesh);
  const FairnessOperator matrix = make_operator(mesh, FairnessKind::kSecondDifference);
  const auto rows = rows_by_centre(matrix);
  int interior = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (adjacency.boundary[static_cast<std::size_t>(v)]) continue;
    ++interior;
    ASSERT_EQ(adjacency.neighbours[v].size(), 4u);
    ASSERT_EQ(rows.count(v), 2u) << "two lines cross at an interior vertex of a kagome";
    const auto [begin, end] = rows.equal_range(v);
    for (auto row = begin; row != end; ++row) {
      std::vector<int> ends;
      for (const auto& [vertex, value] : row->second)
        if (value > 0) ends.push_back(vertex);
      ASSERT_EQ(ends.size(), 2u);
      const Eigen::Vector3d before = mesh.positions.col(ends[0]) - mesh.positions.col(v);
      const Eigen::Vector3d after = mesh.positions.col(ends[1]) - mesh.positions.col(v);
      EXPECT_LT(before.normalized().dot(after.normalized()), -0.85) << "no sharp turn";
    }
  }
  EXPECT_GT(interior, 50);
}

/// Interior vertices of a hexagonal mesh have three neighbours and one averaged row of
/// coefficients −2 and 2/3.
TEST(SecondDifference, AveragesWhereNoLineGoesStraight) {
  const Mesh mesh = testing::sample("hex", 14);
  const Adjacency adjacency = build_adjacency(mesh);
  const auto rows = rows_by_centre(make_operator(mesh, FairnessKind::kSecondDifference));
  int interior = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (adjacency.boundary[static_cast<std::size_t>(v)]) continue;
    ++interior;
    ASSERT_EQ(rows.count(v), 1u);
    const auto& row = rows.find(v)->second;
    ASSERT_EQ(row.size(), 4u);
    EXPECT_EQ(row.at(v), -2.0);
    for (const int w : adjacency.neighbours[v]) EXPECT_DOUBLE_EQ(row.at(w), 2.0 / 3.0);
  }
  EXPECT_GT(interior, 50);
}

TEST(FairnessOperator, IsEmptyOnALonePanel) {
  const Mesh quad =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  for (const FairnessKind kind : {FairnessKind::kLaplacian, FairnessKind::kSecondDifference,
                                  FairnessKind::kThirdDifference}) {
    EXPECT_EQ(make_operator(quad, kind).rows(), 0);
  }
}

TEST(Bending, IsTheSecondDifferenceOnALine) {
  const Mesh mesh = testing::quad_grid(5, 5);
  Positions displacement = Positions::Zero(3, mesh.vertex_count());
  displacement(2, 12) = 0.5;
  const std::vector<double> bends =
      bending(make_operator(mesh, FairnessKind::kSecondDifference), displacement);
  EXPECT_NEAR(bends[12], 1.0, kRounding);  // 0 − 2 · 0.5 + 0
  for (const int next : {7, 11, 13, 17}) {
    EXPECT_NEAR(bends[static_cast<std::size_t>(next)], 0.5, kRounding);
  }
  for (const int far : {6, 8, 0, 24, 10, 2}) EXPECT_EQ(bends[static_cast<std::size_t>(far)], 0.0);
}

TEST(Bending, OfEveryOperatorIsZeroForATranslation) {
  for (const char* name : {"vault", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, 7);
    const Positions moved = Positions::Constant(3, mesh.vertex_count(), 2.5);
    for (const FairnessKind kind : {FairnessKind::kLaplacian, FairnessKind::kSecondDifference,
                                    FairnessKind::kThirdDifference}) {
      for (const double bend : bending(make_operator(mesh, kind), moved)) {
        EXPECT_NEAR(bend, 0.0, kRounding);
      }
    }
  }
}

}  // namespace
}  // namespace planish
