// SPDX-License-Identifier: MIT
/// What a session says of its mesh and of the design shown.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "kind_defects.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/motion.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "session.hpp"

namespace planish {
namespace {

double largest_distance(const Positions& a, const Positions& b) {
  return a.cols() > 0 ? (a - b).colwise().norm().maxCoeff() : 0.0;
}

/// nullopt where nothing called `kind` has rows.
std::optional<KindSpread> spread_of(std::string_view kind, const Mesh& mesh,
                                    const Adjacency& adjacency) {
  std::vector<double> measures;
  Violation worst;
  for (const auto& defect : kind_defects(kind, mesh, adjacency, mesh.positions)) {
    if (!defect) continue;
    measures.push_back(defect->measure);
    worst.raise_to(*defect);
  }
  if (measures.empty()) return std::nullopt;
  const auto middle = measures.begin() + static_cast<std::ptrdiff_t>(measures.size() / 2);
  std::nth_element(measures.begin(), middle, measures.end());
  return KindSpread{
      .kind = kind, .median = *middle, .worst = worst.measure, .excess = worst.excess};
}

/// Kinds of one name once.
std::vector<KindSpread> kinds_of(const Mesh& mesh, const Adjacency& adjacency) {
  std::vector<KindSpread> kinds;
  std::string_view last = PlanarPolygon::kName;
  ConstraintKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName == last) return;
    last = Kind::kName;
    if (const auto spread = spread_of(Kind::kName, mesh, adjacency)) kinds.push_back(*spread);
  });
  return kinds;
}

}  // namespace

ShapeReport Session::report_of(const Positions& positions, const std::vector<int>& moved,
                               SolveReport solve, double seconds) const {
  const std::vector<int> touched = faces_of(adjacency_, moved);
  ShapeReport report;
  report.solve = std::move(solve);
  report.moved_vertices = static_cast<int>(moved.size());
  report.max_displacement = largest_move(positions, moved);
  report.motion = range_of(motions(base_, adjacency_, moved, positions));
  report.worst = worst_panel(positions, moved);
  report.fold_before = sharpest_fold(base_, adjacency_, base_.positions, touched).degrees;
  report.fold = sharpest_fold(base_, adjacency_, positions, touched);
  report.fold_growth = largest_fold_growth(base_, adjacency_, base_.positions, positions, touched);
  report.handle_error = farthest_handle(targets_.handles, positions);
  report.continuation = targets_.continuation;
  report.lower_at_once = lower_at_once_;
  report.seconds = seconds;
  return report;
}

void Session::renew_report(SolveReport solve, double seconds) {
  shape_report_ = report_of(current_, moved_, std::move(solve), seconds);
}

void Session::report_unsolved(double seconds) {
  SolveReport none;
  none.status = SolveStatus::kConverged;
  renew_report(std::move(none), seconds);
}

MeshReport Session::mesh_report() const {
  const bool is_planarised = before_planarising_.cols() > 0;
  const Positions& opened = is_planarised ? before_planarising_ : base_.positions;
  MeshReport report;
  report.summary = summarize(base_);
  report.degrees_of_freedom = degrees_of_freedom(base_);
  report.worst = base_worst_;
  report.planarised_vertices = moved_vertex_count(opened, base_.positions);
  report.planarised_most = largest_distance(opened, base_.positions);
  report.kinds = kinds_of(base_, adjacency_);
  report.centre = centre_;
  report.scale = scale_;
  report.warnings = warnings_;
  return report;
}

}  // namespace planish
