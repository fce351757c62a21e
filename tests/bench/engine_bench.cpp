// SPDX-License-Identifier: MIT
/// Both engines on the same edit of every sample and every real mesh: who ends lower.
#include <benchmark/benchmark.h>

#include "bench/survey_meshes.hpp"
#include "planish/edit/handle_edit.hpp"
#include "support/scenes.hpp"

namespace planish::bench {
namespace {

/// The middle vertex of the planarised mesh, lifted by half an edge.
void edit(benchmark::State& state, const Mesh& mesh, Engine engine) {
  const Mesh flat = made_flat(mesh);
  const EditTargets targets =
      testing::pull(flat, testing::middle_vertex(flat), {0, 0, 0.5 * mean_edge_length(flat)});
  HandleEditOptions options;
  options.engine = engine;
  HandleEditSolver solver(flat, options);
  HandleEditResult result;
  for (auto _ : state) result = solver.solve(targets);
  state.counters["objective"] = result.report.objective.total();
  state.counters["moved"] = static_cast<double>(result.moved.size());
}

const bool kRegistered = [] {
  for (const NamedMesh& named : samples_and_real_meshes()) {
    for (const Engine engine : {Engine::kNewton, Engine::kAugmentedLagrangian}) {
      const std::string label = engine == Engine::kNewton ? "/newton" : "/alm";
      benchmark::RegisterBenchmark(
          ("Engine/" + named.name + label).c_str(),
          [mesh = named.mesh, engine](benchmark::State& state) { edit(state, mesh, engine); })
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1);
    }
  }
  return true;
}();

}  // namespace
}  // namespace planish::bench
