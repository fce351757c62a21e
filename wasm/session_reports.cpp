// SPDX-License-Identifier: MIT
/// What a session says of its mesh and of the design shown, as JSON.
#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "json_text.hpp"
#include "kind_defects.hpp"
#include "planish/folds.hpp"
#include "planish/mesh_check.hpp"
#include "planish/metrics.hpp"
#include "session.hpp"

namespace planish {
namespace {

std::vector<double> residuals(const SolveReport& report) {
  std::vector<double> list;
  for (const IterationRecord& record : report.records) list.push_back(record.primal_residual);
  return list;
}

double largest_distance(const Positions& a, const Positions& b) {
  return a.cols() > 0 ? (a - b).colwise().norm().maxCoeff() : 0.0;
}

/// Empty where there is no certificate: a drag's frame, a variation, a step of the history.
JsonText optimality_text(const SolveReport& solve) {
  JsonText text;
  if (solve.optimality) {
    text.add("stationarity", solve.optimality->stationarity)
        .add("outside", solve.optimality->outside)
        .add("certifiedVertices", solve.optimality->certified_vertices);
  }
  return text;
}

/// The panels that each stated limit holds back; empty where no limits were looked at.
JsonText bounds_text(const SolveReport& solve) {
  JsonText text;
  for (const BoundStanding& bound : solve.bounds) text.add(bound.name, bound.binding);
  return text;
}

/// The worst of each kind that is kept beside planarity, in its unit.
JsonText violations_text(const SolveReport& solve) {
  JsonText text;
  for (const KindViolation& one : solve.violations) {
    if (one.kind == PlanarPolygon::kName) continue;
    text.add(one.kind, JsonText().add("before", one.before_max).add("after", one.after_max));
  }
  return text;
}

/// Of one kind, on the elements that it bounds: half of them are below `median`, degrees.
JsonText defects(std::string_view kind, const Mesh& mesh, const Adjacency& adjacency) {
  std::vector<double> measures;
  Violation worst;
  for (const auto& defect : kind_defects(kind, mesh, adjacency, mesh.positions)) {
    if (!defect) continue;
    measures.push_back(defect->measure);
    worst.raise_to(*defect);
  }
  JsonText text;
  if (measures.empty()) return text;
  const auto middle = measures.begin() + static_cast<std::ptrdiff_t>(measures.size() / 2);
  std::nth_element(measures.begin(), middle, measures.end());
  return text.add("median", *middle).add("worst", worst.measure).add("excess", worst.excess);
}

JsonText kinds_text(const Mesh& mesh, const Adjacency& adjacency) {
  JsonText text;
  std::string_view last = PlanarPolygon::kName;
  ConstraintKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName == last) return;
    last = Kind::kName;
    text.add(Kind::kName, defects(Kind::kName, mesh, adjacency));
  });
  return text;
}

}  // namespace

std::string Session::shape_report(const Positions& positions, const std::vector<int>& moved,
                                  const SolveReport& solve, double seconds) const {
  const Worst worst = worst_panel(positions, moved);
  double handle_error = 0.0;
  for (const auto& [vertex, target] : targets_.handles) {
    handle_error = std::max(handle_error, (positions.col(vertex) - target).norm());
  }
  const std::vector<int> touched = faces_of(adjacency_, moved);
  const Fold sharpest = sharpest_fold(base_, adjacency_, positions, touched);
  JsonText fold;
  fold.add("before", sharpest_fold(base_, adjacency_, base_.positions, touched).degrees)
      .add("after", sharpest.degrees)
      .add("panels", std::vector<int>{sharpest.face, sharpest.neighbour});
  return JsonText()
      .add("status", status_name(solve.status))
      .add("movedVertices", moved.size())
      .add("maxDisplacement", largest_move(positions, moved))
      .add("worstGap", worst.gap)
      .add("worstMmPerM", worst.mm_per_m)
      .add("worstExcess", worst.excess)
      .add("sharpestFold", fold)
      .add("handleError", handle_error)
      .add("objective", solve.objective.total())
      .add("continuation", targets_.continuation)
      .add("lowerAtOnce", lower_at_once_)
      .add("iterations", solve.iterations)
      .add("seconds", seconds)
      .add("residuals", residuals(solve))
      .add("optimality", optimality_text(solve))
      .add("bounds", bounds_text(solve))
      .add("violations", violations_text(solve))
      .text();
}

void Session::write_report(const SolveReport& solve, double seconds) {
  report_ = shape_report(current_, moved_, solve, seconds);
}

std::string Session::mesh_report() const {
  const MeshSummary summary = summarize(base_);
  JsonText sizes;
  for (const auto& [size, count] : summary.face_sizes) sizes.add(std::to_string(size), count);
  const bool planarised = before_planarising_.cols() > 0;
  const Positions& opened = planarised ? before_planarising_ : base_.positions;
  JsonText planarising;
  planarising.add("moved", moved_vertex_count(opened, base_.positions))
      .add("largest", largest_distance(opened, base_.positions));
  return JsonText()
      .add("vertices", summary.vertices)
      .add("faces", summary.faces)
      .add("faceSizes", sizes)
      .add("boundaryLoops", summary.boundary_loops)
      .add("components", summary.components)
      .add("nonmanifoldEdges", summary.nonmanifold_edges)
      .add("isolatedVertices", summary.isolated_vertices)
      .add("meanEdge", summary.mean_edge)
      .add("degreesOfFreedom", degrees_of_freedom(base_))
      .add("worstGap", base_worst_.gap)
      .add("worstMmPerM", base_worst_.mm_per_m)
      .add("worstExcess", base_worst_.excess)
      .add("planarising", planarising)
      .add("kinds", kinds_text(base_, adjacency_))
      .add("centre", std::vector<double>(centre_.begin(), centre_.end()))
      .add("scale", scale_)
      .add("warnings", warnings_)
      .text();
}

}  // namespace planish
