// SPDX-License-Identifier: MIT
#include "edit_run.hpp"

#include <algorithm>
#include <utility>

#include "cut_run.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/text/number.hpp"
#include "report.hpp"

namespace planish::workflow {
namespace {

EditTargets all_images(const EditTargets& targets, const Mesh& base, const MeshSymmetry& symmetry) {
  auto all = with_images(targets, base, symmetry);
  if (auto* why = std::get_if<std::string>(&all)) throw UsageError(*why);
  return std::get<EditTargets>(std::move(all));
}

}  // namespace

FlatBase flat_base(const Mesh& mesh, const HandleEditOptions& options, const Progress& progress) {
  FlatBase base{mesh, {}, std::nullopt};
  if (planarity_summary(mesh).max_excess <= options.tolerance) return base;
  base.planarised = planarise(mesh, base.how, progress);
  if (base.planarised->report.status == SolveStatus::kToleranceNotMet) {
    base.how = kNearestFlat;  // an edit needs a flat base: what this spoils is reported
    base.planarised = planarise(mesh, base.how, progress);
  }
  base.mesh.positions(Eigen::all, base.planarised->moved) = base.planarised->moved_positions;
  return base;
}

std::optional<std::string> planarised_sentence(const FlatBase& base) {
  if (!base.planarised) return std::nullopt;
  return "not flat; planarised first, which moved " +
         std::to_string(base.planarised->moved.size()) + " vertices by up to " +
         three_digits(base.planarised->max_move) + " (units of the mesh)" +
         (base.planarised->report.status == SolveStatus::kIterationLimit
              ? ", not certified to be the best flat mesh near"
              : "");
}

std::optional<std::string> evened_sentence(const EditRun& run) {
  if (run.evened.max_move == 0.0) return std::nullopt;
  return "not exactly symmetric; made so first, which moved " + std::to_string(run.evened.moved) +
         " vertices by up to " + three_digits(run.evened.max_move) + " (units of the mesh)";
}

std::optional<std::string> moved_support_sentence(const EditRun& run) {
  if (!run.base.planarised) return std::nullopt;
  double most = 0.0;
  std::string name;
  for (const PointSupport& support : run.supports) {
    if (is_spring(support)) continue;
    for (const int v : points_of(support, run.given)) {
      const double move = (run.base.mesh.positions.col(v) - run.given.positions.col(v)).norm();
      if (move <= most) continue;
      most = move;
      name = support_name(support);
    }
  }
  if (most <= kSupportReach * mean_edge_length(run.given)) return std::nullopt;  // rounding
  return "that moved points of " + name + " by up to " + three_digits(most) +
         ", and the edit has them where they are since: planish project --support " + name +
         " makes the file flat with them where they stand";
}

namespace {

/// What keeps a handle from its target, as far as it is known.
std::string held_by(const EditRun& run, int vertex) {
  for (const PointSupport& support : run.supports) {
    const std::vector<int> points = points_of(support, run.given);
    if (!is_spring(support) && std::binary_search(points.begin(), points.end(), vertex)) {
      return "it stands on " + support_name(support);
    }
  }
  std::string bounds;
  for (const BoundStanding& bound : run.report.bounds) {
    if (!bound.binding.empty()) bounds += (bounds.empty() ? "" : ", ") + std::string(bound.name);
  }
  return bounds.empty() ? "--attraction pulls harder, --hard holds it there" : "held by " + bounds;
}

}  // namespace

std::optional<std::string> shortfall_sentence(const EditRun& run) {
  constexpr double kNoticeable = 0.15;  // of the pull, as the page has it
  if (run.report.status != SolveStatus::kConverged) return std::nullopt;
  const Handle* worst = nullptr;
  double most = 0.0;
  for (const Handle& handle : run.targets.handles) {
    const double pull = (handle.target - run.base.mesh.positions.col(handle.vertex)).norm();
    const double left = (handle.target - run.edited.col(handle.vertex)).norm();
    if (left <= kNoticeable * pull || left <= most) continue;
    most = left;
    worst = &handle;
  }
  if (worst == nullptr) return std::nullopt;
  return "handle " + std::to_string(worst->vertex) + " stops " + three_digits(most) +
         " short of its target (units of the mesh): " + held_by(run, worst->vertex);
}

namespace {

bool has_images(const EditRun& run) { return run.symmetry && run.symmetry->operations.size() > 1; }

}  // namespace

std::shared_ptr<const MeshSymmetry> symmetry_of(const EditRun& run) {
  return has_images(run) ? std::make_shared<const MeshSymmetry>(*run.symmetry) : nullptr;
}

EditTargets targets_with_images(const EditRun& run) {
  EditTargets targets = run.targets;
  targets.supports = run.supports;
  return has_images(run) ? all_images(targets, run.base.mesh, *run.symmetry) : targets;
}

namespace {

/// Wrong targets must not cost a projection first; the vertices are the same after it.
void check_targets(const EditRun& run) {
  (void)edit_targets(run.asked, run.given);
  if (!run.symmetry) return;
  Mesh even = run.given;
  even_out(*run.symmetry, even.face_vertices, even.positions);
  (void)all_images(edit_targets(run.asked, even), even, *run.symmetry);
}

/// The flat base becomes what the cuts leave of it, and what was given, that parted likewise.
void make_cuts(EditRun& run) {
  if (run.asked.cuts.empty()) return;
  run.uncut_hash = mesh_hash(run.base.mesh);
  auto made = cut_base(run.base.mesh, run.asked.cuts, run.symmetry, run.asked.options.tolerance);
  if (const auto* why = std::get_if<std::string>(&made)) throw UsageError(*why);
  run.cut = std::get<CutMesh>(std::move(made));
  run.base.mesh = run.cut->mesh;
  const Positions given = std::move(run.given.positions);
  run.given = run.cut->mesh;
  run.given.positions.leftCols(given.cols()) = given;
}

/// What is held for the sake of few panels becomes pins.
HandleEditResult solve_fewest(EditRun& run, const Progress& progress) {
  if (run.symmetry) throw UsageError("--fewest: it knows no --symmetry");
  const HandleEditOptions& options = run.asked.options;
  EditTargets targets = targets_with_images(run);
  if (const auto problem = find_problem(*run.asked.fewest, options, targets)) {
    throw UsageError(*problem);
  }
  HandleEditSolver solver(run.base.mesh, options);
  run.fewest = find_fewest(run.base.mesh, solver, targets, *run.asked.fewest, progress);
  const std::vector<int>& held = run.fewest->held;
  run.targets.pins.insert(run.targets.pins.end(), held.begin(), held.end());
  return std::move(run.fewest->result);
}

HandleEditResult solve_edit(EditRun& run, const Progress& progress) {
  if (run.asked.fewest) return solve_fewest(run, progress);
  HandleEditSolver solver(run.base.mesh, run.asked.options);
  const EditTargets targets = targets_with_images(run);
  if (has_images(run)) return solver.solve_symmetric(targets, *run.symmetry, progress);
  return solver.solve(targets, progress);
}

}  // namespace

EditRun run_edit(EditRequest asked, LoadedSource source, const std::string& name,
                 const Progress& progress) {
  EditRun run;
  run.asked = std::move(asked);
  const HandleEditOptions& options = run.asked.options;
  run.given = std::move(source.mesh);
  run.source = std::move(source.source);
  if (run.asked.symmetry) {
    auto found = find_symmetry(run.given, *run.asked.symmetry);
    if (auto* why = std::get_if<std::string>(&found)) throw UsageError(*why);
    run.symmetry = std::get<MeshSymmetry>(std::move(found));
  }
  if (run.asked.cuts.empty()) check_targets(run);
  bool stopped = false;
  Progress watched;
  if (progress) {
    watched = [&](const IterationRecord& record) {
      stopped = stopped || progress(record) == Flow::kStop;
      return stopped ? Flow::kStop : Flow::kContinue;
    };
  }
  run.base = flat_base(run.given, options, watched);
  if (stopped) {
    run.base = {run.given, {}, std::nullopt};
    run.edited = run.given.positions;
    run.report.status = SolveStatus::kCancelled;
    return run;
  }
  if (run.symmetry && run.base.is_flat()) {
    run.evened = make_symmetric(run.base.mesh, *run.symmetry, options.tolerance, watched);
  }
  run.edited = run.base.mesh.positions;
  if (!run.base.is_flat()) {
    run.report = run.base.planarised->report;  // an edit needs a flat base: this is the result
    return run;
  }
  if (!run.evened.symmetric) {
    throw MeshError(name + ": symmetry: the mesh cannot be made flat and symmetric");
  }
  make_cuts(run);
  run.targets = edit_targets(run.asked, run.base.mesh, run.cut ? &*run.cut : nullptr);
  run.supports = run.targets.supports;
  if (run.cut) run.supports = supports_after_cuts(run.supports, *run.cut);
  if (const auto broken = find_broken_constraint(run.base.mesh, options)) {
    throw MeshError(name + ": " + *broken + "; planish project --constraint makes it so");
  }
  const HandleEditResult result = solve_edit(run, watched);
  run.edited = apply(run.base.mesh, result);
  run.report = result.report;
  return run;
}

std::optional<std::string> fewest_sentence(const EditRun& run) {
  if (!run.fewest) return std::nullopt;
  const FewestEdit& found = *run.fewest;
  if (!found.reached) {
    return "--fewest: with nothing held a handle stops " + three_digits(run.report.handle_error) +
           " short of its target (units of the mesh), more than --within-handle; nothing was held";
  }
  if (!found.minimal) {
    return "--fewest: stopped after " + std::to_string(found.solves) + " solves; fewer may do";
  }
  return std::nullopt;
}

namespace {

Json fewest_json(const EditRun& run) {
  const FewestEdit& found = *run.fewest;
  return {{"of", run.asked.fewest->of == FewestOf::kPanels ? "panels" : "points"},
          {"within_handle", run.asked.fewest->within_handle},
          {"panels", found.panels},
          {"panels_before", found.panels_before},
          {"points", run.report.moved_vertices},
          {"held", found.held.size()},
          {"reached", found.reached},
          {"minimal", found.minimal},
          {"solves", found.solves}};
}

}  // namespace

Json edit_json(const EditRun& run, const Positions& after) {
  Json json = Json::object();
  add_solve(json, run.report, run.asked.options.engine);
  json["mesh"] = mesh_json(run.given);
  json["planarity_mm_per_m"] = planarity_json(run.given, run.given.positions, after);
  if (run.base.planarised) {
    json["planarised_first"] = {{"max_move", run.base.planarised->max_move},
                                {"rms_move", run.base.planarised->rms_move}};
  }
  json["spoilt_faces"] = damage_json(run.given, run.given.positions, after);
  json["motion"] = motion_json(run.base.mesh, after);
  json["sharpest_fold"] = fold_json(run.base.mesh, after);
  json["remake"] = remake_json(run.base.mesh, after);
  add_supports(json, run.supports, run.base.mesh, after);
  if (run.cut) add_cuts(json, *run.cut);
  if (run.fewest) json["fewest"] = fewest_json(run);
  if (run.symmetry) {
    json["symmetry"] = symmetry_json(*run.symmetry, run.base.mesh, after);
    if (run.evened.max_move > 0.0) {
      json["symmetry"]["base_moved_by"] = run.evened.max_move;
      json["symmetry"]["base_moved_vertices"] = run.evened.moved;
    }
  }
  return json;
}

}  // namespace planish::workflow
