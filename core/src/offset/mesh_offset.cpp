// SPDX-License-Identifier: MIT
#include "planish/offset/mesh_offset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "numeric/plane_meeting.hpp"
#include "offset/edge_directions.hpp"
#include "offset/offset_measure.hpp"
#include "offset/panel_sides.hpp"
#include "offset/parallel_axes.hpp"
#include "offset/sphere_axes.hpp"
#include "planish/constraints/elements.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

constexpr std::array<std::pair<OffsetKind, std::string_view>, 3> kNames = {
    {{OffsetKind::kFace, "face"},
     {OffsetKind::kVertex, "vertex"},
     {OffsetKind::kParallel, "parallel"}}};

/// The element that is farthest from keeping `Kind`.
struct Defect {
  int where = -1;  ///< −1: none is out of its tolerance
  double measure = 0.0;
};

template <class Kind>
Defect worst_defect(const Mesh& mesh, const Adjacency& adjacency) {
  MeshElements elements(mesh, adjacency);
  Defect worst;
  double excess = Kind::kTolerance;
  for (int e = 0; e < elements.count(Kind::kElement); ++e) {
    const Violation here = violation_of<Kind>(mesh.positions, elements.of(Kind::kElement, e));
    if (here.excess <= excess) continue;
    excess = here.excess;
    worst = {e, here.measure};
  }
  return worst;
}

/// mesh.positions + distance · axes; at 0 the very same bits.
Positions moved_along(const Mesh& mesh, const Positions& axes, double distance) {
  if (distance == 0.0) return mesh.positions;
  return mesh.positions + distance * axes;
}

class Offsetter {
 public:
  Offsetter(const Mesh& mesh, const OutsideNormals& normals, double flatness, double distance)
      : mesh_(mesh),
        normals_(normals),
        distance_(distance),
        adjacency_(build_adjacency(mesh)),
        edges_(directed_edges(mesh)),
        slack_(slack(flatness)) {}

  /// The axes of the kind that is asked for, or of the first there is; or why there are none.
  [[nodiscard]] std::variant<std::pair<OffsetKind, Positions>, std::string> find(
      std::optional<OffsetKind> asked) const {
    if (!asked || asked == OffsetKind::kFace) {
      const Meetings meetings = worst_meetings();
      if (meetings.worst() > slack_) {
        if (asked) return why_no_meeting(meetings);
      } else {
        FittedAxes fit = fit_axes(mesh_, edges_, normals_, true,
                                  [&](const FittedAxes& now) { return now.miss <= slack_; });
        if (fit.miss <= slack_) return std::pair(OffsetKind::kFace, std::move(fit.axes));
        if (asked) return why_no_boundary(fit.miss);
      }
    }
    if (!asked || asked == OffsetKind::kVertex) {
      const Defect defect = worst_defect<CircularPolygon>(mesh_, adjacency_);
      FittedAxes fit;
      if (defect.where < 0) fit = reflect_axes(edges_, normals_.vertices);
      const bool found = defect.where < 0 && fit.miss <= slack_ && (asked || all_outside(fit.axes));
      if (found) return std::pair(OffsetKind::kVertex, std::move(fit.axes));
      if (asked) return why_no_vertex_offset(defect, fit.miss);
    }
    FittedAxes fit = fit_axes(mesh_, edges_, normals_, false,
                              [&](const FittedAxes& now) { return is_good_enough(now); });
    return std::pair(OffsetKind::kParallel, std::move(fit.axes));
  }

  [[nodiscard]] const std::vector<DirectedEdge>& edges() const { return edges_; }

 private:
  /// The largest residual of a row that counts as kept: rounding of the coordinates and panels that
  /// are as good as flat tilt the edges by as much.
  [[nodiscard]] double slack(double flatness) const {
    constexpr double kExact = 1e-9;
    constexpr double kCoarsest = 1e-6;
    constexpr double kUnits = 16.0;
    double shortest = std::numeric_limits<double>::infinity();
    for (const DirectedEdge& edge : edges_) {
      if (edge.direction.isZero(0.0)) continue;
      const Eigen::Vector3d along = mesh_.positions.col(edge.to) - mesh_.positions.col(edge.from);
      shortest = std::min(shortest, along.stableNorm());
    }
    const double largest = mesh_.positions.cwiseAbs().maxCoeff();
    const double rounding = std::numeric_limits<double>::epsilon() * largest / shortest;
    const double tilt = flatness / 1000.0;
    return std::clamp(kUnits * (rounding + tilt), kExact, kCoarsest);
  }

  /// Whether nobody could tell the offset from one with parallel edges.
  [[nodiscard]] bool is_good_enough(const FittedAxes& fit) const {
    constexpr double kParallel = 1e-7;
    const Positions there = moved_along(mesh_, fit.axes, distance_);
    return fit.miss <= kParallel &&
           planarity_summary(mesh_, there).max_excess <= PlanarPolygon::kTolerance;
  }

  /// Whether no axis points inwards: then nobody would want it without having asked.
  [[nodiscard]] bool all_outside(const Positions& axes) const {
    return (axes.cwiseProduct(normals_.vertices).colwise().sum().array() >= 0.0).all();
  }

  /// Points at which the planes at distance 1 are farthest from having a common one.
  struct Meetings {
    int four = -1;   ///< inside, of four panels: what a projection to conical mends
    int other = -1;  ///< any other
    double four_miss = 0.0, other_miss = 0.0;
    [[nodiscard]] double worst() const { return std::max(four_miss, other_miss); }
  };

  [[nodiscard]] Meetings worst_meetings() const {
    Meetings worst;
    std::vector<Eigen::Vector3d> around;
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      around.clear();
      for (const int f : adjacency_.faces[v]) {
        if (!normals_.faces.col(f).isZero(0.0)) around.emplace_back(normals_.faces.col(f));
      }
      if (around.size() < 4) continue;
      const bool four = around.size() == 4 && adjacency_.boundary[at(v)] == 0;
      const double miss = meet_planes(around, normals_.vertices.col(v)).miss;
      double& most = four ? worst.four_miss : worst.other_miss;
      if (miss <= most) continue;
      most = miss;
      (four ? worst.four : worst.other) = v;
    }
    return worst;
  }

  [[nodiscard]] std::string why_no_meeting(const Meetings& meetings) const {
    std::string start = "the planes at one distance do not meet: ";
    if (meetings.other_miss > slack_) {
      return start + "the " + std::to_string(adjacency_.faces[meetings.other].size()) +
             " around point " + std::to_string(meetings.other) + " miss a common point by " +
             number_text(meetings.other_miss) +
             " of the distance; --kind parallel gives the nearest offset";
    }
    std::vector<int> star{meetings.four};
    const auto neighbours = adjacency_.neighbours[meetings.four];
    star.insert(star.end(), neighbours.begin(), neighbours.end());
    return start + "point " + std::to_string(meetings.four) + " misses being conical by " +
           number_text(cone_defect(mesh_.positions, star)) +
           " deg; planish project --constraint conical makes the mesh conical";
  }

  [[nodiscard]] static std::string why_no_boundary(double miss) {
    return "the planes at one distance meet, but not in parallel edges: they miss by " +
           number_text(miss) + " of the distance; --kind parallel gives the nearest offset";
  }

  [[nodiscard]] static std::string why_no_vertex_offset(const Defect& defect, double miss) {
    if (defect.where >= 0) {
      return "points at one distance have no parallel edges: panel " +
             std::to_string(defect.where) + " misses a circle by " + number_text(defect.measure) +
             " deg; planish project --constraint circular makes the mesh circular";
    }
    return "points at one distance have no parallel edges: every panel is circular, but around "
           "panels with an odd number of corners, or around a hole, the axes miss each other by " +
           number_text(miss) + " of the distance; --kind parallel gives the nearest offset";
  }

  const Mesh& mesh_;
  const OutsideNormals& normals_;
  double distance_;
  Adjacency adjacency_;
  std::vector<DirectedEdge> edges_;
  double slack_;
};

}  // namespace

std::string_view kind_name(OffsetKind kind) {
  const auto row = std::find_if(kNames.begin(), kNames.end(),
                                [&](const auto& name) { return name.first == kind; });
  return row->second;
}

std::optional<OffsetKind> offset_kind(std::string_view name) {
  for (const auto& [kind, word] : kNames) {
    if (word == name) return kind;
  }
  return std::nullopt;
}

Refusal find_problem(const OffsetOptions& options) {
  if (!(std::abs(options.distance) <= kLargestCoordinate)) {
    return "distance must be a number from -1e100 to 1e100";
  }
  return std::nullopt;
}

std::variant<MeshOffset, std::string> offset_mesh(const Mesh& mesh, const OffsetOptions& options) {
  const PlanaritySummary flatness = planarity_summary(mesh);
  if (!(flatness.max_excess <= PlanarPolygon::kTolerance)) {
    return "panel " + std::to_string(flatness.worst_face) + " is out of its plane by " +
           number_text(flatness.max) + " mm/m; planish project makes the mesh flat";
  }
  const auto normals = outside_normals(mesh);
  if (!normals) return std::string("the surface has one side only: nothing is outside");
  const Offsetter offsetter(mesh, *normals, flatness.max, options.distance);
  auto found = offsetter.find(options.kind);
  if (auto* why = std::get_if<std::string>(&found)) return std::move(*why);
  MeshOffset offset;
  std::tie(offset.report.kind, offset.axes) =
      std::get<std::pair<OffsetKind, Positions>>(std::move(found));
  offset.positions = moved_along(mesh, offset.axes, options.distance);
  if (!(offset.positions.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
    return std::string("the offset has coordinates above 1e100");
  }
  measure_offset(mesh, offsetter.edges(), *normals, options.distance, offset);
  return offset;
}

}  // namespace planish
