// SPDX-License-Identifier: MIT
#include "planish/problem/problem.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::ProblemOnMesh;

TEST(MeshModel, IsCentredWithMeanEdgeOne) {
  Mesh mesh = testing::sample("dome", 12);
  mesh.positions *= 250.0;
  mesh.positions.colwise() += Eigen::Vector3d(5e5, 5e6, 10);
  const MeshModel model(mesh, FairnessKind::kSecondDifference);
  Mesh unit = mesh;
  unit.positions = model.points;
  EXPECT_NEAR(mean_edge_length(unit), 1.0, 1e-9);
  EXPECT_LT(model.points.rowwise().mean().norm(), 1e-9);
  EXPECT_NEAR(model.unit(), mean_edge_length(mesh), 1e-9 * model.unit());
  EXPECT_EQ(model.equations.size(), 121u);
  EXPECT_EQ(model.element_offsets[ConstraintKinds::index_of<PlanarPolygon>()].size(), 122u);
}

TEST(MeshModel, HasOneEquationPerVertexBeyondThreeInEachFace) {
  for (const char* name : {"vault", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, 12);
    const MeshModel model(mesh, FairnessKind::kLaplacian);
    const auto& offsets = model.element_offsets[ConstraintKinds::index_of<PlanarPolygon>()];
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto k = static_cast<std::size_t>(f);
      EXPECT_EQ(offsets[k + 1] - offsets[k], static_cast<int>(mesh.face(f).size()) - 3);
    }
  }
}

/// F of [PB-1] written with dense matrices.
double dense_objective(const ProblemOnMesh& on_mesh, const Positions& d) {
  double sum = 0.0;
  for (int v = 0; v < on_mesh.model.vertex_count(); ++v) {
    const VertexTerm& term = on_mesh.problem.terms[static_cast<std::size_t>(v)];
    sum += 0.5 * term.norm_weight * d.col(v).norm();
    sum += 0.5 * term.square_weight * (d.col(v) - term.target).squaredNorm();
  }
  const Eigen::MatrixXd rows = Eigen::MatrixXd(on_mesh.model.fairness) * d.transpose();
  return sum + 0.5 * on_mesh.problem.fairness_weight * rows.squaredNorm();
}

TEST(Objective, OfTheWholeMeshIsTheFormula) {
  for (const char* name : {"vault", "hex"}) {
    ProblemOnMesh on_mesh(testing::sample(name, 9));
    on_mesh.problem.fairness_weight = 0.7;
    on_mesh.add_handle(20, {0.1, -0.2, 0.3});
    Patch patch = on_mesh.cut_all();
    patch.displacement = testing::random_points(4, patch.local_count());
    const ObjectiveTerms terms = objective(patch);
    EXPECT_NEAR(terms.total(), dense_objective(on_mesh, patch.displacement), 1e-12 * terms.total());
    const double handle =
        500.0 * (patch.displacement.col(20) - Eigen::Vector3d(0.1, -0.2, 0.3)).squaredNorm();
    EXPECT_NEAR(terms.handle, handle, 1e-12 * handle);
  }
}

/// What a patch leaves out is zero: its objective is that of the mesh.
TEST(PatchCutter, KeepsEveryTermThatAFreeVertexTouches) {
  ProblemOnMesh on_mesh(testing::sample("vault", 12));
  on_mesh.add_handle(66, {0.0, 0.0, 1.0});
  const std::vector<int> free = testing::ring_neighbourhood(on_mesh.model.mesh, 66, 2);
  Patch patch = on_mesh.cut(free);
  patch.displacement.leftCols(patch.free_count) = testing::random_points(4, patch.free_count);
  Positions all = Positions::Zero(3, on_mesh.model.vertex_count());
  for (int k = 0; k < patch.local_count(); ++k) {
    all.col(patch.vertices[static_cast<std::size_t>(k)]) = patch.displacement.col(k);
  }
  const double whole = dense_objective(on_mesh, all);
  EXPECT_NEAR(objective(patch).total(), whole, 1e-12 * whole);
  std::set<int> faces;
  for (const int v : free) {
    for (const int f : on_mesh.model.adjacency.faces[v]) faces.insert(f);
  }
  EXPECT_EQ(std::set<int>(patch.face_ids.begin(), patch.face_ids.end()), faces);
  EXPECT_EQ(patch.face_ids.size(), faces.size());
  EXPECT_EQ(patch.equations.size(), faces.size());
  EXPECT_EQ(static_cast<std::size_t>(patch.free_count), free.size());
}

TEST(PatchCutter, LeavesFixedVerticesInTheHaloAtTheirTarget) {
  ProblemOnMesh on_mesh(testing::quad_grid(6, 6));
  on_mesh.problem.terms[14] = VertexTerm{.target = {1, 2, 3}, .fixed = true};
  const Patch patch = on_mesh.cut({13, 14, 15});
  EXPECT_EQ(patch.free_count, 2);
  const auto found = std::find(patch.vertices.begin(), patch.vertices.end(), 14);
  ASSERT_NE(found, patch.vertices.end());
  EXPECT_EQ(Eigen::Vector3d(patch.displacement.col(found - patch.vertices.begin())),
            Eigen::Vector3d(1, 2, 3));
}

TEST(PatchCutter, CutsTheSamePatchAgain) {
  ProblemOnMesh on_mesh(testing::sample("trihex", 10));
  PatchCutter cutter(on_mesh.model);
  Patch first, other, again;
  const std::vector<int> here{20, 21, 30}, there{50, 51};
  cutter.cut(on_mesh.problem, here, first);
  cutter.cut(on_mesh.problem, there, other);
  cutter.cut(on_mesh.problem, here, again);
  EXPECT_EQ(first.vertices, again.vertices);
  EXPECT_EQ(first.equation_ids, again.equation_ids);
  EXPECT_EQ(first.fairness_vertices.values, again.fairness_vertices.values);
  EXPECT_EQ(first.points, again.points);
}

TEST(PatchCutter, AnOpenPatchFreesTheRimAndHoldsItByTheRowsOfTheSetAlone) {
  ProblemOnMesh on_mesh(testing::sample("dome", 12));
  on_mesh.problem.shape_weight = 1.0;
  PatchCutter cutter(on_mesh.model);
  const std::vector<int> inner{65, 66, 78};
  on_mesh.problem.terms[53].fixed = true;  // beside 65: in the halo, not on the rim
  Patch closed, open;
  cutter.cut(on_mesh.problem, inner, closed);
  cutter.cut_open(on_mesh.problem, inner, open);
  EXPECT_EQ(open.equation_ids, closed.equation_ids);
  EXPECT_EQ(open.fairness_values, closed.fairness_values);
  EXPECT_GE(open.inequalities.size(), closed.inequalities.size());  // corners of the same faces
  EXPECT_EQ(open.face_ids, closed.face_ids);
  EXPECT_EQ(std::set<int>(open.vertices.begin(), open.vertices.end()),
            std::set<int>(closed.vertices.begin(), closed.vertices.end()));
  EXPECT_EQ(open.free_count, open.local_count() - 1);
  EXPECT_EQ(open.vertices.back(), 53);
}

TEST(PatchCutter, SkipsTriangles) {
  ProblemOnMesh on_mesh(testing::triangle_grid(5, 5));
  const Patch patch = on_mesh.cut_all();
  EXPECT_TRUE(patch.equations.empty());
  EXPECT_TRUE(patch.face_ids.empty());
}

}  // namespace
}  // namespace planish
