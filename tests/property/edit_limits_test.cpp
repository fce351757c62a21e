// SPDX-License-Identifier: MIT
/// What limits hold: no panel or point of an edit exceeds one that did not, measured without the
/// rows.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/area_vector.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"
#include "support/slides.hpp"

namespace planish {
namespace {

constexpr double kDegrees = 57.29577951308232;

double degrees_from(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return kDegrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Figures of every panel, or of every pair of neighbours: what a limit is about.
using Figures = std::vector<double>;

Figures folds(const Mesh& mesh, const Positions& p) {
  std::map<std::pair<int, int>, std::vector<Eigen::Vector3d>> sides;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      sides[{std::min(a, b), std::max(a, b)}].push_back(area_vector(p, face));
    }
  }
  Figures result;
  for (const auto& [side, normals] : sides) {
    if (normals.size() == 2) result.push_back(degrees_from(normals[0], normals[1]));
  }
  return result;
}

Figures angles(const Mesh& mesh, const Positions& p) {
  Figures result;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Eigen::Vector3d here = p.col(face[k]);
      const Eigen::Vector3d in = p.col(face[(k + n - 1) % n]) - here;
      const Eigen::Vector3d out = p.col(face[(k + 1) % n]) - here;
      result.push_back(degrees_from(in, out));
    }
  }
  return result;
}

Figures edges(const Mesh& mesh, const Positions& p) {
  Figures result;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      result.push_back((p.col(face[(k + 1) % face.size()]) - p.col(face[k])).norm());
    }
  }
  return result;
}

Figures areas(const Mesh& mesh, const Positions& p) {
  Figures result;
  for (int f = 0; f < mesh.face_count(); ++f) {
    result.push_back(0.5 * area_vector(p, mesh.face(f)).norm());
  }
  return result;
}

/// The share of a sheet that each panel takes, laid along the best of its sides.
Figures fillings(const Mesh& mesh, const Positions& p, double shorter, double longer) {
  Figures result;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    double best = INFINITY;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Eigen::Vector3d x = (p.col(face[(k + 1) % face.size()]) - p.col(face[k])).normalized();
      const Eigen::Vector3d y = area_vector(p, face).normalized().cross(x);
      Eigen::Vector2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
      for (const int v : face) {
        const Eigen::Vector2d q(x.dot(p.col(v) - p.col(face[0])), y.dot(p.col(v) - p.col(face[0])));
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
      }
      const Eigen::Vector2d size = high - low;
      best = std::min({best, std::max(size.x() / longer, size.y() / shorter),
                       std::max(size.x() / shorter, size.y() / longer)});
    }
    result.push_back(best);
  }
  return result;
}

/// A limit with what it bounds: figures from `least` to `most`, or what the base has, with a little
/// more for what the base exceeds.
struct PanelLimit {
  std::string name, bound;
  std::function<Figures(const Mesh&, const Positions&)> measure;
  double least, most;
  double allowed;         ///< by which what exceeds the limit in the base may go on
  bool relative = false;  ///< `most` is added to the base's figure
};

/// Figures that exceed their limit, rounding aside.
int exceeding(const PanelLimit& limit, const Mesh& mesh, const Positions& after) {
  constexpr double kRounding = 1e-7;
  const Figures was = limit.measure(mesh, mesh.positions), is = limit.measure(mesh, after);
  int count = 0;
  for (std::size_t k = 0; k < is.size(); ++k) {
    const double most =
        std::max(limit.most + (limit.relative ? was[k] : 0.0), was[k] + limit.allowed);
    const double least = std::min(limit.least, was[k] - limit.allowed);
    count += is[k] <= most + kRounding && is[k] >= least - kRounding ? 0 : 1;
  }
  return count;
}

std::vector<PanelLimit> panel_limits(const Mesh& mesh) {
  const double edge = mean_edge_length(mesh);
  const Figures all = areas(mesh, mesh.positions);
  const double area = *std::max_element(all.begin(), all.end());
  const Figures open = angles(mesh, mesh.positions), long_edges = edges(mesh, mesh.positions);
  const Figures filled = fillings(mesh, mesh.positions, edge, edge);
  const auto largest = [](const Figures& f) { return *std::max_element(f.begin(), f.end()); };
  const auto least = [](const Figures& f) { return *std::min_element(f.begin(), f.end()); };
  // As the limit's text says them.
  const auto text = [](double number) { return std::to_string(number); };
  const auto number = [&](double value) { return std::stod(text(value)); };
  const double closed = number(least(open) - 15.0),
               wide = number(std::min(175.0, largest(open) + 15.0));
  const double low = number(0.85 * least(long_edges)), high = number(1.2 * largest(long_edges));
  const double large = number(1.15 * area);
  const double width = number(1.2 * largest(filled) * edge), height = number(0.99 * width);
  return {
      {"fold", "fold=25", folds, 0.0, 25.0, 0.1 + 1e-6},
      {"sharper", "fold=+5", folds, 0.0, 5.0, 0.1 + 1e-6, true},
      {"angle", "angle=" + text(closed) + ":" + text(wide), angles, closed, wide, 0.1 + 1e-6},
      {"edge", "edge=" + text(low) + ":" + text(high), edges, low, high, 2e-3 * 3.0 * edge},
      {"area", "area=" + text(large), areas, 0.0, large, 1e-3 * area},
      {"sheet", "sheet=" + text(width) + "x" + text(height),
       [=](const Mesh& m, const Positions& p) { return fillings(m, p, height, width); }, 0.0, 1.0,
       2e-3},
      {"slide", "slide=" + text(0.1 * edge), testing::slides, 0.0, number(0.1 * edge), 0.0},
  };
}

class EditLimits : public ::testing::TestWithParam<const char*> {
 protected:
  EditLimits() : mesh(testing::sample(GetParam(), testing::by_night(16, 12))) {}

  /// The page's way of editing, and the weights' own.
  [[nodiscard]] static std::vector<HandleEditOptions> ways() {
    HandleEditOptions soft;
    soft.reach = 5;
    soft.softness = 5.0;
    return {soft, {}};
  }

  /// WebAssembly, which runs the same code, is asked for one: all take it minutes.
  [[nodiscard]] static std::vector<double> lifts() {
#ifdef __EMSCRIPTEN__
    return {0.6};
#else
    return {0.6, 1.2};
#endif
  }

  [[nodiscard]] EditTargets targets(double lift) const {
    return testing::pull(mesh, testing::middle_vertex(mesh), {0.3 * lift, 0.0, lift});
  }

  Mesh mesh;
};

TEST_P(EditLimits, HoldInEveryEdit) {
  for (const PanelLimit& limit : panel_limits(mesh)) {
    for (HandleEditOptions options : ways()) {
      options.bounds = {*parse_stated_limit(limit.bound)};
      HandleEditSolver solver(mesh, options);
      for (const double lift : lifts()) {
        if (lift != lifts().back() && !testing::is_night()) continue;
        SCOPED_TRACE(limit.bound + " lift " + std::to_string(lift));
        const HandleEditResult result = solver.solve(targets(lift));
        EXPECT_EQ(exceeding(limit, mesh, apply(mesh, result)), 0);
        EXPECT_LE(result.report.planarity_after, testing::kPromise);
        EXPECT_GT(result.report.moved_vertices, 0);
        ASSERT_EQ(result.report.bounds.size(), 1u);
      }
    }
  }
}

TEST_P(EditLimits, HoldInEveryFrameOfADrag) {
  const int frames = testing::by_night(24, 12);
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  for (const PanelLimit& limit : panel_limits(mesh)) {
    for (HandleEditOptions options : ways()) {
      SCOPED_TRACE(limit.bound);
      options.bounds = {*parse_stated_limit(limit.bound)};
      HandleEditSolver solver(mesh, options);
      double furthest = 0.0;
      for (int frame = 1; frame <= frames; ++frame) {
        const HandleEditResult result = solver.drag(targets(1.2 * frame / frames), kBudget);
        EXPECT_EQ(exceeding(limit, mesh, apply(mesh, result)), 0) << "frame " << frame;
        furthest = std::max(furthest, result.report.max_displacement);
      }
      EXPECT_GT(furthest, 0.05);
    }
  }
}

/// Bit for bit: an inactive row exerts exactly nothing. (Other limits' rows join points that no row
/// joined, so that the elimination takes another order.)
TEST_P(EditLimits, ThatNothingMeetsChangeNoBit) {
  for (const HandleEditOptions& options : ways()) {
    for (const double lift : lifts()) {
      const HandleEditResult without = solve_handle_edit(mesh, targets(lift), options);
      ASSERT_EQ(without.report.status, SolveStatus::kConverged);
      for (const char* const wide : {"edge=0:100000", "slide=100000"}) {
        SCOPED_TRACE(wide + std::string(" lift ") + std::to_string(lift));
        HandleEditOptions limited = options;
        limited.bounds = {*parse_stated_limit(wide)};
        const HandleEditResult with = solve_handle_edit(mesh, targets(lift), limited);
        EXPECT_EQ(apply(mesh, with), apply(mesh, without));
        ASSERT_EQ(with.report.bounds.size(), 1u);
        EXPECT_TRUE(with.report.bounds[0].binding.empty());
      }
    }
  }
}

/// Nothing is given away: where a certified edit would go beyond a limit, it ends at it.
TEST_P(EditLimits, EndAtTheirBoundWhereTheyHold) {
  constexpr double kGivenAway = 1e-4;  // degrees
  int held = 0;
  for (HandleEditOptions options : ways()) {
    const Figures before = folds(mesh, mesh.positions);
    const auto most_growth = [&](const HandleEditResult& result) {
      const Figures after = folds(mesh, apply(mesh, result));
      double most = 0.0;
      for (std::size_t k = 0; k < after.size(); ++k) most = std::max(most, after[k] - before[k]);
      return most;
    };
    for (const double lift : lifts()) {
      const double free = most_growth(solve_handle_edit(mesh, targets(lift), options));
      options.bounds = {*parse_stated_limit("fold=+5")};
      const HandleEditResult result = solve_handle_edit(mesh, targets(lift), options);
      options.bounds.clear();
      if (result.report.status != SolveStatus::kConverged || free <= 5.0) continue;
      ++held;
      EXPECT_GE(most_growth(result), 5.0 - kGivenAway);
      EXPECT_LE(most_growth(result), 5.0 + 1e-6);
      EXPECT_GT(result.report.optimality->complementarity, 0.0) << "a margin of a millionth";
      EXPECT_LE(result.report.optimality->complementarity, 1e-5);
      EXPECT_FALSE(result.report.bounds[0].binding.empty());
    }
  }
  EXPECT_GT(held, 0);
}

/// Folds, edges and corners: what ends is certified, seeded points pulled by half an edge and one.
TEST(EditLimitsOn, AreCertified) {
  int edits = 0, certified = 0;
  for (const char* name : {"vault", "freeform", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, std::string(name) == "trihex" ? 12 : 24);
    const double edge = mean_edge_length(mesh);
    HandleEditOptions options;
    options.reach = 6;
    options.softness = 5.0;
    options.keep_boundary = true;
    const std::string lengths =
        "edge=" + std::to_string(0.8 * edge) + ":" + std::to_string(1.2 * edge);
    for (const std::string& bound :
         {std::string("fold=+8"), lengths, std::string("angle=60:120")}) {
      options.bounds = {*parse_stated_limit(bound)};
      HandleEditSolver solver(mesh, options);
      for (int k = 0; k < 8; ++k) {
        const int vertex = (137 * k + 211) % mesh.vertex_count();
        const Eigen::Vector3d move(0.0, 0.0, (k % 2 == 0 ? 0.5 : 1.0) * edge);
        const HandleEditResult result = solver.solve(testing::pull(mesh, vertex, move));
        ++edits;
        if (result.report.status == SolveStatus::kConverged) {
          ++certified;
        } else {
          std::cout << name << " " << vertex << " " << bound << " "
                    << status_name(result.report.status) << "\n";
        }
      }
    }
  }
  std::cout << certified << " of " << edits << " certified\n";
  EXPECT_GE(certified, 0.96 * edits);
}

INSTANTIATE_TEST_SUITE_P(Samples, EditLimits,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"),
                         [](const auto& each) { return std::string(each.param); });

/// Each limit is what holds the edit back: without it the same edit exceeds it on some sample.
TEST(EditLimitsOff, AreExceeded) {
  std::map<std::string, int> exceeded;
  for (const char* name : {"vault", "dome", "hex"}) {
    const Mesh mesh = testing::sample(name, 16);
    const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0.36, 0.0, 1.2});
    const Positions after = apply(mesh, solve_handle_edit(mesh, targets, {}));
    for (const PanelLimit& limit : panel_limits(mesh))
      exceeded[limit.name] += exceeding(limit, mesh, after);
  }
  for (const auto& [name, count] : exceeded) EXPECT_GT(count, 0) << name;
}

}  // namespace
}  // namespace planish
