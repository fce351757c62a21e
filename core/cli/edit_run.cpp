// SPDX-License-Identifier: MIT
#include "edit_run.hpp"

#include <algorithm>
#include <utility>

#include "cut_run.hpp"
#include "edit_options.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/text/number.hpp"
#include "report.hpp"

namespace planish::cli {
namespace {

/// The symmetry of `mesh` that --symmetry asks for; nullopt without or off.
std::optional<MeshSymmetry> asked_symmetry(const Arguments& arguments, const Mesh& mesh,
                                           const HandleEditOptions& options) {
  const auto text = arguments.value("--symmetry");
  if (!text) return std::nullopt;
  const auto stated = parse_symmetry(*text);
  if (!stated) {
    throw CommandError(
        kWrongUsage, "--symmetry: \"" + *text + "\" is none of " + std::string(known_symmetries()));
  }
  if (stated->is_off()) return std::nullopt;
  if (options.engine != Engine::kNewton) {
    throw CommandError(kWrongUsage, "symmetry: the engine alm knows none; it needs newton");
  }
  auto found = find_symmetry(mesh, *stated);
  if (auto* why = std::get_if<std::string>(&found)) throw CommandError(kWrongUsage, *why);
  return std::get<MeshSymmetry>(std::move(found));
}

EditTargets all_images(const EditTargets& targets, const Mesh& base, const MeshSymmetry& symmetry) {
  auto all = with_images(targets, base, symmetry);
  if (auto* why = std::get_if<std::string>(&all)) throw CommandError(kWrongUsage, *why);
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
  for (std::size_t k = 0; k < base.planarised->moved.size(); ++k) {
    base.mesh.positions.col(base.planarised->moved[k]) =
        base.planarised->moved_positions.col(static_cast<Eigen::Index>(k));
  }
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
void check_targets(const Arguments& arguments, const EditRun& run) {
  (void)edit_targets(arguments, run.given);
  if (!run.symmetry) return;
  Mesh even = run.given;
  even_out(*run.symmetry, even.face_vertices, even.positions);
  (void)all_images(edit_targets(arguments, even), even, *run.symmetry);
}

/// The flat base becomes what the cuts leave of it, and what was given, that parted likewise.
void make_cuts(EditRun& run, double tolerance) {
  if (run.cuts.empty()) return;
  run.uncut_hash = mesh_hash(run.base.mesh);
  auto made = cut_base(run.base.mesh, run.cuts, run.symmetry, tolerance);
  if (const auto* why = std::get_if<std::string>(&made)) throw CommandError(kWrongUsage, *why);
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
void add_found_cuts(EditRun& run, const Uncut& uncut, double tolerance) {
  if (run.splits->cuts.empty()) return;
  run.base.mesh = uncut.base;
  run.given = uncut.given;
  run.cuts.insert(run.cuts.end(), run.splits->cuts.begin(), run.splits->cuts.end());
  make_cuts(run, tolerance);
}

void set_targets(EditRun& run, const Arguments& arguments) {
  run.targets = edit_targets(arguments, run.base.mesh, run.cut ? &*run.cut : nullptr);
  run.supports = run.targets.supports;
  if (run.cut) run.supports = supports_after_cuts(run.supports, *run.cut);
}

}  // namespace

namespace {

/// What is held for the sake of few panels becomes pins.
HandleEditResult solve_fewest(EditRun& run, const HandleEditOptions& options,
                              const FewestOptions& fewest, const Progress& progress) {
  if (run.symmetry) throw CommandError(kWrongUsage, "--fewest: it knows no --symmetry");
  EditTargets targets = targets_with_images(run);
  if (const auto problem = find_problem(fewest, options, targets)) {
    throw CommandError(kWrongUsage, *problem);
  }
  HandleEditSolver solver(run.base.mesh, options);
  FewestEdit found = find_fewest(run.base.mesh, solver, targets, fewest, progress);
  run.targets.pins.insert(run.targets.pins.end(), found.held.begin(), found.held.end());
  HandleEditResult result = std::move(found.result);
  run.fewest = fewest;
  run.fewest_found = std::move(found);
  return result;
}

HandleEditResult solve_edit(EditRun& run, const HandleEditOptions& options,
                            const Arguments& arguments, const Progress& progress) {
  const auto fewest = fewest_options(arguments);
  if (const auto splits = split_options(arguments)) {
    EditTargets targets = targets_with_images(run);
    SplitSolve solved = solve_split(run.base.mesh, targets, options, *splits, progress);
    run.splits = std::move(solved.run);
    return std::move(solved.result);
  }
  if (fewest) return solve_fewest(run, options, *fewest, progress);
  HandleEditSolver solver(run.base.mesh, options);
  const EditTargets targets = targets_with_images(run);
  if (has_images(run)) return solver.solve_symmetric(targets, *run.symmetry, progress);
  return solver.solve(targets, progress);
}

}  // namespace

EditRun run_edit(const Arguments& arguments, const HandleEditOptions& options, LoadedSource source,
                 const std::string& name, const Progress& progress) {
  EditRun run;
  run.unit = model_unit(arguments);
  run.given = std::move(source.mesh);
  run.source = std::move(source.source);
  run.cuts = cuts_before_edit(arguments);
  run.symmetry = asked_symmetry(arguments, run.given, options);
  if (run.cuts.empty()) check_targets(arguments, run);
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
  if (run.symmetry && (!run.base.planarised || run.base.planarised->report.usable())) {
    run.evened = make_symmetric(run.base.mesh, *run.symmetry, options.tolerance, watched);
  }
  run.edited = run.base.mesh.positions;
  if (run.base.planarised && !run.base.planarised->report.usable()) {
    run.report = run.base.planarised->report;  // an edit needs a flat base: this is the result
    return run;
  }
  if (!run.evened.symmetric) {
    throw CommandError(kInvalidMesh,
                       name + ": symmetry: the mesh cannot be made flat and symmetric");
  }
  const Uncut uncut = arguments.has(kSplitOption) ? Uncut{run.base.mesh, run.given} : Uncut{};
  make_cuts(run, options.tolerance);
  set_targets(run, arguments);
  if (const auto broken = find_broken_constraint(run.base.mesh, options)) {
    throw CommandError(kInvalidMesh,
                       name + ": " + *broken + "; planish project --constraint makes it so");
  }
  const HandleEditResult result = solve_edit(run, options, arguments, watched);
  if (run.splits) add_found_cuts(run, uncut, options.tolerance);
  run.edited = apply(run.base.mesh, result);
  run.report = result.report;
  return run;
}

EditRun run_edit_solver(const Arguments& arguments, const HandleEditOptions& options) {
  const std::string name = arguments.only_positional("MESH");
  EditRun run = run_edit(arguments, options, load_source(name), name, progress_line());
  clear_progress_line();
  if (const auto sentence = planarised_sentence(run.base)) print_message(name + ": " + *sentence);
  if (const auto sentence = moved_support_sentence(run)) print_message(name + ": " + *sentence);
  if (const auto sentence = evened_sentence(run)) print_message(name + ": " + *sentence);
  return run;
}

std::optional<std::string> fewest_sentence(const EditRun& run) {
  if (!run.fewest) return std::nullopt;
  const FewestEdit& found = run.fewest_found;
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
  const FewestEdit& found = run.fewest_found;
  return {{"of", run.fewest->of == FewestOf::kPanels ? "panels" : "points"},
          {"within_handle", run.fewest->within_handle},
          {"panels", found.panels},
          {"panels_before", found.panels_before},
          {"points", run.report.moved_vertices},
          {"held", found.held.size()},
          {"reached", found.reached},
          {"minimal", found.minimal},
          {"solves", found.solves}};
}

}  // namespace

Json edit_json(const EditRun& run, const Positions& after, Engine engine) {
  Json json = Json::object();
  add_solve(json, run.report, engine);
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
  if (run.symmetry) {
    json["symmetry"] = symmetry_json(*run.symmetry, run.base.mesh, after);
    if (run.evened.max_move > 0.0) {
      json["symmetry"]["base_moved_by"] = run.evened.max_move;
      json["symmetry"]["base_moved_vertices"] = run.evened.moved;
    }
  }
  return json;
}

}  // namespace planish::cli
