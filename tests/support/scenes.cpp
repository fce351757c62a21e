// SPDX-License-Identifier: MIT
#include "support/scenes.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>
#include <set>

#include "planish/measures/panel_health.hpp"
#include "planish/shapes/shapes.hpp"

namespace planish::testing {
namespace {

/// Twelve uniform numbers less six: near enough to normal, and the same bits everywhere, which
/// std::normal_distribution does not promise.
double normal_number(std::mt19937& engine) {
  double sum = -6.0;
  for (int k = 0; k < 12; ++k) sum += static_cast<double>(engine()) / 4294967296.0;
  return sum;
}

}  // namespace

std::vector<unsigned> seeds() {
  std::vector<unsigned> list{1, 2, 3, 4, 5, 6, 7, 8};
  if (const char* more = std::getenv("PLANISH_SEED")) {
    list.push_back(static_cast<unsigned>(std::strtoul(more, nullptr, 10)));
  }
  return list;
}

bool is_night() {
  const char* text = std::getenv("PLANISH_NIGHTLY");
  return text != nullptr && std::string(text) == "1";
}

int by_night(int all, int few) { return is_night() ? all : few; }

int action_count() {
  constexpr int kModerate = 12;
  const char* text = std::getenv("PLANISH_ACTIONS");
  return text != nullptr ? std::max(1, std::atoi(text)) : kModerate;
}

Eigen::Matrix3Xd random_points(unsigned seed, Eigen::Index count) {
  std::mt19937 engine(seed);
  return Eigen::Matrix3Xd::NullaryExpr(3, count, [&] { return normal_number(engine); });
}

Eigen::VectorXd random_vector(unsigned seed, Eigen::Index count) {
  std::mt19937 engine(seed);
  return Eigen::VectorXd::NullaryExpr(count, [&] { return normal_number(engine); });
}

Mesh quad_grid(int columns, int rows, const std::function<double(double, double)>& height) {
  Mesh mesh;
  mesh.positions.resize(3, columns * rows);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.positions.col(j * columns + i) = Eigen::Vector3d(i, j, height(i, j));
    }
  }
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = j * columns + i;
      for (const int v : {a, a + 1, a + columns + 1, a + columns}) mesh.face_vertices.push_back(v);
      mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
    }
  }
  return mesh;
}

Mesh quad_grid(int columns, int rows) {
  return quad_grid(columns, rows, [](double, double) { return 0.0; });
}

Mesh triangle_grid(int columns, int rows) {
  const Mesh quads = quad_grid(columns, rows);
  Mesh mesh;
  mesh.positions = quads.positions;
  for (int f = 0; f < quads.face_count(); ++f) {
    const auto q = quads.face(f);
    for (const int v : {q[0], q[1], q[2], q[0], q[2], q[3]}) {
      mesh.face_vertices.push_back(v);
      if (mesh.face_vertices.size() % 3 == 0) {
        mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
      }
    }
  }
  return mesh;
}

Mesh sample(const std::string& name, int size) { return make_sample(name, size).value(); }

EditTargets pull(const Mesh& mesh, int vertex, const Eigen::Vector3d& move) {
  EditTargets targets;
  targets.handles.push_back({vertex, mesh.positions.col(vertex) + move});
  return targets;
}

EditTargets public_scene_targets(const Mesh& mesh) {
  return pull(mesh, 16 * 32 + 16, {0.0, 0.0, 1.5});
}

std::vector<int> ring_neighbourhood(const Mesh& mesh, int vertex, int rings) {
  std::set<int> inside{vertex};
  for (int ring = 0; ring < rings; ++ring) {
    std::set<int> next = inside;
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      if (std::any_of(face.begin(), face.end(), [&](int v) { return inside.count(v) > 0; })) {
        next.insert(face.begin(), face.end());
      }
    }
    inside = std::move(next);
  }
  return {inside.begin(), inside.end()};
}

std::vector<int> moved_beyond(const Mesh& mesh, const HandleEditResult& result, double length) {
  std::vector<int> list;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    const Eigen::Vector3d move = result.moved_positions.col(static_cast<Eigen::Index>(k)) -
                                 mesh.positions.col(result.moved[k]);
    if (move.norm() > length) list.push_back(result.moved[k]);
  }
  return list;
}

int spoilt_count(const Mesh& base, const Positions& after) {
  int count = 0;
  for (int f = 0; f < base.face_count(); ++f) {
    count += panel_damage(base.positions, after, base.face(f)) != PanelDamage::kNone ? 1 : 0;
  }
  return count;
}

Positions varied(const Positions& edited, const Subspace& subspace, const Eigen::VectorXd& values) {
  Positions rows;
  evaluate(subspace, values, rows);
  Positions positions = edited;
  positions(Eigen::all, subspace.support) = rows;
  return positions;
}

int middle_vertex(const Mesh& mesh) {
  const Eigen::Vector3d middle =
      0.5 * (mesh.positions.rowwise().minCoeff() + mesh.positions.rowwise().maxCoeff());
  Eigen::Index nearest = 0;
  // Height left out: the middle of a dome's box lies far below its top.
  (mesh.positions.topRows<2>().colwise() - middle.head<2>()).colwise().norm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

ProblemOnMesh::ProblemOnMesh(const Mesh& mesh, FairnessKind kind) : model(mesh, kind) {
  problem.model = &model;
  problem.fairness_weight = 1.0;
  problem.terms.assign(static_cast<std::size_t>(mesh.vertex_count()),
                       VertexTerm{.norm_weight = 1.0});
}

void ProblemOnMesh::add_handle(int vertex, const Eigen::Vector3d& target, double attraction) {
  problem.terms[static_cast<std::size_t>(vertex)] =
      VertexTerm{.square_weight = attraction, .target = target, .handle = true};
  problem.handles.push_back(vertex);
}

Patch ProblemOnMesh::cut(const std::vector<int>& free) {
  PatchCutter cutter(model);
  Patch patch;
  cutter.cut(problem, free, patch);
  return patch;
}

Patch ProblemOnMesh::cut_all() {
  std::vector<int> all(static_cast<std::size_t>(model.vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  return cut(all);
}

}  // namespace planish::testing
