// SPDX-License-Identifier: MIT
/// Both engines on the same edit of every sample and every real mesh: who ends lower.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "planish/handle_edit.hpp"
#include "planish/io/obj.hpp"
#include "planish/projection.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish::bench {
namespace {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

std::vector<NamedMesh> samples_and_real_meshes() {
  std::vector<NamedMesh> meshes;
  for (const char* name : {"vault", "dome", "freeform"}) {
    meshes.push_back({name, testing::sample(name, 32)});
  }
  for (const char* name : {"hex", "trihex"}) meshes.push_back({name, testing::sample(name, 20)});
  const std::filesystem::path folder = PLANISH_SHARED_MESHES;
  std::vector<std::string> files;
  if (std::filesystem::exists(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".obj") files.push_back(entry.path().filename().string());
    }
  }
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) {
    const auto bytes = testing::shared_mesh_bytes(file);
    const auto read = read_obj(bytes.value_or(""));
    if (const auto* found = std::get_if<MeshFile>(&read)) meshes.push_back({file, found->mesh});
  }
  return meshes;
}

/// The middle vertex of the planarised mesh, lifted by half an edge.
void edit(benchmark::State& state, const Mesh& mesh, Engine engine) {
  Mesh flat = mesh;
  const ProjectionResult projected = project_to_planar(mesh);
  for (std::size_t k = 0; k < projected.moved.size(); ++k) {
    flat.positions.col(projected.moved[k]) =
        projected.moved_positions.col(static_cast<Eigen::Index>(k));
  }
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
