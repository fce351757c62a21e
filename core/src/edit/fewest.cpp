// SPDX-License-Identifier: MIT
#include "planish/edit/fewest.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/text/number.hpp"

namespace planish {
namespace {

/// A panel or a point that an edit moves, and how far.
struct Mover {
  double way = 0.0;  ///< the largest of its points
  std::vector<int> points;
};

class FewestSearch {
 public:
  FewestSearch(const Mesh& mesh, HandleEditSolver& solver, const EditTargets& targets,
               const FewestOptions& options, const MeshSymmetry* symmetry, const Progress& progress)
      : mesh_(mesh),
        adjacency_(build_adjacency(mesh)),
        solver_(solver),
        targets_(targets),
        options_(options),
        symmetry_(symmetry),
        progress_(progress),
        is_handle_(at(mesh.vertex_count()), 0),
        way_(at(mesh.vertex_count()), 0.0) {
    for (const Handle& handle : targets.handles) is_handle_[at(handle.vertex)] = 1;
    near_ = options.within_handle * farthest_handle(targets.handles, mesh.positions);
  }

  FewestEdit run() {
    best_.result = solve({});
    best_.reached = arrives(best_.result);
    best_.panels = best_.panels_before = count_panels(best_.result.moved);
    if (!best_.reached) return std::move(best_);
    measure_ways();
    hold_most();
    hold_panels();
    best_.minimal = hold_points();
    return std::move(best_);
  }

 private:
  /// Solves with these points held beside those of the best so far.
  HandleEditResult solve(const std::vector<int>& points) {
    ++best_.solves;
    EditTargets targets = targets_;
    targets.pins.insert(targets.pins.end(), best_.held.begin(), best_.held.end());
    targets.pins.insert(targets.pins.end(), points.begin(), points.end());
    HandleEditResult result = symmetry_ != nullptr
                                  ? solver_.solve_symmetric(targets, *symmetry_, progress_)
                                  : solver_.solve(targets, progress_);
    stopped_ = stopped_ || result.report.status == SolveStatus::kCancelled;
    return result;
  }

  [[nodiscard]] bool arrives(const HandleEditResult& result) const {
    return result.report.usable() && result.report.status != SolveStatus::kCancelled &&
           result.report.handle_error <= near_;
  }

  [[nodiscard]] bool may_go_on() const {
    const bool enough = options_.most_panels > 0 && best_.panels <= options_.most_panels;
    return !stopped_ && !enough && best_.solves < options_.most_solves;
  }

  /// How many of `movers` are worth holding at once.
  [[nodiscard]] std::size_t worth_holding(const std::vector<Mover>& movers) const {
    if (options_.most_panels == 0) return movers.size();
    return std::min(movers.size(), at(std::max(0, best_.panels - options_.most_panels)));
  }

  [[nodiscard]] std::vector<int> with_their_images(const std::vector<int>& points) const {
    return symmetry_ == nullptr ? points : images_of(*symmetry_, points);
  }

  /// Whether the handles arrive with these and their images held, too; then they are.
  bool hold(const std::vector<int>& asked) {
    const std::vector<int> points = with_their_images(asked);
    HandleEditResult result = solve(points);
    if (!arrives(result)) return false;
    best_.held.insert(best_.held.end(), points.begin(), points.end());
    std::sort(best_.held.begin(), best_.held.end());
    best_.held.erase(std::unique(best_.held.begin(), best_.held.end()), best_.held.end());
    best_.result = std::move(result);
    best_.panels = count_panels(best_.result.moved);
    measure_ways();
    return true;
  }

  void measure_ways() {
    std::fill(way_.begin(), way_.end(), 0.0);
    const HandleEditResult& result = best_.result;
    for (std::size_t k = 0; k < result.moved.size(); ++k) {
      const int v = result.moved[k];
      way_[at(v)] =
          (result.moved_positions.col(static_cast<Eigen::Index>(k)) - mesh_.positions.col(v))
              .norm();
    }
  }

  [[nodiscard]] int count_panels(const std::vector<int>& moved) const {
    return static_cast<int>(faces_of(adjacency_, moved).size());
  }

  [[nodiscard]] std::vector<int> points_to_hold() const {
    std::vector<int> points;
    for (const int v : best_.result.moved) {
      if (is_handle_[at(v)] == 0) points.push_back(v);
    }
    return points;
  }

  /// Points that move, handles excepted, those that move least first.
  [[nodiscard]] std::vector<Mover> moving_points() const {
    std::vector<Mover> movers;
    for (const int v : points_to_hold()) movers.push_back({way_[at(v)], {v}});
    return sorted(std::move(movers));
  }

  /// Panels that could stay as they are, those that move least first.
  [[nodiscard]] std::vector<Mover> moving_panels() const {
    if (options_.of == FewestOf::kPoints) return moving_points();
    std::vector<Mover> movers;
    for (const int face : faces_of(adjacency_, best_.result.moved)) {
      Mover mover;
      bool has_handle = false;
      for (const int v : mesh_.face(face)) {
        has_handle = has_handle || is_handle_[at(v)] != 0;
        if (way_[at(v)] == 0.0) continue;
        mover.way = std::max(mover.way, way_[at(v)]);
        mover.points.push_back(v);
      }
      if (!has_handle) movers.push_back(std::move(mover));
    }
    return sorted(std::move(movers));
  }

  static std::vector<Mover> sorted(std::vector<Mover> movers) {
    std::stable_sort(movers.begin(), movers.end(),
                     [](const Mover& a, const Mover& b) { return a.way < b.way; });
    return movers;
  }

  static std::vector<int> points_of_first(const std::vector<Mover>& movers, std::size_t count) {
    std::vector<int> points;
    for (std::size_t k = 0; k < count; ++k) {
      points.insert(points.end(), movers[k].points.begin(), movers[k].points.end());
    }
    return points;
  }

  /// Holds as many as can be held at once, by halves: most of what moves moves for the sake of
  /// fairness.
  void hold_most() {
    std::vector<Mover> movers = moving_panels();
    for (std::size_t count = worth_holding(movers); count > 1 && may_go_on();) {
      if (hold(points_of_first(movers, count))) {
        movers = moving_panels();
        count = std::min(count, worth_holding(movers));
      } else {
        count /= 2;
      }
    }
  }

  /// Holds one panel after the other.
  void hold_panels() {
    std::vector<Mover> movers = moving_panels();
    for (std::size_t k = 0; k < movers.size() && may_go_on(); ++k) {
      std::vector<int> points;
      for (const int v : movers[k].points) {
        if (way_[at(v)] > 0.0) points.push_back(v);
      }
      if (!points.empty()) hold(points);
    }
  }

  /// Holds one point after the other, until none can be held. @returns whether all were tried
  bool hold_points() {
    for (bool any = true; any;) {
      any = false;
      for (const Mover& mover : moving_points()) {
        if (!may_go_on()) return false;
        if (way_[at(mover.points.front())] > 0.0 && hold(mover.points)) any = true;
      }
    }
    return !stopped_;
  }

  const Mesh& mesh_;
  Adjacency adjacency_;
  HandleEditSolver& solver_;
  const EditTargets& targets_;
  const FewestOptions& options_;
  const MeshSymmetry* symmetry_;  ///< or null
  const Progress& progress_;
  std::vector<char> is_handle_;
  std::vector<double> way_;  ///< of each point in the best edit so far
  double near_ = 0.0;        ///< within which handles arrive
  FewestEdit best_;
  bool stopped_ = false;
};

}  // namespace

Refusal find_problem(const FewestOptions& options, const HandleEditOptions& edit,
                     const EditTargets& targets) {
  if (!(options.within_handle > 0.0 && options.within_handle < 1.0)) {
    return "within_handle must be more than 0 and less than 1: then handles move";
  }
  if (options.most_panels < 0) return "most_panels must be at least 1";
  if (options.most_panels > 0 && options.of == FewestOf::kPoints) {
    return "most_panels is for panels";
  }
  if (options.most_solves < 1) return "most_solves must be at least 1";
  if (auto problem = find_problem(edit.engine, Beyond::kFewest)) return problem;
  if (targets.handles.empty()) return "fewest needs a handle";
  return std::nullopt;
}

std::vector<StatedLimit> buildable_limits(const Mesh& mesh,
                                          const std::vector<StatedLimit>& stated) {
  const double edge = mean_edge_length(mesh);
  // With few digits, as designs and reports have the words.
  const std::array texts = {std::string(kBuildableCorners),
                            "edge=" + three_digits(0.2 * edge) + ":" + three_digits(5.0 * edge)};
  std::vector<StatedLimit> limits;
  for (const std::string& text : texts) {
    const std::optional<StatedLimit> limit = parse_stated_limit(text);
    const bool own = std::any_of(stated.begin(), stated.end(),
                                 [&](const StatedLimit& one) { return one.name == limit->name; });
    if (!own) limits.push_back(*limit);
  }
  return limits;
}

FewestEdit find_fewest(const Mesh& mesh, HandleEditSolver& solver, const EditTargets& targets,
                       const FewestOptions& options, const MeshSymmetry* symmetry,
                       const Progress& progress) {
  const auto search = [&](const FewestOptions& asked) {
    return FewestSearch(mesh, solver, targets, asked, symmetry, progress).run();
  };
  FewestEdit found = search(options);
  const bool missed = options.most_panels > 0 && found.panels > options.most_panels;
  if (!missed || !found.reached) return found;
  // Held in another order, fewer may do.
  FewestOptions all = options;
  all.most_panels = 0;
  FewestEdit fewest = search(all);
  fewest.solves += found.solves;
  return fewest.reached && fewest.panels < found.panels ? std::move(fewest) : std::move(found);
}

BuildableFewest find_buildable_fewest(const Mesh& mesh, const HandleEditOptions& options,
                                      const EditTargets& targets, const FewestOptions& fewest,
                                      const MeshSymmetry* symmetry, const Progress& progress) {
  const auto find = [&](HandleEditOptions within) {
    HandleEditSolver solver(mesh, within);
    FewestEdit edit = find_fewest(mesh, solver, targets, fewest, symmetry, progress);
    return BuildableFewest{std::move(edit), std::move(within)};
  };
  HandleEditOptions buildable = options;
  const auto limits = buildable_limits(mesh, options.bounds);
  buildable.bounds.insert(buildable.bounds.end(), limits.begin(), limits.end());
  BuildableFewest found = find(std::move(buildable));
  if (found.edit.reached || limits.empty() ||
      found.edit.result.report.status == SolveStatus::kCancelled) {
    return found;
  }
  BuildableFewest freer = find(options);
  return freer.edit.reached ? std::move(freer) : std::move(found);
}

}  // namespace planish
