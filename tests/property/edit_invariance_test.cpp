// SPDX-License-Identifier: MIT
/// An edit does not depend on the unit, the place, the orientation or the numbering of a mesh.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <random>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kSameShape = 1e-9;  ///< of the mean edge length

struct Move {
  const char* mesh;
  int size;
  Eigen::Vector3d by;  ///< of the middle vertex
};

void PrintTo(const Move& move, std::ostream* out) { *out << move.mesh << " " << move.size; }

class EditOf : public ::testing::TestWithParam<Move> {
 protected:
  EditOf()
      : mesh(testing::sample(GetParam().mesh, GetParam().size)),
        handle(testing::middle_vertex(mesh)),
        edited(apply(mesh, solve_handle_edit(mesh, testing::pull(mesh, handle, GetParam().by)))) {}

  /// Largest distance to `expected`, in mean edges of `other`.
  static double deviation(const Mesh& other, const EditTargets& targets,
                          const Positions& expected) {
    const Positions result = apply(other, solve_handle_edit(other, targets));
    return (result - expected).colwise().norm().maxCoeff() / mean_edge_length(other);
  }

  Mesh mesh;
  int handle;
  Positions edited;
};

TEST_P(EditOf, ARotatedMeshIsTheRotatedEdit) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  Mesh turned = mesh;
  turned.positions = turn * mesh.positions;
  EXPECT_LT(deviation(turned, testing::pull(turned, handle, turn * GetParam().by), turn * edited),
            kSameShape);
}

TEST_P(EditOf, AScaledMeshIsTheScaledEdit) {
  for (const double scale : {1e-3, 0.3048, 1000.0}) {
    Mesh scaled = mesh;
    scaled.positions *= scale;
    EXPECT_LT(
        deviation(scaled, testing::pull(scaled, handle, scale * GetParam().by), scale * edited),
        kSameShape)
        << scale;
  }
}

/// Two minima may lie so near that the rounding of the coordinates decides between them: one place
/// in eight may lead to the other one, and that is as certified as the first.
TEST_P(EditOf, AMovedMeshIsTheMovedEdit) {
  constexpr int kPlaces = 8;
  int same = 0;
  for (int place = 1; place <= kPlaces; ++place) {
    const Eigen::Vector3d offset = place * Eigen::Vector3d(1200.0, -3400.0, 25.0);
    Mesh moved = mesh;
    moved.positions.colwise() += offset;
    const HandleEditResult result =
        solve_handle_edit(moved, testing::pull(moved, handle, GetParam().by));
    EXPECT_EQ(result.report.status, SolveStatus::kConverged) << place;
    const double apart =
        (apply(moved, result) - (edited.colwise() + offset)).colwise().norm().maxCoeff();
    if (apart < kSameShape * mean_edge_length(moved)) ++same;
  }
  EXPECT_GE(same, kPlaces - 1);
}

/// National grid coordinates in metres: what remains is the rounding of the coordinates, 1e-9 m.
TEST_P(EditOf, AMeshInNationalGridCoordinatesStaysFlat) {
  Mesh moved = mesh;
  moved.positions.colwise() += Eigen::Vector3d(512000.0, 5400000.0, 300.0);
  const HandleEditResult result =
      solve_handle_edit(moved, testing::pull(moved, handle, GetParam().by));
  EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
  EXPECT_LT(planarity_summary(moved, apply(moved, result)).max, 5e-6);
}

TEST_P(EditOf, ARelabelledMeshIsTheRelabelledEdit) {
  std::vector<int> label(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(label.begin(), label.end(), 0);
  std::mt19937 engine(17);
  for (std::size_t k = label.size(); k > 1; --k) std::swap(label[k - 1], label[engine() % k]);
  Mesh other = mesh;
  Positions expected = edited;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    other.positions.col(label[static_cast<std::size_t>(v)]) = mesh.positions.col(v);
    expected.col(label[static_cast<std::size_t>(v)]) = edited.col(v);
  }
  for (int& v : other.face_vertices) v = label[static_cast<std::size_t>(v)];
  const int there = label[static_cast<std::size_t>(handle)];
  EXPECT_LT(deviation(other, testing::pull(other, there, GetParam().by), expected), kSameShape);
}

TEST_P(EditOf, TheSameMeshHasTheSameBits) {
  EXPECT_EQ(
      moved_vertex_count(
          edited, apply(mesh, solve_handle_edit(mesh, testing::pull(mesh, handle, GetParam().by)))),
      0);
}

INSTANTIATE_TEST_SUITE_P(Meshes, EditOf,
                         ::testing::Values(Move{"vault", 20, {0, 0, 0.8}},
                                           Move{"dome", 20, {0.3, 0, 0.8}},
                                           Move{"hex", 16, {0, 0, 0.4}},
                                           Move{"trihex", 16, {0.1, 0.2, 0.5}}));

}  // namespace
}  // namespace planish
