// SPDX-License-Identifier: MIT
#include "engines/displacement_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/scenes.hpp"

namespace planish {
namespace {

class StoredField : public ::testing::Test {
 protected:
  StoredField() : on_mesh(testing::quad_grid(6, 6)), patch(on_mesh.cut({7, 8, 13, 14})) {
    const auto equations = static_cast<Eigen::Index>(patch.equations.size());
    state.displacement = testing::random_points(1, patch.free_count);
    state.norm_dual = testing::random_points(2, patch.free_count);
    state.multipliers = testing::random_vector(3, equations);
    field.store(patch, state);
  }

  void expect_untouched(const DisplacementField& other) const {
    PatchState read;
    other.load(patch, read);
    EXPECT_EQ(read.displacement.norm(), 0.0);
    EXPECT_EQ(read.norm_dual.norm(), 0.0);
    EXPECT_EQ(read.multipliers.norm(), 0.0);
  }

  void expect_stored(const DisplacementField& other) const {
    PatchState read;
    other.load(patch, read);
    EXPECT_EQ(read.displacement, state.displacement);
    EXPECT_EQ(read.norm_dual, state.norm_dual);
    EXPECT_EQ(read.multipliers, state.multipliers);
  }

  testing::ProblemOnMesh on_mesh;
  Patch patch;
  PatchState state;
  DisplacementField field{36, 25};
};

TEST_F(StoredField, GivesBackWhatWasStored) {
  expect_stored(field);
  EXPECT_EQ(field.displacement(8), Eigen::Vector3d(state.displacement.col(1)));
  EXPECT_EQ(field.displacement(0), Eigen::Vector3d::Zero().eval());
}

TEST_F(StoredField, ReadsAsZeroAfterClear) {
  field.clear();
  expect_untouched(field);
  EXPECT_TRUE(field.touched_vertices().empty());
}

TEST_F(StoredField, TouchesEachVertexOnce) {
  field.store(patch, state);
  field.set_displacement(7, Eigen::Vector3d::Ones());
  std::vector<int> touched = field.touched_vertices();
  std::sort(touched.begin(), touched.end());
  EXPECT_EQ(touched, (std::vector<int>{7, 8, 13, 14}));
}

TEST_F(StoredField, ResetsOneVertexAlone) {
  field.reset_vertex(13);
  EXPECT_EQ(field.displacement(13).norm(), 0.0);
  EXPECT_EQ(field.displacement(14), Eigen::Vector3d(state.displacement.col(3)));
}

TEST_F(StoredField, ScalesDisplacementsAlone) {
  field.scale(0.5);
  PatchState read;
  field.load(patch, read);
  EXPECT_EQ(read.displacement, (0.5 * state.displacement).eval());
  EXPECT_EQ(read.norm_dual, state.norm_dual);
  EXPECT_EQ(read.multipliers, state.multipliers);
}

TEST_F(StoredField, RestoresASnapshotOverAnythingElse) {
  const DisplacementField::Snapshot snapshot = field.snapshot();
  field.clear();
  field.set_displacement(30, Eigen::Vector3d::Ones());
  field.restore(snapshot);
  expect_stored(field);
  EXPECT_EQ(field.displacement(30).norm(), 0.0);
  EXPECT_EQ(field.touched_vertices().size(), 4u);
  field.restore({});
  expect_untouched(field);
}

}  // namespace
}  // namespace planish
