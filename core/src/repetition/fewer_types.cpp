// SPDX-License-Identifier: MIT
#include "planish/repetition/fewer_types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "planish/constraints/mesh_limits.hpp"
#include "planish/fabrication/flat_panel.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "problem/shape_slides.hpp"
#include "projection/sound_projection.hpp"
#include "repetition/template_pull.hpp"

namespace planish {
namespace {

/// How wide families are, in `within`, from wide to narrow; a descent begins at its first.
constexpr std::array kWidths = {8.0, 6.0, 4.0, 3.0, 2.5, 2.0, 1.7, 1.5, 1.3, 1.15};
constexpr std::array kFirstWidths = {3.0, 8.0, 4.0, 6.0, 3.0, 8.0, 4.0, 6.0};
constexpr int kSortings = 4;      ///< at each width
constexpr int kSteps = 6;         ///< after each sorting
constexpr int kLastSteps = 12;    ///< before the mesh is made exactly flat
constexpr int kMendings = 8;      ///< of what came out spoilt, too far or beyond a limit
constexpr double kHeldMore = 10;  ///< as strongly as before
constexpr int kMostFailures = 2;  ///< descents in a row that find hardly any fewer
constexpr double kFewer = 0.99;   ///< of the types: what is worth another descent

constexpr double kAlone = 0.05;  ///< weight of keeping its shape, of a panel that is like no other

std::vector<FamilyShape> outlines_of(const Mesh& mesh) {
  std::vector<FamilyShape> outlines;
  outlines.reserve(at(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    outlines.push_back(
        flatten_panel(mesh.positions, face, longest_side(mesh.positions, face)).outline);
  }
  return outlines;
}

/// The template as the panel has it: corner by corner, turned over where it lies on its back.
FamilyShape template_on(const FamilyMember& member, const FamilyShape& shape) {
  FamilyShape corners(2, shape.cols());
  for (Eigen::Index k = 0; k < shape.cols(); ++k) {
    corners.col(k) =
        shape.col(member.template_column(static_cast<int>(k), static_cast<int>(shape.cols())));
  }
  if (member.mirrored) corners.row(1) *= -1.0;
  return corners;
}

Mesh in_mean_edges(Mesh mesh, double unit) {
  mesh.positions /= unit;
  return mesh;
}

double longest_of(const Eigen::Matrix3Xd& moves) {
  return moves.cols() > 0 ? std::sqrt(moves.colwise().squaredNorm().maxCoeff()) : 0.0;
}

/// One search within one distance.
class TypeSearch {
 public:
  TypeSearch(const Mesh& mesh, const FewerTypesOptions& options, const std::vector<int>& pins,
             const Progress& progress)
      : mesh_(mesh),
        options_(options),
        pins_(pins),
        progress_(progress),
        unit_(mean_edge_length(mesh)),
        scaled_(in_mean_edges(mesh, unit_)),
        adjacency_(build_adjacency(mesh)),
        limits_({mesh_, adjacency_, scaled_.positions, unit_}, options.bounds) {
    outlines_ = outlines_of(scaled_);
    if (hold_points(options.supports)) {
      slides_ = std::make_unique<VertexSlides>(mesh_, options.supports, unit_);
    }
    pull_ =
        std::make_unique<TemplatePull>(scaled_, pins, options.move / unit_, limits_, slides_.get());
    std::vector<char> pinned(at(mesh.vertex_count()), 0);
    for (const int v : pins) pinned[at(v)] = 1;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (pinned[at(v)] == 0) free_.push_back(v);
    }
  }

  [[nodiscard]] FewerTypes run(double within);

  /// The types of the given mesh.
  [[nodiscard]] Families types_within(double within) const {
    return find_families(outlines_of(mesh_), family_options(within));
  }

 private:
  [[nodiscard]] FamilyOptions family_options(double within) const {
    return {ShapeMeasure::kOutline, within, options_.mirrored};
  }
  [[nodiscard]] bool may_go_on(const SolveCost& cost);
  [[nodiscard]] std::vector<PanelGoal> goals(double width,
                                             const Eigen::Matrix3Xd& displacement) const;
  [[nodiscard]] std::vector<int> beyond_limits(const Positions& positions) const;
  [[nodiscard]] bool descend(double first_width, FewerTypes& best);
  [[nodiscard]] std::optional<Positions> made_flat(const Eigen::Matrix3Xd& displacement,
                                                   std::vector<int>& spoilt, FewerTypes& best);

  const Mesh& mesh_;
  const FewerTypesOptions& options_;
  const std::vector<int>& pins_;
  const Progress& progress_;
  double unit_;
  Mesh scaled_;  ///< mesh_ in mean edges
  Adjacency adjacency_;
  MeshLimits limits_;                  ///< of scaled_
  std::vector<FamilyShape> outlines_;  ///< of scaled_
  std::unique_ptr<VertexSlides> slides_;
  std::unique_ptr<TemplatePull> pull_;
  std::vector<int> free_;
  std::vector<double> held_;  ///< > 0: weight of keeping its shape, of a panel that came out spoilt
};

bool TypeSearch::may_go_on(const SolveCost& cost) {
  IterationRecord record;
  record.step = static_cast<double>(cost.steps);
  return !progress_ || progress_(record) == Flow::kContinue;
}

/// Each panel's template in families of a width; of those held, their shape as given.
std::vector<PanelGoal> TypeSearch::goals(double width, const Eigen::Matrix3Xd& displacement) const {
  Mesh moved = scaled_;
  moved.positions += displacement;
  const Families families = find_families(outlines_of(moved), family_options(width));
  std::vector<PanelGoal> goals;
  goals.reserve(at(mesh_.face_count()));
  for (std::size_t f = 0; f < families.members.size(); ++f) {
    const FamilyMember& member = families.members[f];
    const Family& family = families.families[at(member.family)];
    if (held_[f] > 0.0) {
      goals.push_back({outlines_[f], held_[f]});
    } else {
      goals.push_back(
          {template_on(member, family.shape), family.members.size() > 1 ? 1.0 : kAlone});
    }
  }
  return goals;
}

/// The nearest flat mesh, where it is sound and no point is too far; otherwise the panels to mend.
std::optional<Positions> TypeSearch::made_flat(const Eigen::Matrix3Xd& displacement,
                                               std::vector<int>& spoilt, FewerTypes& best) {
  Mesh moved = mesh_;
  moved.positions += unit_ * displacement;
  spoilt = spoilt_faces(mesh_, mesh_.positions, moved.positions);
  if (!spoilt.empty()) return std::nullopt;
  ProjectionOptions options;
  options.tolerance = options_.tolerance;
  options.supports = options_.supports;
  const std::array ladder = {Rung{0.0, false}};
  const SoundProjection flat =
      project_soundly(moved, mesh_, options, free_, pins_, ladder, Progress());
  best.cost += flat.report.cost;
  if (!flat.is_flat()) {
    spoilt = flat.failing;
    return std::nullopt;
  }
  const std::vector<int> beyond = beyond_limits(flat.positions);
  for (const int v : beyond) pull_->hold_back(v);
  if (!beyond.empty()) return std::nullopt;
  return flat.positions;
}

/// Vertices that are too far, and those of rows that are beyond their bound. Ascending.
std::vector<int> TypeSearch::beyond_limits(const Positions& positions) const {
  std::vector<int> beyond;
  for (int v = 0; v < mesh_.vertex_count(); ++v) {
    const Eigen::Vector3d move = positions.col(v) - mesh_.positions.col(v);
    if (move.norm() > options_.move) beyond.push_back(v);
  }
  const auto place = [&](int v) -> Eigen::Vector3d {
    return scaled_.positions.col(v) + (positions.col(v) - mesh_.positions.col(v)) / unit_;
  };
  for (int f = 0; f < mesh_.face_count(); ++f) {
    limits_.for_each_row(f, [&](auto, const auto& row, int, int) {
      if (row.scale.share(value(row, placed_points(row, place))) >= 0.0) return;
      beyond.insert(beyond.end(), row.vertices.begin(), row.vertices.end());
    });
  }
  std::sort(beyond.begin(), beyond.end());
  beyond.erase(std::unique(beyond.begin(), beyond.end()), beyond.end());
  return beyond;
}

/// Goes from the best so far through families of one width after the other. @returns whether there
/// are fewer types, and then `best` has them
bool TypeSearch::descend(double first_width, FewerTypes& best) {
  Eigen::Matrix3Xd displacement = (best.positions - mesh_.positions) / unit_;
  const double within = best.within / unit_;
  ++best.descents;
  if (slides_) slides_->open();
  for (const double width : kWidths) {
    for (int k = 0; k < kSortings && width <= first_width; ++k) {
      best.cost.steps += pull_->pull(goals(width * within, displacement), kSteps, displacement);
      best.cancelled = !may_go_on(best.cost);
      if (best.cancelled) return false;
    }
  }
  std::optional<Positions> flat;
  for (int k = 0; k < kMendings && !flat; ++k) {
    best.cost.steps +=
        pull_->pull(goals(kWidths.back() * within, displacement), kLastSteps, displacement);
    std::vector<int> spoilt;
    flat = made_flat(displacement, spoilt, best);
    for (const int f : spoilt) held_[at(f)] = held_[at(f)] > 0.0 ? kHeldMore * held_[at(f)] : 1.0;
  }
  if (!flat) return false;
  Mesh moved = mesh_;
  moved.positions = std::move(*flat);
  Families types = find_families(outlines_of(moved), family_options(best.within));
  if (types.families.size() >= best.types.families.size()) return false;
  best.types = std::move(types);
  best.positions = std::move(moved.positions);
  return true;
}

FewerTypes TypeSearch::run(double within) {
  FewerTypes best;
  best.within = within;
  best.positions = mesh_.positions;
  best.types = types_within(within);
  best.before = static_cast<int>(best.types.families.size());
  held_.assign(at(mesh_.face_count()), 0.0);
  int failures = 0;
  for (const double width : kFirstWidths) {
    const double worth = kFewer * static_cast<double>(best.types.families.size());
    const bool fewer = descend(width, best);
    if (best.cancelled) break;
    const bool enough = fewer && static_cast<double>(best.types.families.size()) <= worth;
    failures = enough ? 0 : failures + 1;
    if (failures >= kMostFailures) break;
  }
  best.merging = failures < kMostFailures && !best.cancelled;
  const Eigen::Matrix3Xd moves = best.positions - mesh_.positions;
  best.max_move = longest_of(moves);
  best.rms_move = std::sqrt(moves.squaredNorm() / std::max(1, mesh_.vertex_count()));
  return best;
}

/// The smallest distance found at which the mesh can have so many types.
FewerTypes with_most_types(TypeSearch& search, int most, double unit) {
  constexpr double kWidest = 1e6;  // mean edges: wider than any panel
  constexpr int kHalvings = 24, kTries = 6;
  constexpr double kCloser = 0.7071;
  const auto many = [&](double within) {
    return static_cast<int>(search.types_within(within).families.size()) > most;
  };
  double narrow = 1e-9 * unit, wide = narrow;
  while (many(wide) && wide < kWidest * unit) wide *= 2.0;
  for (int k = 0; k < kHalvings && wide > (1.0 + 1e-3) * narrow && narrow < wide; ++k) {
    const double middle = std::sqrt(narrow * wide);
    (many(middle) ? narrow : wide) = middle;
  }
  FewerTypes best = search.run(wide);
  best.reached = static_cast<int>(best.types.families.size()) <= most;
  double within = wide;
  int failures = 0;
  for (int k = 0; k < kTries && !best.cancelled && within > 2e-9 * unit; ++k) {
    within *= kCloser;
    FewerTypes next = search.run(within);
    next.cost += best.cost;
    next.descents += best.descents;
    // One that needs more types says nothing about a closer fit yet: descents end where they end.
    if (static_cast<int>(next.types.families.size()) > most) {
      best.cost = next.cost;
      best.descents = next.descents;
      best.cancelled = next.cancelled;
      if (++failures == kMostFailures) break;
    } else {
      best = std::move(next);
      failures = 0;
    }
  }
  return best;
}

}  // namespace

std::vector<StatedLimit> bounds_of_fewer_types(std::vector<StatedLimit> stated) {
  add_unstated(stated, {*parse_stated_limit("fold=+5")});
  return stated;
}

Refusal find_problem(const FewerTypesOptions& options) {
  if (options.most_types < 0) return "most_types must be at least 1";
  if (options.most_types == 0 && !(std::isfinite(options.within) && options.within > 0.0)) {
    return "within must be greater than 0";
  }
  if (!(std::isfinite(options.move) && options.move > 0.0)) return "move must be greater than 0";
  if (!(std::isfinite(options.tolerance) && options.tolerance > 0.0)) {
    return "tolerance must be greater than 0";
  }
  return std::nullopt;
}

Refusal find_problem(const FewerTypesOptions& options, const Mesh& mesh) {
  if (auto problem = find_problem(options)) return problem;
  if (auto problem = find_problem(options.bounds)) return problem;
  if (mesh.face_count() == 0) return "the mesh has no panels";
  if (planarity_summary(mesh).max_excess > options.tolerance) {
    return "the mesh is not flat: planish project makes it so";
  }
  std::set<std::size_t> sizes;
  for (int f = 0; f < mesh.face_count(); ++f) sizes.insert(mesh.face(f).size());
  if (options.most_types > 0 && at(options.most_types) < sizes.size()) {
    return "panels have " + std::to_string(sizes.size()) +
           " different numbers of corners: there are at least as many types";
  }
  return std::nullopt;
}

FewerTypes find_fewer_types(const Mesh& mesh, const FewerTypesOptions& options,
                            const std::vector<int>& pins, const Progress& progress) {
  const Stopwatch watch;
  TypeSearch search(mesh, options, pins, progress);
  FewerTypes found = options.most_types == 0
                         ? search.run(options.within)
                         : with_most_types(search, options.most_types, mean_edge_length(mesh));
  found.mirrored = options.mirrored;
  found.seconds = watch.seconds();
  return found;
}

}  // namespace planish
