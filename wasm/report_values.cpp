// SPDX-License-Identifier: MIT
#include "report_values.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "planish/constraints/planar_polygon.hpp"

namespace planish {
namespace {

using emscripten::val;

val to_value(int number) { return val(number); }
val to_value(bool flag) { return val(flag); }
val to_value(double number) { return std::isfinite(number) ? val(number) : val::null(); }
val to_value(std::string_view text) { return val(std::string(text)); }

template <class T>
val to_value(const std::vector<T>& list) {
  val array = val::array();
  for (std::size_t k = 0; k < list.size(); ++k) array.set(k, to_value(list[k]));
  return array;
}

/// A plain object, field by field.
class Object {
 public:
  template <class T>
  Object& add(const char* key, const T& value) {
    return put(key, to_value(value));
  }
  Object& put(const char* key, const val& value) {
    object_.set(key, value);
    return *this;
  }
  Object& put(std::string_view key, const val& value) {
    object_.set(std::string(key), value);
    return *this;
  }
  [[nodiscard]] const val& value() const { return object_; }

 private:
  val object_ = val::object();
};

Object& add_worst(Object& object, const WorstPanel& worst) {
  return object.add("worstGap", worst.gap)
      .add("worstMmPerM", worst.mm_per_m)
      .add("worstExcess", worst.excess);
}

std::vector<double> residuals(const SolveReport& solve) {
  std::vector<double> list;
  for (const IterationRecord& record : solve.records) list.push_back(record.primal_residual);
  return list;
}

/// Without fields where there is no certificate: a drag's frame, a variation, a step of the
/// history.
val optimality_value(const SolveReport& solve) {
  Object object;
  if (solve.optimality) {
    object.add("stationarity", solve.optimality->stationarity)
        .add("outside", solve.optimality->outside)
        .add("complementarity", solve.optimality->complementarity)
        .add("certifiedVertices", solve.optimality->certified_vertices);
  }
  return object.value();
}

/// What each stated limit binds, by its name.
val bounds_value(const SolveReport& solve) {
  Object object;
  for (const BoundStanding& bound : solve.bounds) object.put(bound.name, to_value(bound.binding));
  return object.value();
}

/// Violations by the name of each kind that is kept beside planarity.
val violations_value(const SolveReport& solve) {
  Object object;
  for (const KindViolation& one : solve.violations) {
    if (one.kind == PlanarPolygon::kName) continue;
    object.put(one.kind,
               Object().add("before", one.before_max).add("after", one.after_max).value());
  }
  return object.value();
}

val fold_value(const ShapeReport& report) {
  return Object()
      .add("before", report.fold_before)
      .add("after", report.fold.degrees)
      .add("growth", report.fold_growth)
      .add("panels", std::vector<int>{report.fold.face, report.fold.neighbour})
      .value();
}

val motion_value(const MotionRange& motion) {
  return Object()
      .add("raised", motion.raised)
      .add("lowered", motion.lowered)
      .add("slide", motion.slide)
      .value();
}

}  // namespace

val to_value(const ShapeReport& report) {
  const SolveReport& solve = report.solve;
  Object object;
  add_worst(object, report.worst)
      .add("status", status_name(solve.status))
      .add("movedVertices", report.moved_vertices)
      .add("maxDisplacement", report.max_displacement)
      .put("motion", motion_value(report.motion))
      .put("sharpestFold", fold_value(report))
      .add("handleError", report.handle_error)
      .add("objective", solve.objective.total())
      .add("continuation", report.continuation)
      .add("lowerAtOnce", report.lower_at_once)
      .add("iterations", solve.cost.steps)
      .add("seconds", report.seconds)
      .add("residuals", residuals(solve))
      .put("optimality", optimality_value(solve))
      .put("bounds", bounds_value(solve))
      .put("violations", violations_value(solve));
  return object.value();
}

val to_value(const VariationsReport& report) {
  const SubspaceReport& subspace = report.subspace;
  return Object()
      .add("status", status_name(subspace.status))
      .add("dimension", report.dimension)
      .add("correlation", subspace.correlation)
      .add("seconds", report.seconds)
      .value();
}

val to_value(const MeshReport& report) {
  const MeshSummary& summary = report.summary;
  Object sizes;
  for (const auto& [size, count] : summary.face_sizes) {
    sizes.put(std::to_string(size), to_value(count));
  }
  Object planarising;
  planarising.add("moved", report.planarised_vertices).add("largest", report.planarised_most);
  Object kinds;
  for (const KindSpread& spread : report.kinds) {
    Object degrees;
    degrees.add("median", spread.median).add("worst", spread.worst).add("excess", spread.excess);
    kinds.put(spread.kind, degrees.value());
  }
  Object object;
  add_worst(object, report.worst)
      .add("vertices", summary.vertices)
      .add("faces", summary.faces)
      .put("faceSizes", sizes.value())
      .add("boundaryLoops", summary.boundary_loops)
      .add("components", summary.components)
      .add("nonmanifoldEdges", summary.nonmanifold_edges)
      .add("meanEdge", summary.mean_edge)
      .add("degreesOfFreedom", report.degrees_of_freedom)
      .put("planarising", planarising.value())
      .put("kinds", kinds.value())
      .add("centre", std::vector<double>(report.centre.begin(), report.centre.end()))
      .add("scale", report.scale)
      .add("warnings", report.warnings);
  return object.value();
}

}  // namespace planish
