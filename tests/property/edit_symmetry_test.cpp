// SPDX-License-Identifier: MIT
/// What an edit under a symmetry keeps: the symmetry, flat panels, and everything that it does not
/// move.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "planish/edit/symmetric_edit.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/projection/planarising.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"
#include "support/symmetric_meshes.hpp"

namespace planish {
namespace {

constexpr double kSymmetricTo = 1e-9;  // mean edges: the promise

struct SymmetricCase {
  std::string name;
  std::string symmetry;
};

/// A base that is flat and symmetric; no faces where a shared mesh is absent.
Mesh base_of(const SymmetricCase& given) {
  if (given.name == "turned") return testing::turned_surface(12, 8);
  if (given.name == "turned far") return testing::turned_surface(9, 8, {512345.25, 5398765.5, 430});
  if (given.name.find('_') == std::string::npos) return testing::sample(given.name, 16);
  const auto bytes = testing::shared_mesh_bytes(given.name + ".obj");
  if (!bytes) return {};
  Mesh mesh = std::get<MeshFile>(read_mesh(*bytes, MeshFormat::kObj)).mesh;
  const MeshSymmetry symmetry = testing::symmetry_of(mesh, given.symmetry);
  const ProjectionResult flat = planarise(mesh, Planarising{});
  mesh.positions(Eigen::all, flat.moved) = flat.moved_positions;
  EXPECT_TRUE(make_symmetric(mesh, symmetry, 1e-6).symmetric);
  return mesh;
}

class EditSymmetry : public ::testing::TestWithParam<SymmetricCase> {
 protected:
  EditSymmetry() : mesh(base_of(GetParam())) {}
  void SetUp() override {
    if (mesh.face_count() == 0) GTEST_SKIP() << "skipped: the shared meshes are absent";
    symmetry = testing::symmetry_of(mesh, GetParam().symmetry);
  }

  /// An edit of a point that is on no plane or axis, with all images.
  [[nodiscard]] EditTargets edit(int vertex, const Eigen::Vector3d& move) const {
    const auto all = with_images(testing::pull(mesh, vertex, move), mesh, symmetry);
    const auto* why = std::get_if<std::string>(&all);
    EXPECT_EQ(why, nullptr) << *why;
    return std::get<EditTargets>(all);
  }
  [[nodiscard]] bool is_fixed(int vertex) const {
    const auto& all = symmetry.operations;
    return std::any_of(all.begin() + 1, all.end(), [&](const SymmetryOperation& one) {
      return one.image[static_cast<std::size_t>(vertex)] == vertex;
    });
  }
  void expect_symmetric(const EditTargets& targets, const HandleEditResult& result) const {
    const Positions after = apply(mesh, result);
    const double edge = mean_edge_length(mesh);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_LE(asymmetry(symmetry, mesh, after), kSymmetricTo + far());
    for (const SymmetryElement& element : symmetry.elements) {
      const double error =
          element.order == 0
              ? testing::mirror_error(after, element.axis, symmetry.centre[element.axis])
              : testing::turn_error(after, element.order, symmetry.centre);
      EXPECT_LE(error, (kSymmetricTo + far()) * edge) << symmetry_text(element);
    }
    for (const SymmetryOperation& one : symmetry.operations) {  // whole orbits move
      for (const int v : result.moved) {
        EXPECT_TRUE(std::binary_search(result.moved.begin(), result.moved.end(),
                                       one.image[static_cast<std::size_t>(v)]));
      }
    }
    for (const SymmetryElement& element : symmetry.elements) {
      if (element.order != 0) continue;
      const double at = symmetry.centre[element.axis];
      EXPECT_TRUE(testing::is_mirrored_to_the_bit(result.moved_positions, element.axis, at) ||
                  at != 0.0);
    }
  }
  /// What doubles hold of coordinates far from the origin, mean edges.
  [[nodiscard]] double far() const {
    return 4e-16 * mesh.positions.cwiseAbs().maxCoeff() / mean_edge_length(mesh);
  }

  Mesh mesh;
  MeshSymmetry symmetry;
};

TEST_P(EditSymmetry, IsKeptFlatAndCertified) {
  const double edge = mean_edge_length(mesh);
  HandleEditSolver solver(mesh, {});
  int tried = 0, converged = 0;
  for (const int share : {1, 3, 5, 6, 8}) {
    const int vertex = mesh.vertex_count() * share / 10;
    if (is_fixed(vertex)) continue;
    for (const double lift : {0.3, -0.8}) {
      const EditTargets targets = edit(vertex, edge * lift * Eigen::Vector3d(0.2, 0.1, 1.0));
      const HandleEditResult result = solver.solve_symmetric(targets, symmetry);
      expect_symmetric(targets, result);
      EXPECT_TRUE(result.report.usable()) << vertex;
      EXPECT_GT(result.report.moved_vertices, 0) << vertex;
      ++tried;
      converged += result.report.status == SolveStatus::kConverged ? 1 : 0;
      if (result.report.status == SolveStatus::kConverged) {
        ASSERT_TRUE(result.report.optimality);
        EXPECT_TRUE(result.report.optimality->met());
      }
    }
  }
  EXPECT_GE(tried, 4);
  EXPECT_GE(10 * converged, 8 * tried) << converged << " of " << tried;
}

TEST_P(EditSymmetry, IsKeptByEveryOption) {
  const double edge = mean_edge_length(mesh);
  const int vertex = mesh.vertex_count() * 3 / 10;
  const Eigen::Vector3d move = edge * Eigen::Vector3d(0.1, 0.05, 0.4);
  std::vector<HandleEditOptions> all(5);
  all[0].hard_handles = true;
  all[1].softness = 6.0;
  all[1].reach = 3;
  all[2].keep_boundary = true;
  all[3].sparsity = Sparsity::kL2;
  all[4].bounds = {{"fold", 0.0, 10.0, true}};
  for (const HandleEditOptions& options : all) {
    HandleEditSolver solver(mesh, options);
    EditTargets targets = edit(vertex, move);
    const HandleEditResult result = solver.solve_symmetric(targets, symmetry);
    expect_symmetric(targets, result);
    if (options.hard_handles && result.report.status == SolveStatus::kConverged) {
      EXPECT_LE(result.report.handle_error, 1e-12 * edge + far());
    }
  }
}

TEST_P(EditSymmetry, LeavesThePlainSolveItsBits) {
  const int vertex = mesh.vertex_count() * 3 / 10;
  const double edge = mean_edge_length(mesh);
  const Eigen::Vector3d move = edge * Eigen::Vector3d(0.1, 0.05, 0.4);
  const EditTargets plain = testing::pull(mesh, vertex, move);
  const HandleEditResult fresh = solve_handle_edit(mesh, plain);
  HandleEditSolver solver(mesh, {});
  const HandleEditResult first = solver.solve_symmetric(edit(vertex, move), symmetry);
  const HandleEditResult after = solver.solve(plain);
  EXPECT_EQ(after.moved, fresh.moved);
  EXPECT_TRUE(testing::same_bits(after.moved_positions, fresh.moved_positions));
  const HandleEditResult again = solver.solve_symmetric(edit(vertex, move), symmetry);
  EXPECT_EQ(again.moved, first.moved);
  EXPECT_TRUE(testing::same_bits(again.moved_positions, first.moved_positions));
}

INSTANTIATE_TEST_SUITE_P(
    All, EditSymmetry,
    ::testing::Values(SymmetricCase{"roof", "x"}, SymmetricCase{"roof", "auto"},
                      SymmetricCase{"roof", "axis:2"}, SymmetricCase{"vault", "x"},
                      SymmetricCase{"dome", "auto"}, SymmetricCase{"turned", "axis:12"},
                      SymmetricCase{"turned", "x,y"}, SymmetricCase{"turned", "axis:3"},
                      SymmetricCase{"turned far", "axis:9"}, SymmetricCase{"pq_octtorus", "x"},
                      SymmetricCase{"pq_octtorus", "axis:4"}, SymmetricCase{"pq_octtorus", "auto"},
                      SymmetricCase{"quad_eight_genus2", "auto"}),
    [](const auto& of) {
      std::string name = of.param.name + "_" + of.param.symmetry;
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return name;
    });

/// Twelve images of a handle whose solve is lop-sided: 55 of 96 points, hardly an orbit of them.
TEST(EditSymmetryAllRound, MovesWhereTheSolveIsLopSided) {
  const Mesh mesh = testing::turned_surface(12, 8);
  const MeshSymmetry symmetry = testing::symmetry_of(mesh, "axis:12");
  const Eigen::Vector3d move = -0.8 * mean_edge_length(mesh) * Eigen::Vector3d(0.2, 0.1, 1.0);
  for (const int ring : {0, 7}) {
    const EditTargets one = testing::pull(mesh, ring * 12 + 2, move);
    const EditTargets targets = std::get<EditTargets>(with_images(one, mesh, symmetry));
    const HandleEditResult result = HandleEditSolver(mesh, {}).solve_symmetric(targets, symmetry);
    EXPECT_GT(result.report.moved_vertices, 0) << ring;
    EXPECT_NE(result.report.status, SolveStatus::kInfeasibleHandles) << ring;
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result)) << ring;
    EXPECT_LE(asymmetry(symmetry, mesh, apply(mesh, result)), kSymmetricTo) << ring;
  }
}

TEST(EditSymmetryOnAPlane, KeepsTheHandleAndItsNeighboursThere) {
  const Mesh mesh = testing::sample("roof", 16);
  const MeshSymmetry symmetry = testing::symmetry_of(mesh, "x,y");
  const int middle = testing::middle_vertex(mesh);
  const auto all = with_images(testing::pull(mesh, middle, {0.0, 0.0, 0.6}), mesh, symmetry);
  const EditTargets targets = std::get<EditTargets>(all);
  ASSERT_EQ(targets.handles.size(), 1U);
  const HandleEditResult result = HandleEditSolver(mesh, {}).solve_symmetric(targets, symmetry);
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  const Positions after = apply(mesh, result);
  EXPECT_EQ(after(0, middle), symmetry.centre.x());
  EXPECT_EQ(after(1, middle), symmetry.centre.y());
  EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
  EXPECT_LE(asymmetry(symmetry, mesh, after), kSymmetricTo);
}

TEST(EditSymmetryFarApart, IsOneEditAndItsCopy) {
  const Mesh mesh = testing::sample("vault", 32);
  const MeshSymmetry symmetry = testing::symmetry_of(mesh, "x");
  HandleEditOptions options;
  options.reach = 4;
  for (const int vertex : {16 * 32 + 6, 10 * 32 + 4, 25 * 32 + 7}) {
    const EditTargets one = testing::pull(mesh, vertex, {0.0, 0.0, 0.5});
    const HandleEditResult alone = solve_handle_edit(mesh, one, options);
    const EditTargets both = std::get<EditTargets>(with_images(one, mesh, symmetry));
    const HandleEditResult result = HandleEditSolver(mesh, options).solve_symmetric(both, symmetry);
    EXPECT_EQ(result.report.status, SolveStatus::kConverged);
    EXPECT_EQ(result.report.cost.steps, alone.report.cost.steps);
    EXPECT_EQ(result.report.moved_vertices, 2 * alone.report.moved_vertices);
    EXPECT_NEAR(result.report.objective.total(), 2.0 * alone.report.objective.total(), 1e-9);
    EXPECT_LE(asymmetry(symmetry, mesh, apply(mesh, result)), kSymmetricTo);
    EXPECT_TRUE(testing::is_valid_edit(mesh, both, result));
    const Positions after = apply(mesh, result), single = apply(mesh, alone);
    for (const int v : alone.moved) EXPECT_LT((after.col(v) - single.col(v)).norm(), 1e-12) << v;
  }
}

}  // namespace
}  // namespace planish
