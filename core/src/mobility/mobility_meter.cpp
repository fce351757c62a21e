// SPDX-License-Identifier: MIT
#include "planish/mobility/mobility_meter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "planish/constraints/limit_kinds.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/fabrication/remake.hpp"
#include "planish/measures/folds.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mean_normal.hpp"

namespace planish {
namespace {

constexpr int kReach = 4;
/// What a drag in the page allows without being asked, degrees.
constexpr double kFoldGrowth = 10.0;
/// How often the step of a path is halved where it does not go on.
constexpr int kHalvings = 2;
/// Of an edit beside the path; one that ends well has some twenty.
constexpr int kMostSteps = 40;
/// Frames end after a few steps, not after a time: the result must not depend on the machine.
constexpr double kNoBudget = std::numeric_limits<double>::infinity();

/// Stated limits end a path and do not bend it.
HandleEditOptions of_paths(HandleEditOptions options) {
  options.hard_handles = true;
  options.bounds.clear();
  return options;
}

/// Whether the vertex is where it was asked for, on a design that is exact and sound.
bool is_met(const HandleEditResult& result) {
  return result.report.usable() && result.report.handle_error == 0.0 && !result.moved.empty();
}

/// An edit that is given up where others have long ended: what cannot be takes ten times as long as
/// what can, and is the same here.
HandleEditResult solve_briefly(HandleEditSolver& solver, const EditTargets& targets) {
  int steps = 0;
  return solver.solve(targets, [&](const IterationRecord&) {
    return ++steps < kMostSteps ? Flow::kContinue : Flow::kStop;
  });
}

/// z where the normals of the panels around a vertex cancel.
Eigen::Vector3d normal_at(const Mesh& mesh, const Adjacency& adjacency, int vertex) {
  const Eigen::Vector3d mean = mean_normal(mesh, mesh.positions, adjacency.faces[vertex]);
  return mean.isZero(0.0) ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : mean;
}

/// The direction of the first mesh line of the vertex, in the plane with normal `n`; of length 1.
Eigen::Vector3d first_line(const Mesh& mesh, const Adjacency& adjacency, int vertex,
                           const Eigen::Vector3d& n) {
  for (const int w : adjacency.neighbours[vertex]) {
    const Eigen::Vector3d edge = mesh.positions.col(w) - mesh.positions.col(vertex);
    const Eigen::Vector3d along = edge - n.dot(edge) * n;
    if (along.norm() > 0.1 * edge.norm()) return along.normalized();
  }
  return n.unitOrthogonal();
}

bool is_better(const MobilityRow& one, const MobilityRow& other) {
  return std::tuple(-one.distance, one.remake, one.sharpest_fold) <
         std::tuple(-other.distance, other.remake, other.sharpest_fold);
}

}  // namespace

HandleEditOptions MobilityOptions::default_edit() {
  HandleEditOptions options;
  options.reach = kReach;
  StatedLimit fold;
  fold.name = FoldLimit::kName;
  fold.most = kFoldGrowth;
  fold.relative = true;
  options.bounds = {fold};
  return options;
}

Refusal find_problem(const MobilityOptions& options) {
  if (auto problem = find_problem(options.edit)) return problem;
  if (auto problem = find_problem(options.edit.engine, Beyond::kMobility)) return problem;
  if (!(std::isfinite(options.range) && options.range >= 0.0)) {
    return "range must be 0 (the mean edge) or greater";
  }
  if (options.steps < 1 || options.steps > 1000) return "steps must be from 1 to 1000";
  return std::nullopt;
}

class MobilityMeter::State {
 public:
  State(const Mesh& mesh, const MobilityOptions& options)
      : mesh_(mesh),
        options_(options),
        adjacency_(build_adjacency(mesh)),
        limits_(LimitBase{mesh, adjacency_, mesh.positions, 1.0}, options.edit.bounds),
        solver_(mesh, of_paths(options.edit)),
        positions_(mesh.positions) {
    if (options_.range == 0.0) options_.range = mean_edge_length(mesh);
  }

  std::array<MobilityRow, kMobilityRows> measure(int vertex) {
    const Eigen::Vector3d n = normal_at(mesh_, adjacency_, vertex);
    const Eigen::Vector3d a = first_line(mesh_, adjacency_, vertex, n);
    const Eigen::Vector3d b = n.cross(a);
    std::array<MobilityRow, 4> surface = {row(vertex, a), row(vertex, -a), row(vertex, b),
                                          row(vertex, -b)};
    std::stable_sort(surface.begin(), surface.end(), is_better);
    return {row(vertex, {0.0, 0.0, 1.0}), row(vertex, {0.0, 0.0, -1.0}), surface[0], surface[1]};
  }

 private:
  /// One vertex on its way in one direction.
  struct Way {
    int vertex = 0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double distance = 0.0;       ///< of the farthest design that was found
    HandleEditResult design;     ///< that one
    std::optional<double> stop;  ///< the shortest move for which none was
    std::string_view broken;     ///< the limit that a panel reaches there; "": no design was found
  };

  [[nodiscard]] EditTargets targets(const Way& way, double distance) const {
    EditTargets targets;
    targets.handles = {{way.vertex, mesh_.positions.col(way.vertex) + distance * way.direction}};
    return targets;
  }

  /// The stated limit that `result` breaks, "" for none. Leaves positions_ as they were.
  std::string_view broken_limit(const HandleEditResult& result) {
    if (limits_.empty()) return {};
    positions_(Eigen::all, result.moved) = result.moved_positions;
    const auto standing =
        limit_standing(limits_, faces_of(adjacency_, result.moved),
                       [&](int v) -> Eigen::Vector3d { return positions_.col(v); });
    positions_(Eigen::all, result.moved) = mesh_.positions(Eigen::all, result.moved);
    const auto broken = std::find_if(standing.begin(), standing.end(),
                                     [](const auto& one) { return one.least_share < 0.0; });
    return broken == standing.end() ? std::string_view() : broken->name;
  }

  /// Takes the way to `distance` if `result` is there within the limits, else lets it stop there.
  bool take(Way& way, double distance, HandleEditResult result) {
    way.stop = distance;
    way.broken = {};
    if (!is_met(result)) return false;
    way.broken = broken_limit(result);
    if (!way.broken.empty()) return false;
    way.distance = distance;
    way.design = std::move(result);
    way.stop.reset();
    return true;
  }

  bool follow(Way& way, double distance) {
    solver_.keep_frame();
    if (take(way, distance, solver_.drag(targets(way, distance), kNoBudget))) return true;
    solver_.go_back();
    return false;
  }

  bool jump(Way& way, double distance) {
    return take(way, distance, solve_briefly(solver_, targets(way, distance)));
  }

  /// Distances are whole parts of the range, so that they are the same however they were reached.
  [[nodiscard]] int parts() const { return options_.steps << kHalvings; }
  [[nodiscard]] double length(int part) const { return options_.range * part / parts(); }

  /// Goes along the path of a drag, with shorter frames where one finds nothing or a panel reaches
  /// a limit. Where no frame finds anything, edits of their own take over. [MOB-1]
  void go(Way& way) {
    static_cast<void>(solver_.drag(targets(way, 0.0), kNoBudget));  // forgets the last path
    const int range = parts();
    int at = 0, wall = range + 1;
    std::string_view broken;  // at the wall
    for (int frame = 1 << kHalvings; frame > 0 && at < range;) {
      const int to = std::min(at + frame, range);
      if (to < wall && follow(way, length(to))) {
        at = to;
        continue;
      }
      if (to < wall && !way.broken.empty()) {
        wall = to;
        broken = way.broken;
      }
      frame /= 2;
    }
    if (at == range) return;
    way.stop = length(at + 1);
    way.broken = broken;
    if (wall > at + 1 && jump(way, length(at + 1))) go_on_by_edits(way, at + 1);
  }

  void go_on_by_edits(Way& way, int at) {
    int wall = parts();
    if (at == wall || jump(way, length(wall))) return;
    std::string_view broken = way.broken;
    while (wall - at > 1) {
      const int middle = at + (wall - at) / 2;
      if (jump(way, length(middle))) {
        at = middle;
        continue;
      }
      wall = middle;
      broken = way.broken;
    }
    way.stop = length(wall);
    way.broken = broken;
  }

  MobilityRow row(int vertex, const Eigen::Vector3d& direction) {
    Way way;
    way.vertex = vertex;
    way.direction = direction;
    go(way);
    MobilityRow row;
    row.vertex = vertex;
    row.direction = direction;
    row.distance = way.distance;
    row.limit = way.stop ? limit_at(way) : "range";
    const std::vector<int>& moved = way.design.moved;
    if (moved.empty()) return row;
    positions_(Eigen::all, moved) = way.design.moved_positions;
    const auto changes = panels_to_remake(mesh_, adjacency_, positions_, moved);
    const auto same = std::count(changes.begin(), changes.end(), PanelChange::kUnchanged);
    row.remake = static_cast<int>(static_cast<std::ptrdiff_t>(changes.size()) - same);
    const std::vector<int> faces = faces_of(adjacency_, moved);
    row.sharpest_fold = sharpest_fold(mesh_, adjacency_, positions_, faces).degrees;
    positions_(Eigen::all, moved) = mesh_.positions(Eigen::all, moved);
    return row;
  }

  /// What limits a move where no design was found: whether one is once panels need not keep their
  /// shape.
  std::string_view limit_at(const Way& way) {
    if (!way.broken.empty()) return way.broken;
    if (!options_.edit.keep_shape) return "search";
    if (!shapeless_) {
      HandleEditOptions options = of_paths(options_.edit);
      options.keep_shape = false;
      shapeless_.emplace(mesh_, options);
    }
    const bool goes_on = is_met(solve_briefly(*shapeless_, targets(way, *way.stop)));
    return goes_on ? "shape" : "search";
  }

  const Mesh& mesh_;
  MobilityOptions options_;
  Adjacency adjacency_;
  MeshLimits limits_;
  HandleEditSolver solver_;
  std::optional<HandleEditSolver> shapeless_;  ///< made when it is first needed
  Positions positions_;  ///< of the mesh; a design in place while it is measured
};

MobilityMeter::MobilityMeter(const Mesh& mesh, const MobilityOptions& options)
    : state_(std::make_unique<State>(mesh, options)) {}
MobilityMeter::~MobilityMeter() = default;
MobilityMeter::MobilityMeter(MobilityMeter&&) noexcept = default;
MobilityMeter& MobilityMeter::operator=(MobilityMeter&&) noexcept = default;

std::array<MobilityRow, kMobilityRows> MobilityMeter::measure(int vertex) {
  return state_->measure(vertex);
}

}  // namespace planish
