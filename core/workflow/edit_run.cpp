// SPDX-License-Identifier: MIT
#include "edit_run.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "cut_run.hpp"
#include "fair_run.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/design/cut_images.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "report.hpp"

namespace planish::workflow {
FlatBase flat_base(const Mesh& mesh, const HandleEditOptions& options, const Progress& progress) {
  FlatBase base{mesh, {}, std::nullopt};
  if (planarity_summary(mesh).max_excess <= options.tolerance) return base;
  if (options.keep_bends) base.how.flat_within = options.tolerance;
  base.planarised = planarise(mesh, base.how, progress);
  if (base.planarised->report.status == SolveStatus::kToleranceNotMet) {
    const double flat_within = base.how.flat_within;
    base.how = kNearestFlat;  // an edit needs a flat base: what this spoils is reported
    base.how.flat_within = flat_within;
    base.planarised = planarise(mesh, base.how, progress);
  }
  base.mesh.positions(Eigen::all, base.planarised->moved) = base.planarised->moved_positions;
  return base;
}

namespace {

DesignSteps steps_of(const EditRun& run, const Mesh& base, const EditTargets& targets) {
  const bool has_images = run.symmetry && run.symmetry->operations.size() > 1;
  DesignSteps steps(base, run.asked.options, targets,
                    has_images ? std::make_shared<const MeshSymmetry>(*run.symmetry) : nullptr);
  if (steps.image_problem()) throw UsageError(*steps.image_problem());
  return steps;
}

}  // namespace

DesignSteps steps_of(const EditRun& run) {
  EditTargets targets = run.targets;
  targets.supports = run.supports;
  return steps_of(run, run.base.mesh, targets);
}

namespace {

/// Wrong targets must not cost a projection first; the vertices are the same after it.
void check_targets(const EditRun& run) {
  (void)edit_targets(run.asked, run.given);
  if (!run.symmetry) return;
  Mesh even = run.given;
  even_out(*run.symmetry, even.face_vertices, even.positions);
  (void)steps_of(run, even, edit_targets(run.asked, even));
}

/// The flat base becomes what the cuts leave of it, and what was given, that parted likewise.
void make_cuts(EditRun& run) {
  if (run.asked.cuts.empty()) return;
  run.uncut_hash = mesh_hash(run.base.mesh);
  if (run.symmetry) {
    run.asked.cuts =
        cuts_with_images(run.base.mesh, run.asked.cuts, *run.symmetry, run.asked.options.tolerance);
  }
  auto made = cut_base(run.base.mesh, run.asked.cuts, run.symmetry, run.asked.options.tolerance);
  if (const auto* why = std::get_if<std::string>(&made)) throw UsageError(*why);
  run.cut = std::get<CutMesh>(std::move(made));
  run.base.mesh = run.cut->mesh;
  const Positions given = std::move(run.given.positions);
  run.given = run.cut->mesh;
  run.given.positions.leftCols(given.cols()) = given;
}

/// The base and what was given, before any cut.
struct Uncut {
  Mesh base, given;
};

/// Lines that the search found go behind the cuts that were asked for. They add no point, so that
/// targets and supports stay.
void add_found_cuts(EditRun& run, const Uncut& uncut) {
  if (run.splits->cuts.empty()) return;
  run.base.mesh = uncut.base;
  run.given = uncut.given;
  std::vector<Cut>& cuts = run.asked.cuts;
  cuts.insert(cuts.end(), run.splits->cuts.begin(), run.splits->cuts.end());
  make_cuts(run);
}

/// A point that a trim leaves without panels stays in the mesh, so that numbers do: nothing follows
/// it.
void check_handles_left(const EditTargets& targets, const CutMesh& cut) {
  const std::vector<int>& corners = cut.mesh.face_vertices;
  for (const Handle& handle : targets.handles) {
    if (std::find(corners.begin(), corners.end(), handle.vertex) != corners.end()) continue;
    throw UsageError("--handle: vertex " + std::to_string(handle.vertex) +
                     " belongs to no panel after --cut: nothing would follow it");
  }
}

/// What is held for the sake of few panels becomes pins; panels stay such that they can be built,
/// where the handles arrive so.
HandleEditResult solve_fewest(EditRun& run, const Progress& progress) {
  const DesignSteps steps = steps_of(run);
  HandleEditOptions& options = run.asked.options;
  const FewestOptions& asked = *run.asked.fewest;
  if (const auto problem = find_problem(asked, options, steps.images())) throw UsageError(*problem);
  BuildableFewest found = find_buildable_fewest(run.base.mesh, options, steps.images(), asked,
                                                steps.symmetry(), progress);
  options = std::move(found.options);
  std::vector<int>& pins = run.targets.pins;
  pins.insert(pins.end(), found.edit.held.begin(), found.edit.held.end());
  HandleEditResult result = std::move(found.edit.result);
  run.fewest = std::move(found.edit);
  return result;
}

HandleEditResult solve_edit(EditRun& run, const Progress& progress) {
  if (run.asked.fewest && !run.asked.splits) return solve_fewest(run, progress);
  const DesignSteps steps = steps_of(run);
  if (run.asked.fair) {
    const FairTask task{run.base.mesh, run.given.positions, run.targets.handles};
    FairSolve solved = solve_fairly(task, steps, run.asked.options, progress);
    run.fair = std::move(solved.found);
    return std::move(solved.result);
  }
  if (!run.asked.splits) return steps.edit(progress);
  SplitSolve solved = solve_split(run.base.mesh, steps.images(), run.asked.options,
                                  *run.asked.splits, steps.symmetry(), progress);
  run.splits = std::move(solved.run);
  return std::move(solved.result);
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
  const Uncut uncut = run.asked.splits ? Uncut{run.base.mesh, run.given} : Uncut{};
  make_cuts(run);
  run.targets = edit_targets(run.asked, run.base.mesh, run.cut ? &*run.cut : nullptr);
  run.supports = run.targets.supports;
  if (run.cut) {
    check_handles_left(run.targets, *run.cut);
    run.supports = supports_after_cuts(run.supports, *run.cut);
  }
  if (const auto broken = find_broken_constraint(run.base.mesh, options)) {
    throw MeshError(name + ": " + *broken + "; planish project --constraint makes it so");
  }
  const HandleEditResult result = solve_edit(run, watched);
  if (run.splits) add_found_cuts(run, uncut);
  run.edited = apply(run.base.mesh, result);
  run.report = result.report;
  return run;
}

namespace {

/// Panels that became slivers, ascending.
std::vector<int> new_slivers(const EditRun& run) {
  std::vector<int> slivers;
  for (int f = 0; f < run.base.mesh.face_count(); ++f) {
    if (became_sliver(run.base.mesh.positions, run.edited, run.base.mesh.face(f))) {
      slivers.push_back(f);
    }
  }
  return slivers;
}

Json fewest_json(const EditRun& run) {
  const FewestEdit& found = *run.fewest;
  const int most = run.asked.fewest->most_panels;
  return {{"of", run.asked.fewest->of == FewestOf::kPanels ? "panels" : "points"},
          {"most_panels", most > 0 ? Json(most) : Json()},
          {"within_handle", run.asked.fewest->within_handle},
          {"panels", found.panels},
          {"panels_before", found.panels_before},
          {"points", run.report.moved_vertices},
          {"held", found.held.size()},
          {"slivers", new_slivers(run)},
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
  if (run.splits) json["splits"] = splits_json(*run.splits);
  if (run.fair) json["fair"] = fair_json(*run.fair);
  if (run.asked.types) json["types"] = type_change_json(*run.asked.types, run.base.mesh, after);
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
