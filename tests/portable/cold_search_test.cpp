// SPDX-License-Identifier: MIT
#include "engines/cold_search.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace planish {
namespace {

class ColdSearch : public ::testing::Test {
 protected:
  ColdSearch() : mesh(testing::sample("dome", 20)), on_mesh(mesh) {
    on_mesh.add_handle(testing::middle_vertex(mesh), {0.2, 0, 0.9});
  }

  [[nodiscard]] DisplacementField fresh_field() const {
    return {on_mesh.model.vertex_count(), static_cast<int>(on_mesh.model.equations.size())};
  }

  Mesh mesh;
  testing::ProblemOnMesh on_mesh;
};

TEST_F(ColdSearch, DependsOnTheProblemAlone) {
  WorkingSetNewton newton(on_mesh.model);
  DisplacementField field = fresh_field();
  const EngineOutcome first = find_minimum(on_mesh.problem, {}, newton, field, {});
  const auto state = field.snapshot();
  const std::vector<int> support = newton.support();
  field.scale(3.0);  // what an earlier run left
  newton.set_support({0, 1, 2});
  const EngineOutcome again = find_minimum(on_mesh.problem, {}, newton, field, {});
  EXPECT_EQ(first.objective, again.objective);
  EXPECT_EQ(support, newton.support());
  EXPECT_EQ(state.displacement, field.snapshot().displacement);
}

TEST_F(ColdSearch, EndsNoHigherThanItsFirstStart) {
  WorkingSetNewton newton(on_mesh.model);
  DisplacementField field = fresh_field();
  const EngineOutcome single = newton.run_cold(on_mesh.problem, {3, 16, 0.05}, {}, field, {});
  const EngineOutcome best = find_minimum(on_mesh.problem, {}, newton, field, {});
  EXPECT_EQ(best.status, SolveStatus::kConverged);
  EXPECT_LE(best.objective, 1.001 * single.objective);
  EXPECT_FALSE(best.records.empty());
}

TEST_F(ColdSearch, StopsWhenAsked) {
  WorkingSetNewton newton(on_mesh.model);
  DisplacementField field = fresh_field();
  int steps = 0;
  const auto after_five = [&](const IterationRecord&) {
    return ++steps == 5 ? Flow::kStop : Flow::kContinue;
  };
  const EngineOutcome outcome = find_minimum(on_mesh.problem, {}, newton, field, after_five);
  EXPECT_EQ(outcome.status, SolveStatus::kCancelled);
  EXPECT_EQ(steps, 5);
}

}  // namespace
}  // namespace planish
