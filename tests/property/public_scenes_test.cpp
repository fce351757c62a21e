// SPDX-License-Identifier: MIT
/// The two public scenes of docs/math.md, by both engines, against the best values known.
#include <gtest/gtest.h>

#include <algorithm>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

struct Scene {
  const char* name;
  Engine engine;
  double objective;  ///< upper bound
};

void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name << (scene.engine == Engine::kNewton ? " newton" : " alm");
}

class PublicScene : public ::testing::TestWithParam<Scene> {};

TEST_P(PublicScene, ReachesItsObjectiveWithFlatPanelsAndTheRestUntouched) {
  const Mesh mesh = testing::sample(GetParam().name, 32);
  const EditTargets targets = testing::public_scene_targets(mesh);
  const HandleEditResult result =
      solve_handle_edit(mesh, targets, {.keep_shape = false, .engine = GetParam().engine});
  EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
  EXPECT_LE(result.report.objective.total(), GetParam().objective);
  const Positions edited = apply(mesh, result);
  EXPECT_LE(planarity_summary(mesh, edited).max, testing::kPromise);
  EXPECT_LE(result.report.planarity_after, testing::kPromise);
  EXPECT_EQ(moved_vertex_count(mesh.positions, edited), static_cast<int>(result.moved.size()));
  EXPECT_EQ(result.report.moved_vertices, static_cast<int>(result.moved.size()));
  EXPECT_LT(result.moved.size(), 400u);
  EXPECT_TRUE(std::is_sorted(result.moved.begin(), result.moved.end()));
  RecordProperty("objective", std::to_string(result.report.objective.total()));
  RecordProperty("moved", static_cast<int>(result.moved.size()));
  RecordProperty("iterations", result.report.cost.steps);
  RecordProperty("milliseconds", std::to_string(1e3 * result.report.solve_seconds));
}

INSTANTIATE_TEST_SUITE_P(All, PublicScene,
                         ::testing::Values(Scene{"vault", Engine::kNewton, 23.4220},
                                           Scene{"dome", Engine::kNewton, 5.9897},
                                           Scene{"vault", Engine::kAugmentedLagrangian, 25.8},
                                           Scene{"dome", Engine::kAugmentedLagrangian, 6.1}));

}  // namespace
}  // namespace planish
