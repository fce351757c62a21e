// SPDX-License-Identifier: MIT
/// Planarising perturbed PQ grids: ours against local/global iteration, in one run.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/local_global.hpp"
#include "planish/projection/planarising.hpp"
#include "support/scenes.hpp"

namespace planish::bench {
namespace {

Mesh perturbed_grid(int size) {
  Mesh mesh = testing::sample("vault", size);
  mesh.positions /= mean_edge_length(mesh);
  mesh.positions += 0.05 * testing::random_points(1, mesh.vertex_count());
  return mesh;
}

/// A long swell with a bump in every tile of 33 × 33 points and little noise: what many local edits
/// leave. Edges are about 1.
Mesh bumpy_grid(int size) {
  constexpr int kTile = 33;
  constexpr double kRadius = 5.0;
  const double turn = std::acos(-1.0) / 32.0;
  Mesh mesh = testing::sample("vault", size);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double x = v % size, y = v / size;
    const double r = std::hypot(v % size % kTile - kTile / 2, v / size % kTile - kTile / 2);
    const double bump = r < kRadius ? std::pow(1.0 - r * r / (kRadius * kRadius), 2) : 0.0;
    const double swell =
        3.84 * std::sin(turn * x) + 0.64 * std::sin(4.0 * turn * x) + 3.2 * std::sin(turn * y);
    mesh.positions.col(v) << x, y, swell + bump;
  }
  mesh.positions += 0.005 * testing::random_points(1, mesh.vertex_count());
  return mesh;
}

using Grid = Mesh (*)(int size);

/// @param state range(0) vertices a side; range(1) exponent of the planarity to reach
void local_global(benchmark::State& state, Grid grid, int window) {
  const Mesh mesh = grid(static_cast<int>(state.range(0)));
  LocalGlobalOptions options;
  options.window = window;
  options.planarity = std::pow(10.0, -static_cast<double>(state.range(1)));
  LocalGlobalRun run;
  for (auto _ : state) {
    LocalGlobal solver(mesh, options.closeness);
    run = solver.run(options);
  }
  state.counters["planarity"] = run.planarity;
  state.counters["steps"] = run.iterations;
  state.counters["reached"] = run.reached ? 1.0 : 0.0;
}

void LocalGlobalPlain(benchmark::State& state) { local_global(state, perturbed_grid, 0); }
void LocalGlobalAnderson(benchmark::State& state) { local_global(state, perturbed_grid, 5); }
void BumpsAnderson(benchmark::State& state) { local_global(state, bumpy_grid, 5); }

/// Distance alone, and what the page and the command line do with an opened mesh.
void project(benchmark::State& state, Grid grid, double fairness) {
  const Mesh mesh = grid(static_cast<int>(state.range(0)));
  ProjectionOptions options;
  options.fairness_weight = fairness;
  options.keep_shape = fairness > 0.0;
  options.tolerance = 1000.0 * std::pow(10.0, -static_cast<double>(state.range(1)));
  ProjectionResult result;
  for (auto _ : state) result = project_to_planar(mesh, options);
  state.counters["planarity"] = 1e-3 * result.report.planarity_after;
  state.counters["steps"] = result.report.cost.steps;
  state.counters["reached"] = result.failing_faces.empty() ? 1.0 : 0.0;
}

void ProjectNearest(benchmark::State& state) { project(state, perturbed_grid, 0.0); }
void ProjectFair(benchmark::State& state) {
  project(state, perturbed_grid, Planarising{}.fairness_weight);
}
void BumpsNearest(benchmark::State& state) { project(state, bumpy_grid, 0.0); }

BENCHMARK(ProjectNearest)
    ->ArgsProduct({{32, 100, 316}, {4, 9}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(BumpsNearest)
    ->ArgsProduct({{32, 100, 316}, {4, 9}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(BumpsAnderson)
    ->ArgsProduct({{32, 100, 316}, {4}})
    ->Args({32, 6})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(ProjectFair)
    ->ArgsProduct({{32, 100}, {4, 9}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(LocalGlobalAnderson)
    ->ArgsProduct({{32, 100, 316}, {4}})
    ->Args({32, 6})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(LocalGlobalPlain)
    ->ArgsProduct({{32, 100, 316}, {4}})
    ->Args({32, 6})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace planish::bench
