// SPDX-License-Identifier: MIT
/// Each cut in the middle of grids of 100, 1,000 and 10,000 quads: what the page waits for after a
/// click, but for the edit that follows.
#include <benchmark/benchmark.h>

#include <string>
#include <variant>

#include "planish/cuts/cut_mesh.hpp"
#include "support/scenes.hpp"

namespace planish::bench {
namespace {

/// @param state range(0) points a side
/// @param cut its text, where F is a panel in the middle, V and W are the ends of one of its
/// diagonals, N is beside V, and H is a level across the mesh
void make_cut(benchmark::State& state, std::string cut) {
  const int size = static_cast<int>(state.range(0)), middle = size / 2;
  const Mesh mesh = testing::sample("vault", size);
  const int panel = middle * (size - 1) + middle;
  const auto corners = mesh.face(panel);
  const auto put = [&](char name, const std::string& value) {
    for (auto at = cut.find(name); at != std::string::npos; at = cut.find(name)) {
      cut.replace(at, 1, value);
    }
  };
  put('F', std::to_string(panel));
  put('V', std::to_string(corners[0]));
  put('N', std::to_string(corners[1]));
  put('W', std::to_string(corners[2]));
  put('H', std::to_string(mesh.positions.row(0).mean() + 0.1));
  const Cut parsed = std::get<Cut>(parse_cut(cut));
  std::size_t panels = 0;
  for (auto _ : state) {
    const auto made = cut_mesh(mesh, {parsed});
    if (!std::holds_alternative<CutMesh>(made)) return state.SkipWithError("refused");
    panels = std::get<CutMesh>(made).parents.size();
  }
  state.counters["panels"] = static_cast<double>(panels);
}

void every_size(benchmark::internal::Benchmark* run) {
  run->Arg(11)->Arg(33)->Arg(101)->Unit(benchmark::kMicrosecond);
}

BENCHMARK_CAPTURE(make_cut, split, "split=F:V,W")->Apply(every_size);
BENCHMARK_CAPTURE(make_cut, strip, "strip=V-N@0.4")->Apply(every_size);
BENCHMARK_CAPTURE(make_cut, corner, "corner=F:V@0.5")->Apply(every_size);
BENCHMARK_CAPTURE(make_cut, refine, "refine=F:collar")->Apply(every_size);
BENCHMARK_CAPTURE(make_cut, trim, "trim=1,0,0,H")->Apply(every_size);

}  // namespace
}  // namespace planish::bench
