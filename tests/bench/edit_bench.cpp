// SPDX-License-Identifier: MIT
/// Edits, drags and the reference engine's step, by mesh size and by edit size.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <string>

#include "bench/survey_meshes.hpp"
#include "engines/augmented_lagrangian.hpp"
#include "engines/edit_splitting.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/variations/subspace.hpp"
#include "projection/sound_projection.hpp"
#include "support/scenes.hpp"
#include "thread_pool.hpp"

namespace planish::bench {
namespace {

constexpr int kPeriod = 62;  ///< after so many edges the vault's profile repeats

/// The public vault continued periodically: whatever the size, the surroundings of the handle are
/// those of the 32 × 32 scene, so the edit is the same.
Mesh periodic_vault(int size) {
  const double pi = std::acos(-1.0);
  return testing::quad_grid(size, size, [&](double x, double y) {
    const double u = x / 31.0, v = y / 31.0;
    return 31.0 *
           (0.12 * std::sin(pi * u) + 0.10 * std::sin(pi * v) + 0.02 * std::sin(4.0 * pi * v));
  });
}

int periodic_handle(int size) {
  const int at = 16 + kPeriod * ((size / 2) / kPeriod);
  return at * size + at;
}

struct Scene {
  Mesh mesh;
  int handle = 0;
  double lift = 1.5;  ///< model units
  [[nodiscard]] EditTargets at(double share) const {
    return testing::pull(mesh, handle, {0, 0, lift * share});
  }
};

Scene scene(int kind, int size) {
  if (kind == 0) return {testing::sample("vault", 32), 16 * 32 + 16};
  if (kind == 1) return {testing::sample("dome", 32), 16 * 32 + 16};
  return {periodic_vault(size), periodic_handle(size)};
}

void report(benchmark::State& state, const HandleEditResult& result) {
  state.counters["objective"] = result.report.objective.total();
  state.counters["planarity_mm_per_m"] = result.report.planarity_after;
  state.counters["moved"] = static_cast<double>(result.moved.size());
  state.counters["steps"] = result.report.cost.steps;
}

/// One solve from cold; the set-up, O(n) once per mesh, is counted apart.
void edit_cold(benchmark::State& state, const Scene& scene, const HandleEditOptions& options) {
  HandleEditSolver solver(scene.mesh, options);
  HandleEditResult result;
  for (auto _ : state) result = solver.solve(scene.at(1.0));
  report(state, result);
  state.counters["setup_ms"] = 1e3 * result.report.setup_seconds;
}

/// Processor time of this one thread, so that a busy machine does not count.
double milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void drag(benchmark::State& state, const Scene& scene, const HandleEditOptions& options = {}) {
  constexpr int kFrames = 60;
  std::vector<double> frames;
  double worst = 0.0;
  std::size_t spoilt = 0;
  HandleEditResult result;
  for (auto _ : state) {
    state.PauseTiming();
    HandleEditSolver solver(scene.mesh, options);
    state.ResumeTiming();
    for (int frame = 1; frame <= kFrames; ++frame) {
      const EditTargets targets = scene.at(frame / static_cast<double>(kFrames));
      const double start = milliseconds();
      result = solver.drag(targets, 10.0);
      frames.push_back(milliseconds() - start);
      worst = std::max(worst, result.report.planarity_after);
      spoilt += spoilt_faces(scene.mesh, scene.mesh.positions, apply(scene.mesh, result)).size();
    }
  }
  std::sort(frames.begin(), frames.end());
  report(state, result);
  state.counters["median_ms"] = frames[frames.size() / 2];
  state.counters["p95_ms"] = frames[frames.size() * 95 / 100];
  state.counters["worst_mm_per_m"] = worst;
  state.counters["spoilt"] = static_cast<double>(spoilt);
}

void EditColdVault(benchmark::State& state) { edit_cold(state, scene(0, 32), {}); }
void EditColdDome(benchmark::State& state) { edit_cold(state, scene(1, 32), {}); }
void EditCold(benchmark::State& state) {
  edit_cold(state, scene(2, static_cast<int>(state.range(0))), {});
}
/// An uneven ceiling of 1,058 triangles, so many mean edges above the vault.
HandleEditOptions under_a_ceiling(const Mesh& mesh, double above) {
  constexpr int kSide = 24;
  const double edge = mean_edge_length(mesh);
  const Eigen::Vector3d low = mesh.positions.rowwise().minCoeff();
  const Eigen::Vector3d size = mesh.positions.rowwise().maxCoeff() - low;
  KeepOut ceiling{.kind = KeepOut::Kind::kMesh};
  for (int k = 0; k < kSide * kSide; ++k) {
    const Eigen::Vector2d place(low.x() + size.x() * (k % kSide) / (kSide - 1),
                                low.y() + size.y() * (k / kSide) / (kSide - 1));
    Eigen::Index nearest = 0;
    (mesh.positions.topRows(2).colwise() - place).colwise().norm().minCoeff(&nearest);
    const double bump = 0.05 * ((k * 7) % 5);
    const double height = mesh.positions(2, nearest) + (above + bump) * edge;
    ceiling.mesh.points.push_back({place.x(), place.y(), height});
  }
  for (int j = 0; j + 1 < kSide; ++j) {
    for (int i = 0; i + 1 < kSide; ++i) {
      const int a = j * kSide + i, b = a + kSide;
      ceiling.mesh.panels.push_back({a, a + 1, b + 1});
      ceiling.mesh.panels.push_back({a, b + 1, b});
    }
  }
  return {.keep_outs = {ceiling}, .clearance = 0.02 * edge};
}

/// A pull of one and a half mean edges, and a ceiling so many tenths of one above.
void DragUnderACeiling(benchmark::State& state) {
  const Scene vault = scene(0, 32);
  const double above = 0.1 * static_cast<double>(state.range(0));
  drag(state, vault, under_a_ceiling(vault.mesh, above));
}
void DragVault(benchmark::State& state) { drag(state, scene(0, 32)); }
void DragDome(benchmark::State& state) { drag(state, scene(1, 32)); }
void Drag(benchmark::State& state) { drag(state, scene(2, static_cast<int>(state.range(0)))); }

/// The edit's size follows the smoothness weight, range(0) in hundredths.
void EditBySize(benchmark::State& state) {
  const Mesh mesh = testing::sample("dome", 100);
  const Scene wide{mesh, testing::middle_vertex(mesh)};
  edit_cold(state, wide, {.smoothness = 0.01 * static_cast<double>(state.range(0))});
}

/// One step of alternating minimisation on the whole mesh, and the factor solve within it.
class WholeMesh {
 public:
  explicit WholeMesh(int size) : on_mesh_(periodic_vault(size)) {
    on_mesh_.add_handle(periodic_handle(size), {0, 0, 1.0});
    patch_ = on_mesh_.cut_all();
  }
  Patch& patch() { return patch_; }

 private:
  testing::ProblemOnMesh on_mesh_;
  Patch patch_;
};

void AlmStep(benchmark::State& state) {
  WholeMesh whole(static_cast<int>(state.range(0)));
  EditSplitting splitting(whole.patch());
  if (!splitting.set_penalty(10.0)) state.SkipWithError("singular");
  splitting.update_auxiliaries();
  splitting.update_primal();
  for (auto _ : state) {
    splitting.update_auxiliaries();
    splitting.update_primal();
  }
}

/// The first dual updates of an edit on the whole mesh, on one thread and on two in turn: the
/// quickest of some rounds each, in milliseconds of a wall clock.
void AlmOnThreads(benchmark::State& state) {
  constexpr int kRounds = 5;
  constexpr int kUpdates = 12;
  const int size = static_cast<int>(state.range(0));
  workflow::ThreadPool pool(2);
  std::array<double, 2> best = {HUGE_VAL, HUGE_VAL};
  std::array<Positions, 2> results;
  for (auto _ : state) {
    for (int round = 0; round < 2 * kRounds; ++round) {
      const auto which = static_cast<std::size_t>(round % 2);
      WholeMesh whole(size);
      const Stopwatch watch;
      AlmOptions options;
      options.max_outer = kUpdates;
      options.executor = which == 1 ? &pool : nullptr;
      EditSplitting splitting(whole.patch(), options.executor);
      state.counters["steps"] = run_alm(splitting, options, {}).cost.steps;
      best[which] = std::min(best[which], 1e3 * watch.seconds());
      results[which] = whole.patch().displacement;
    }
  }
  if (results[0] != results[1]) state.SkipWithError("other bits");
  state.counters["one_ms"] = best[0];
  state.counters["two_ms"] = best[1];
}

/// The floor of that step: x, y, z by one factor.
void FactorSolve(benchmark::State& state) {
  const Mesh mesh = periodic_vault(static_cast<int>(state.range(0)));
  const Adjacency adjacency = build_adjacency(mesh);
  const FairnessOperator e = fairness_operator(mesh, adjacency, FairnessKind::kSecondDifference);
  FairnessOperator gram = (e.transpose() * e).pruned();
  std::vector<Eigen::Triplet<double>> couplings;
  for (int v = 0; v < mesh.vertex_count(); ++v) couplings.emplace_back(v, v, 10.0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) {
      for (const int w : mesh.face(f)) couplings.emplace_back(v, w, v == w ? 7.5 : -2.5);
    }
  }
  FairnessOperator centring(mesh.vertex_count(), mesh.vertex_count());
  centring.setFromTriplets(couplings.begin(), couplings.end());
  gram += centring;
  RaggedRows graph;
  for (int r = 0; r < gram.rows(); ++r) {
    for (FairnessOperator::InnerIterator entry(gram, r); entry; ++entry) {
      if (entry.col() != r) graph.values.push_back(static_cast<int>(entry.col()));
    }
    graph.offsets.push_back(static_cast<int>(graph.values.size()));
  }
  SparseCholesky factor;
  factor.analyze(graph, 1);
  factor.set_zero();
  for (int r = 0; r < gram.rows(); ++r) {
    for (FairnessOperator::InnerIterator entry(gram, r); entry; ++entry) {
      const int column = static_cast<int>(entry.col());
      if (factor.position(r) < factor.position(column)) continue;
      factor.values()[static_cast<std::size_t>(factor.slot(r, column).offset)] = entry.value();
    }
  }
  if (!factor.factorize()) state.SkipWithError("singular");
  const Positions right = testing::random_points(1, mesh.vertex_count());
  Positions x = right;
  for (auto _ : state) {
    x = right;
    factor.solve_coordinates(x);
    benchmark::DoNotOptimize(x.data());
  }
}

void EditAlm(benchmark::State& state) {
  HandleEditOptions options;
  options.engine = Engine::kAugmentedLagrangian;
  edit_cold(state, scene(2, static_cast<int>(state.range(0))), options);
}

void SubspaceOfSix(benchmark::State& state) {
  const Scene vault = scene(2, static_cast<int>(state.range(0)));
  const Positions edited = apply(vault.mesh, solve_handle_edit(vault.mesh, vault.at(1.0)));
  Subspace subspace;
  for (auto _ : state) {
    subspace = compute_subspace(vault.mesh, edited, {vault.handle}, {.dimension = 6});
  }
  state.counters["solve_ms"] = 1e3 * subspace.report.solve_seconds;
}

void SliderTick(benchmark::State& state) {
  const Scene vault = scene(2, static_cast<int>(state.range(0)));
  const Positions edited = apply(vault.mesh, solve_handle_edit(vault.mesh, vault.at(1.0)));
  const Subspace subspace = compute_subspace(vault.mesh, edited, {vault.handle}, {.dimension = 6});
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(subspace.dimension(), 0.3);
  Positions out;
  for (auto _ : state) {
    evaluate(subspace, x, out);
    benchmark::DoNotOptimize(out.data());
  }
}

BENCHMARK(EditColdVault)->Unit(benchmark::kMillisecond);
BENCHMARK(EditColdDome)->Unit(benchmark::kMillisecond);
BENCHMARK(DragVault)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(DragUnderACeiling)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(DragDome)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(EditCold)
    ->Arg(32)
    ->Arg(100)
    ->Arg(316)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(5);
BENCHMARK(Drag)
    ->Arg(32)
    ->Arg(100)
    ->Arg(316)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
/// The middle vertex of every mesh of the survey, lifted by a mean edge.
const bool kDragsRegistered = [] {
  for (const NamedMesh& named : samples_and_real_meshes()) {
    benchmark::RegisterBenchmark(("DragSurvey/" + named.name).c_str(),
                                 [mesh = named.mesh](benchmark::State& state) {
                                   Scene scene{made_flat(mesh), testing::middle_vertex(mesh)};
                                   scene.lift = mean_edge_length(scene.mesh);
                                   drag(state, scene);
                                 })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  }
  return true;
}();

BENCHMARK(EditBySize)
    ->Arg(1)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(5000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);
BENCHMARK(AlmStep)->Arg(32)->Arg(100)->Arg(316)->Unit(benchmark::kMillisecond);
BENCHMARK(AlmOnThreads)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(FactorSolve)->Arg(32)->Arg(100)->Arg(316)->Unit(benchmark::kMillisecond);
BENCHMARK(EditAlm)->Arg(32)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(SubspaceOfSix)->Arg(32)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(SliderTick)->Arg(316)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace planish::bench
