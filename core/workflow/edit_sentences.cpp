// SPDX-License-Identifier: MIT
#include "edit_sentences.hpp"

#include <algorithm>
#include <vector>

#include "fair_run.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/constraints/slide_limit.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mean_normal.hpp"
#include "planish/text/number.hpp"
#include "type_change.hpp"

namespace planish::workflow {

namespace {

double pull_of(const EditRun& run, const Handle& handle) {
  return (handle.target - run.base.mesh.positions.col(handle.vertex)).norm();
}

double left_of(const EditRun& run, const Handle& handle) {
  return (handle.target - run.edited.col(handle.vertex)).norm();
}

/// How far from their targets handles of --hard are by rounding.
double hard_slack(const EditRun& run) {
  constexpr double kRounding = 1e-6;  // of the longest pull
  return kRounding * farthest_handle(run.targets.handles, run.base.mesh.positions);
}

/// How a point of the base stands to the keep-outs that a move goes towards.
struct BeforeKeepOuts {
  std::string rests;   ///< those that it is on or beyond
  std::string enters;  ///< those that the move ends beyond
};

BeforeKeepOuts before_keep_outs(const EditRun& run, int point, const Eigen::Vector3d& move) {
  const Mesh& mesh = run.base.mesh;
  const double touches = kSupportReach * mean_edge_length(mesh);
  BeforeKeepOuts before;
  const auto add = [](std::string& words, const KeepOut& keep_out) {
    words += (words.empty() ? "--keep-out " : " and --keep-out ") + keep_out_text(keep_out);
  };
  for (const KeepOut& keep_out : run.asked.options.keep_outs) {
    for (const HalfSpace& side : free_space({keep_out}, run.asked.options.clearance).sides) {
      const double room = side.normal.dot(mesh.positions.col(point)) - side.bound;
      const double way = side.normal.dot(move);
      if (way >= 0.0) continue;
      if (room <= touches) add(before.rests, keep_out);
      if (room + way < -touches) add(before.enters, keep_out);
    }
  }
  return before;
}

/// Whether no point of the panels around a vertex may follow it, which holds it unless they are
/// triangles.
bool follows_nothing(const EditRun& run, const Adjacency& adjacency, int vertex) {
  const Mesh& mesh = run.base.mesh;
  const std::vector<int> held = held_vertices(mesh, steps_of(run).images(), run.asked.options);
  bool stiff = false;
  for (const int f : adjacency.faces[vertex]) {
    stiff = stiff || mesh.face(f).size() > 3;
    for (const int v : mesh.face(f)) {
      if (v != vertex && !std::binary_search(held.begin(), held.end(), v)) return false;
    }
  }
  return stiff;
}

/// What of the request holds points, as what lets them go.
std::string ways_to_free(const EditRun& run) {
  const HandleEditOptions& options = run.asked.options;
  std::string words;
  const auto add = [&](bool stated, const char* way) {
    if (stated) words += (words.empty() ? "" : " or ") + std::string(way);
  };
  add(options.reach > 0 || options.reach_length > 0.0, "with a wider --reach");
  add(options.keep_boundary, "without --keep-boundary");
  add(!run.targets.pins.empty(), "with fewer --pin");
  return words;
}

Eigen::Vector3d way_of(const EditRun& run, const Handle& handle) {
  return handle.target - run.base.mesh.positions.col(handle.vertex);
}

/// What of the request leaves a handle no way to its target, and what would; nullopt if nothing.
std::optional<std::string> stuck_by(const EditRun& run, const Adjacency& adjacency,
                                    const Handle& handle) {
  const BeforeKeepOuts before = before_keep_outs(run, handle.vertex, way_of(run, handle));
  if (!before.enters.empty()) {
    return "its target is beyond " + before.enters +
           (before.rests.empty() ? "" : ", as it is itself before the edit") +
           ": another target or keep-out lets it move";
  }
  const std::string ways = ways_to_free(run);
  if (!ways.empty() && follows_nothing(run, adjacency, handle.vertex)) {
    return "no point around it may follow; some may " + ways;
  }
  return std::nullopt;
}

/// The keep-outs that hold points of the panels around a handle where they are.
std::optional<std::string> neighbours_rest(const EditRun& run, const Adjacency& adjacency,
                                           const Handle& handle) {
  for (const int f : adjacency.faces[handle.vertex]) {
    for (const int v : run.base.mesh.face(f)) {
      const std::string rests = before_keep_outs(run, v, way_of(run, handle)).rests;
      if (rests.empty()) continue;
      return "points around it are at " + rests +
             " or beyond before the edit and go no deeper: another keep-out lets them follow";
    }
  }
  return std::nullopt;
}

/// What keeps a handle from its target, as far as it is known.
std::string held_by(const EditRun& run, const Adjacency& adjacency, const Handle& handle) {
  for (const PointSupport& support : run.supports) {
    const std::vector<int> points = points_of(support, run.given);
    if (!is_spring(support) && std::binary_search(points.begin(), points.end(), handle.vertex)) {
      return "it stands on " + support_name(support);
    }
  }
  if (const auto stuck = stuck_by(run, adjacency, handle)) return *stuck;
  std::string bounds;
  for (const BoundStanding& bound : run.report.bounds) {
    if (!bound.binding.empty()) bounds += (bounds.empty() ? "" : ", ") + std::string(bound.name);
  }
  if (!bounds.empty()) return "held by " + bounds;
  if (const auto rest = neighbours_rest(run, adjacency, handle)) return *rest;
  if (run.asked.options.hard_handles) return "flat panels were not found any nearer";
  const bool reaches = run.asked.options.reach > 0 || run.asked.options.reach_length > 0.0;
  return std::string(reaches ? "a wider --reach lets more points follow, " : "") +
         "--attraction pulls harder, --hard holds it there";
}

}  // namespace

bool misses_most_panels(const EditRun& run) {
  if (!run.fewest || run.asked.fewest->most_panels == 0) return false;
  return run.fewest->panels > run.asked.fewest->most_panels;
}

bool misses_hard_handle(const EditRun& run) {
  if (!run.asked.options.hard_handles) return false;
  return farthest_handle(run.targets.handles, run.edited) > hard_slack(run);
}

namespace {

/// The handle that gets least near its target among those that get noticeably less far than they
/// are pulled, with --hard any less far; null if none.
const Handle* worst_handle(const EditRun& run) {
  constexpr double kNoticeable = 0.15;  // of the pull, as the page has it
  const bool hard = run.asked.options.hard_handles;
  const Handle* worst = nullptr;
  double most = 0.0;
  for (const Handle& handle : run.targets.handles) {
    const double left = left_of(run, handle);
    const double may = hard ? hard_slack(run) : kNoticeable * pull_of(run, handle);
    if (left <= may || left <= most) continue;
    most = left;
    worst = &handle;
  }
  return worst;
}

/// Which handle stops short, and what holds it; where outcome_sentence() says that one does, only
/// what leaves it no way at all.
std::optional<std::string> shortfall_sentence(const EditRun& run) {
  const bool infeasible = run.report.status == SolveStatus::kInfeasibleHandles;
  if (run.report.status != SolveStatus::kConverged && !infeasible) return std::nullopt;
  const Handle* const worst = worst_handle(run);
  if (worst == nullptr) return std::nullopt;
  const std::string name = "handle " + std::to_string(worst->vertex);
  const Adjacency adjacency = build_adjacency(run.base.mesh);
  if (infeasible) {
    const auto stuck = stuck_by(run, adjacency, *worst);
    return stuck ? std::optional(name + ": " + *stuck) : std::nullopt;
  }
  return name + " stops " + three_digits(left_of(run, *worst)) +
         " short of its target (units of the mesh): " + held_by(run, adjacency, *worst);
}

/// Panels about the handles, with their neighbours, and panels at a limit, ascending.
std::vector<int> held_panels(const EditRun& run, const Adjacency& adjacency) {
  const Mesh& mesh = run.base.mesh;
  std::vector<int> handles;
  for (const Handle& handle : run.targets.handles) handles.push_back(handle.vertex);
  std::vector<int> corners;
  for (const int f : faces_of(adjacency, handles)) {
    corners.insert(corners.end(), mesh.face(f).begin(), mesh.face(f).end());
  }
  std::vector<int> panels = faces_of(adjacency, corners);
  for (const BoundStanding& bound : run.report.bounds) {
    if (bound.name != "keep-out") {  // its are points
      panels.insert(panels.end(), bound.binding.begin(), bound.binding.end());
    }
  }
  std::sort(panels.begin(), panels.end());
  return panels;
}

/// A limit as --bound had it.
std::string limit_words(const EditRun& run, std::string_view name) {
  std::string words;
  for (const StatedLimit& limit : run.asked.options.bounds) {
    if (limit.name != name) continue;
    words += (words.empty() ? "" : " and ") + ("--bound " + stated_limit_text(limit));
  }
  return words;
}

/// Which limits of --bound panels of the base break already, and how many do, where that holds an
/// edit back that stops short of what was asked for.
std::optional<std::string> broken_limits_sentence(const EditRun& run) {
  const bool arrived =
      run.report.status == SolveStatus::kConverged && !shortfall_sentence(run).has_value();
  if (arrived || run.asked.options.bounds.empty()) return std::nullopt;
  const Mesh& mesh = run.base.mesh;
  const Adjacency adjacency = build_adjacency(mesh);
  const MeshLimits limits({mesh, adjacency, mesh.positions}, run.asked.options.bounds);
  const std::vector<int> held = held_panels(run, adjacency);
  for (const LimitExcess& excess : limit_excess(limits, mesh.face_count())) {
    const bool near = std::any_of(excess.panels.begin(), excess.panels.end(), [&](int f) {
      return std::binary_search(held.begin(), held.end(), f);
    });
    if (!near) continue;
    return std::to_string(excess.panels.size()) + " of " + std::to_string(mesh.face_count()) +
           " panels break " + limit_words(run, excess.name) +
           " before the edit and may not get worse, which holds it back: a wider limit frees them";
  }
  return std::nullopt;
}

/// The sentence that --bound slide stops a handle on its way along the surface, the one asked to go
/// furthest.
std::optional<std::string> sliding_target_sentence(const EditRun& run) {
  const StatedLimit* least = nullptr;
  for (const StatedLimit& limit : run.asked.options.bounds) {
    const bool narrower = least == nullptr || limit.most < least->most;
    if (limit.name == SlideLimit::kName && narrower) least = &limit;
  }
  if (least == nullptr || run.targets.handles.empty()) return std::nullopt;
  const Mesh& mesh = run.base.mesh;
  const Adjacency adjacency = build_adjacency(mesh);
  int vertex = -1;
  double most = least->most;
  for (const Handle& handle : run.targets.handles) {
    const Eigen::Vector3d move = handle.target - mesh.positions.col(handle.vertex);
    const auto around = adjacency.faces[handle.vertex];
    const double slide = across(move, mean_normal(mesh, mesh.positions, around)).norm();
    if (slide <= most) continue;
    most = slide;
    vertex = handle.vertex;
  }
  if (vertex < 0) return std::nullopt;
  return "the target of handle " + std::to_string(vertex) + " is " + three_digits(most) +
         " along the surface (units of the mesh), where --bound " + stated_limit_text(*least) +
         " stops it";
}

/// How far the surface moves and how far joints slide along it, where that is noticeably further or
/// has a limit.
std::optional<std::string> motion_sentence(const EditRun& run, const Json& report) {
  constexpr double kNoticeable = 0.5;    // of the shape's, as the page has it
  constexpr double kRoundedMove = 1e-6;  // mean edges
  const double shape = report["motion"]["shape_max"].get<double>();
  const double slide = report["motion"]["slide_max"].get<double>();
  const bool limited = has_limit(run.asked.options.bounds, SlideLimit::kName);
  const double rounding = kRoundedMove * mean_edge_length(run.base.mesh);
  if (!limited && slide <= std::max(kNoticeable * shape, rounding)) return std::nullopt;
  return "the surface moves by up to " + three_digits(shape) + ", joints slide along it by up to " +
         three_digits(slide) + " (units of the mesh)" +
         (limited ? "" : ": --bound slide=MAX limits it");
}

/// The sentence that --fewest held nothing, or how few panels it left.
std::optional<std::string> fewest_sentence(const EditRun& run, const Json& report) {
  if (!run.fewest) return std::nullopt;
  const FewestEdit& found = *run.fewest;
  if (!found.reached) {
    return "--fewest: with nothing held a handle stops " + three_digits(run.report.handle_error) +
           " short of its target (units of the mesh), more than --within-handle; nothing was held";
  }
  std::string sentence = "--fewest: " + std::to_string(found.panels) +
                         (found.panels == 1 ? " panel" : " panels") + " cut again in place of " +
                         std::to_string(found.panels_before);
  const int most = run.asked.fewest->most_panels;
  if (most > 0 && found.panels > most) {
    sentence += ", not the " + std::to_string(most) + " that were asked for";
  }
  if (!found.minimal && (most == 0 || found.panels > most)) {
    return sentence + "; stopped after " + std::to_string(found.solves) + " solves, fewer may do";
  }
  const std::size_t slivers = report["fewest"]["slivers"].size();
  if (slivers == 0) return sentence;
  return sentence + "; " + std::to_string(slivers) +
         (slivers == 1 ? " panel became a sliver" : " panels became slivers") +
         " with a corner below " + three_digits(kSliverAngle) +
         " degrees, which --bound angle=MIN:MAX and edge=MIN:MAX limit";
}

}  // namespace

std::vector<std::string> edit_messages(const EditRun& run, const Json& report,
                                       const std::vector<std::string>& variation) {
  std::vector<std::string> messages =
      said({damage_sentence(report["spoilt_faces"]), fold_sentence(report["sharpest_fold"]),
            outcome_sentence(run.report), motion_sentence(run, report), broken_limits_sentence(run),
            sliding_target_sentence(run), fewest_sentence(run, report),
            run.splits ? splits_sentence(*run.splits, run.report) : std::nullopt,
            run.fair ? fair_sentence(*run.fair) : std::nullopt, shortfall_sentence(run)});
  messages.insert(messages.end(), variation.begin(), variation.end());
  if (report.contains("types")) messages.push_back(type_change_sentence(report["types"]));
  return messages;
}

}  // namespace planish::workflow
