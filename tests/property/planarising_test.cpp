// SPDX-License-Identifier: MIT
/// What making a mesh flat promises: sound panels, fair folds, a kept boundary, and the least of
/// its objective.
#include "planish/projection/planarising.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "planish/io/obj.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/problem/problem.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

Mesh bumpy_grid(int size, double noise) {
  Mesh mesh = testing::quad_grid(size, size, [](double x, double y) {
    const double r = std::hypot(x - 8.0, y - 8.0) / 5.0;
    const double bump = r < 1.0 ? (1.0 - r * r) * (1.0 - r * r) : 0.0;
    return 3.84 * std::sin(M_PI * x / 32.0) + 3.2 * std::sin(M_PI * y / 32.0) + bump;
  });
  mesh.positions += noise * testing::random_points(7, mesh.vertex_count());
  return mesh;
}

/// Angle between the panels of every interior edge, degrees, by its own code.
std::vector<double> fold_angles(const Mesh& mesh, const Positions& positions) {
  std::map<std::pair<int, int>, std::vector<Eigen::Vector3d>> sides;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < face.size(); ++k) {
      area += positions.col(face[k]).cross(positions.col(face[(k + 1) % face.size()]));
    }
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto edge = std::minmax(face[k], face[(k + 1) % face.size()]);
      sides[{edge.first, edge.second}].push_back(area.normalized());
    }
  }
  std::vector<double> angles;
  for (const auto& [edge, normals] : sides) {
    if (normals.size() != 2) continue;
    const double cosine = std::clamp(normals[0].dot(normals[1]), -1.0, 1.0);
    angles.push_back(std::acos(cosine) * 180.0 / M_PI);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

double fold_p95(const Mesh& mesh, const Positions& positions) {
  const std::vector<double> angles = fold_angles(mesh, positions);
  return angles[angles.size() * 95 / 100];
}

Mesh shared_mesh(const std::string& name) {
  return std::get<MeshFile>(read_obj(*testing::shared_mesh_bytes(name + ".obj"))).mesh;
}

void expect_flat(const Mesh& mesh, const Positions& positions) {
  Mesh flat = mesh;
  flat.positions = positions;
  EXPECT_LE(planarity_summary(flat).max_excess, 1e-6);
}

TEST(SoundProjection, FairMeshesKeepTheirShape) {
  for (const double noise : {0.005, 0.02}) {
    const Mesh mesh = bumpy_grid(33, noise);
    const ProjectionResult result = planarise(mesh, {});
    EXPECT_EQ(result.report.status, SolveStatus::kConverged) << noise;
    const Positions positions = testing::apply(mesh, result);
    expect_flat(mesh, positions);
    EXPECT_EQ(testing::spoilt_count(mesh, positions), 0) << noise;
    EXPECT_LE(fold_p95(mesh, positions), 1.05 * fold_p95(mesh, mesh.positions)) << noise;
  }
}

TEST(SoundProjection, TheNearestFlatMeshAloneSpoilsSuchAMesh) {
  const Mesh mesh = bumpy_grid(33, 0.005);
  const ProjectionResult nearest = planarise(mesh, kNearestFlat);
  const ProjectionResult fair = planarise(mesh, {});
  EXPECT_GT(testing::spoilt_count(mesh, testing::apply(mesh, nearest)), 0);
  EXPECT_LT(nearest.rms_move, fair.rms_move);
}

TEST(SoundProjection, NearlyFlatRoofsStayAsFairAsTheyWere) {
  if (!testing::shared_mesh_bytes("pq_gitter.obj")) GTEST_SKIP() << "no shared meshes";
  for (const char* name :
       {"pq_botanic_bubble", "pq_conical_saddle", "pq_enneper_quads", "pq_gitter",
        "pq_lifted_small", "pq_octtorus", "pq_six_planarized", "pq_static_roof", "pq_vase_small",
        "pq_wein99_diag", "hex_enneper_concave"}) {
    const Mesh mesh = shared_mesh(name);
    const ProjectionResult result = planarise(mesh, {});
    const Positions positions = testing::apply(mesh, result);
    expect_flat(mesh, positions);
    EXPECT_EQ(testing::spoilt_count(mesh, positions), 0) << name;
    EXPECT_LE(fold_p95(mesh, positions), 1.05 * fold_p95(mesh, mesh.positions)) << name;
  }
}

TEST(SoundProjection, AKeptBoundaryKeepsItsBits) {
  const Mesh mesh = bumpy_grid(21, 0.01);
  const ProjectionResult result = planarise(mesh, {.keep_boundary = true});
  const Positions positions = testing::apply(mesh, result);
  expect_flat(mesh, positions);
  EXPECT_EQ(testing::spoilt_count(mesh, positions), 0);
  const std::vector<int> boundary = boundary_vertices(mesh);
  EXPECT_EQ(boundary.size(), 80U);
  for (const int v : boundary) EXPECT_EQ(positions.col(v), mesh.positions.col(v)) << v;
}

/// Also where panels cannot become flat without it: then they are named.
struct KeptBoundary {
  const char* name;
  bool becomes_flat;
};
void PrintTo(const KeptBoundary& mesh, std::ostream* out) { *out << mesh.name; }

class KeptBoundaries : public ::testing::TestWithParam<KeptBoundary> {};

TEST_P(KeptBoundaries, KeepTheirBitsOnRealMeshes) {
  if (!testing::shared_mesh_bytes("pq_gitter.obj")) GTEST_SKIP() << "skipped: no shared meshes";
  const Mesh mesh = shared_mesh(GetParam().name);
  const ProjectionResult result = planarise(mesh, {.keep_boundary = true});
  const Positions positions = testing::apply(mesh, result);
  for (const int v : boundary_vertices(mesh)) {
    ASSERT_EQ(positions.col(v), mesh.positions.col(v)) << v;
  }
  EXPECT_EQ(result.failing_faces.empty(), result.report.usable());
  EXPECT_EQ(result.failing_faces.empty(), GetParam().becomes_flat);
}

/// The last takes half a minute: every night.
std::vector<KeptBoundary> boundaries_to_keep() {
  const std::vector<KeptBoundary> all{
      {"hex_enneper_concave", false},  {"pq_botanic_bubble", true},
      {"pq_enneper_quads", true},      {"pq_octtorus", true},
      {"pq_static_roof", true},        {"pq_vase_small", true},
      {"pq_wein99_diag", true},        {"kagome_from_tri_mesh", true},
      {"quad_chebyshev_sphere", true}, {"quad_eight_genus2", true},
      {"mixed345_airport", false}};
  return {all.begin(), all.begin() + testing::by_night(11, 10)};
}

INSTANTIATE_TEST_SUITE_P(Meshes, KeptBoundaries, ::testing::ValuesIn(boundaries_to_keep()));

/// A ring of corners that stand up and down in turn.
Mesh crown(int corners, double height) {
  std::vector<Eigen::Vector3d> points;
  std::vector<int> face;
  for (int k = 0; k < corners; ++k) {
    const double t = 2.0 * M_PI * k / corners;
    points.emplace_back(std::cos(t), std::sin(t), k % 2 == 0 ? height : -height);
    face.push_back(k);
  }
  return testing::make_mesh(points, {face});
}

/// A panel that can lie down flat where it is neither tips over nor shrinks.
TEST(SoundProjection, ACrownLiesDownWhereItIs) {
  for (const int corners : {4, 6, 8, 12, 16}) {
    for (const double height : {0.02, 0.1, 0.2}) {
      const Mesh mesh = crown(corners, height);
      const ProjectionResult result = planarise(mesh, {});
      const std::string what = std::to_string(corners) + ' ' + std::to_string(height);
      EXPECT_EQ(result.report.status, SolveStatus::kConverged) << what;
      const Positions positions = testing::apply(mesh, result);
      expect_flat(mesh, positions);
      EXPECT_LE(result.max_move, 1.01 * height) << what;
      const double area = area_vector(positions, mesh.face(0)).norm();
      EXPECT_GE(area, 0.95 * area_vector(mesh.positions, mesh.face(0)).norm()) << what;
    }
  }
}

/// A dome of quads whose points at the pole lie on one another, each panel with its own.
Mesh dome_apart_at_the_pole(double noise) {
  constexpr int kAround = 12, kRings = 5;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (int ring = 0; ring < kRings; ++ring) {
    for (int k = 0; k < kAround; ++k) {
      const double t = 2.0 * M_PI * k / kAround, s = 0.5 * M_PI * ring / kRings;
      points.emplace_back(5.0 * std::sin(s) * std::cos(t), 5.0 * std::sin(s) * std::sin(t),
                          5.0 * std::cos(s));
      const int next = (k + 1) % kAround;
      if (ring == 0) continue;
      faces.push_back({(ring - 1) * kAround + k, ring * kAround + k, ring * kAround + next,
                       (ring - 1) * kAround + next});
    }
  }
  Mesh mesh = testing::make_mesh(points, faces);
  const Positions shaken = noise * testing::random_points(3, mesh.vertex_count());
  mesh.positions.rightCols(mesh.vertex_count() - kAround) +=
      shaken.rightCols(mesh.vertex_count() - kAround);
  return mesh;
}

/// Nobody hears "cannot become flat" where the nearest flat mesh is sound.
TEST(SoundProjection, IsFlatWhereverTheNearestFlatMeshIsSound) {
  std::vector<std::pair<std::string, Mesh>> meshes;
  for (const double noise : {0.02, 0.05, 0.1}) {
    meshes.emplace_back("dome " + std::to_string(noise), dome_apart_at_the_pole(noise));
  }
  for (const double twist : {0.01, 0.05, 0.2}) {
    meshes.emplace_back("twist " + std::to_string(twist),
                        testing::quad_grid(9, 9, [&](double x, double y) {
                          return twist * (x - 4.0) * (y - 4.0) + 0.1 * std::sin(2.0 * x + y);
                        }));
  }
  int possible = 0;
  for (const auto& [name, mesh] : meshes) {
    ProjectionOptions nearest;
    nearest.fairness_weight = 0.0;
    nearest.keep_shape = false;
    const Positions flat = testing::apply(mesh, project_to_planar(mesh, nearest));
    Mesh left = mesh;
    left.positions = flat;
    const bool is_flat = planarity_summary(left).max_excess <= 1e-6;
    if (!is_flat || testing::spoilt_count(mesh, flat) > 0) continue;
    ++possible;
    const ProjectionResult result = planarise(mesh, {});
    EXPECT_TRUE(result.report.usable()) << name;
    expect_flat(mesh, testing::apply(mesh, result));
  }
  EXPECT_GE(possible, 4);
}

/// Surfaces whose lines are far from conjugate: not all have a sound flat mesh close by.
TEST(SoundProjection, NeverSpoilsAPanelWhateverTheSurface) {
  int flat = 0;
  int refused = 0;
  for (const double twist : {0.02, 0.1, 0.3}) {
    for (const double smooth : {0.0, 1.0, 10.0}) {
      const Mesh mesh = testing::quad_grid(11, 11, [&](double x, double y) {
        return twist * (x - 5.0) * (y - 5.0) + 0.3 * std::sin(x) * std::cos(1.3 * y);
      });
      const ProjectionResult result = planarise(mesh, {.fairness_weight = smooth});
      const Positions positions = testing::apply(mesh, result);
      EXPECT_EQ(testing::spoilt_count(mesh, positions), 0) << twist << ' ' << smooth;
      Mesh left = mesh;
      left.positions = positions;
      const bool is_flat = planarity_summary(left).max_excess <= 1e-6;
      EXPECT_EQ(is_flat, result.failing_faces.empty()) << twist << ' ' << smooth;
      EXPECT_EQ(is_flat, result.report.usable()) << twist << ' ' << smooth;
      ++(is_flat ? flat : refused);
    }
  }
  EXPECT_GT(flat, 0);
  EXPECT_GT(refused, 0);
}

/// ∇F + Jᵀλ = 0 for some λ, with J by differences: where no corner is near its bound, the result is
/// a first-order point of α_d ‖t‖² + α_f ‖E t‖².
/// (positions, result) of a planarising.
std::pair<Positions, ProjectionResult> made(const Mesh& mesh, const Planarising& how) {
  ProjectionResult result = planarise(mesh, how);
  Positions positions = mesh.positions;
  positions(Eigen::all, result.moved) = result.moved_positions;
  return {positions, result};
}

TEST(NearlyFlat, ChangesLessTheFartherPanelsMayStayOutOfFlat) {
  const Mesh mesh = bumpy_grid(16, 0.05);
  const double before = planarity_summary(mesh).max;
  double move = made(mesh, {}).second.rms_move;
  for (const double most : {0.05 * before, 0.2 * before, 0.6 * before}) {
    const auto [positions, result] = made(mesh, {.flat_within = most});
    EXPECT_EQ(result.report.status, SolveStatus::kConverged);
    EXPECT_LE(planarity_summary(mesh, positions).max_excess, most);
    EXPECT_GT(planarity_summary(mesh, positions).max_excess, 0.3 * most);
    EXPECT_EQ(testing::spoilt_count(mesh, positions), 0);
    EXPECT_LT(result.rms_move, move);
    move = result.rms_move;
  }
  EXPECT_TRUE(made(mesh, {.flat_within = 1.01 * before}).second.moved.empty());
}

TEST(NearlyFlat, IsAsFlatAsTheLargestMoveLetsIt) {
  const Mesh mesh = bumpy_grid(16, 0.05);
  const ProjectionResult flat = made(mesh, {}).second;
  // Far enough: the flat mesh itself, bit for bit.
  const auto [same, all] = made(mesh, {.within = flat.max_move});
  EXPECT_EQ(all.moved_positions, flat.moved_positions);
  double bent = planarity_summary(mesh).max;
  for (const double share : {0.1, 0.3, 0.6}) {
    const double most = share * flat.max_move;
    const auto [positions, result] = made(mesh, {.within = most});
    EXPECT_EQ(result.report.status, SolveStatus::kToleranceNotMet);
    EXPECT_LE((positions - mesh.positions).colwise().norm().maxCoeff(), most);
    EXPECT_GT(result.max_move, 0.5 * most);
    EXPECT_EQ(testing::spoilt_count(mesh, positions), 0);
    EXPECT_LT(planarity_summary(mesh, positions).max, bent);
    bent = planarity_summary(mesh, positions).max;
  }
}

TEST(NearlyFlat, KeepsTheBoundaryWithinBothBounds) {
  const Mesh mesh = bumpy_grid(12, 0.05);
  const auto [positions, result] =
      made(mesh, {.keep_boundary = true, .within = 0.02, .flat_within = 5.0});
  for (const int v : boundary_vertices(mesh)) EXPECT_EQ(positions.col(v), mesh.positions.col(v));
  EXPECT_LE(result.max_move, 0.02);
  EXPECT_FALSE(result.moved.empty());
}

TEST(NearestFlat, OfALargeMeshIsCertified) {
  const Mesh mesh = bumpy_grid(71, 0.05);
  const Planarising nearest{.fairness_weight = 0.0, .keep_shape = false};
  const ProjectionResult result = planarise(mesh, nearest);
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  ASSERT_TRUE(result.report.optimality.has_value());
  EXPECT_LE(result.report.optimality->stationarity, 2e-5);
  EXPECT_LE(result.report.planarity_after, 1e-6);
  const ProjectionResult fair = planarise(mesh, {});
  EXPECT_LT(result.rms_move, fair.rms_move);
}

TEST(SoundProjection, ALargeMeshIsFlatSoundAndCertified) {
  const Mesh mesh = bumpy_grid(71, 0.05);  // more points than are solved by a factor of the Hessian
  const ProjectionResult result = planarise(mesh, {});
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  ASSERT_TRUE(result.report.optimality.has_value());
  EXPECT_TRUE(result.report.optimality->met());
  EXPECT_LE(result.report.planarity_after, 1e-6);
  EXPECT_EQ(testing::spoilt_count(mesh, testing::apply(mesh, result)), 0);
}

TEST(SoundProjection, IsAFirstOrderPointOfItsProblem) {
  const Mesh mesh = bumpy_grid(9, 0.01);
  const Planarising how;
  const ProjectionResult result = planarise(mesh, how);
  ASSERT_EQ(result.report.status, SolveStatus::kConverged);
  const MeshModel model(mesh, FairnessKind::kSecondDifference);
  const Eigen::Index n = mesh.vertex_count();
  const Positions t = (testing::apply(mesh, result) - mesh.positions) / model.unit();
  const Positions bent = t * model.fairness.transpose();
  Positions gradient = 2.0 * t + 2.0 * how.fairness_weight * (bent * model.fairness);
  const auto rows = static_cast<Eigen::Index>(model.equations.size());
  const auto residuals = [&](const Positions& points) {
    Eigen::VectorXd values(rows);
    model.equations.for_each([&]<class Row>(int e, const Row& row) {
      RowPoints<Row::kArity> corners;
      for (int k = 0; k < Row::kArity; ++k) {
        corners.col(k) = points.col(row.vertices[static_cast<std::size_t>(k)]);
      }
      values[e] = residual(row, corners);
    });
    return values;
  };
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd transposed(3 * n, rows);
  for (Eigen::Index c = 0; c < 3 * n; ++c) {
    Positions up = model.points + t;
    Positions down = up;
    up(c % 3, c / 3) += kStep;
    down(c % 3, c / 3) -= kStep;
    transposed.row(c) = (residuals(up) - residuals(down)).transpose() / (2.0 * kStep);
  }
  const Eigen::Map<const Eigen::VectorXd> g(gradient.data(), 3 * n);
  const Eigen::VectorXd multipliers = transposed.colPivHouseholderQr().solve(-g);
  EXPECT_LT((g + transposed * multipliers).cwiseAbs().maxCoeff(), 1e-5 * g.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace planish
