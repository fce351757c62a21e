// SPDX-License-Identifier: MIT
/// The list of what JavaScript sees, and nothing else. Operations return "" when done, otherwise
/// one sentence that says why nothing changed; no exception leaves the module, because it would
/// arrive there without its text.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "design_values.hpp"
#include "planish/mesh/mesh_hash.hpp"
#include "report_values.hpp"
#include "session.hpp"

namespace {

using emscripten::val;
using planish::attempt;
using planish::copy;
using planish::EditMode;
using planish::Flow;
using planish::IterationRecord;
using planish::Positions;
using planish::Refusal;
using planish::Session;
using planish::to_indices;
using planish::to_positions;
using planish::to_targets;
using planish::to_vector;

std::string open_sample(Session& s, const std::string& name, int size) {
  return attempt([&] { return s.open_sample(name, size); });
}
std::string open_file(Session& s, const val& bytes, const std::string& format) {
  return attempt([&] { return s.open_file(planish::to_bytes(bytes), format); });
}
std::string planarise(Session& s, const val& how) {
  return attempt([&] { return s.planarise(planish::to_planarising(how)); });
}
std::string take_planarised(Session& s, const val& found) {
  return attempt([&] { return s.take_planarised(to_positions(found)); });
}
std::string set_options(Session& s, const val& settings) {
  return attempt([&] { return s.set_options(planish::to_options(settings)); });
}
std::string set_supports(Session& s, const val& texts) {
  return attempt([&] { return s.set_supports(emscripten::vecFromJSArray<std::string>(texts)); });
}
std::string set_cuts(Session& s, const std::string& lines, double tolerance) {
  return attempt([&] { return s.set_cuts(lines, tolerance); });
}
val try_cut(const Session& s, const std::string& text, double tolerance) {
  planish::CutTrial trial;
  trial.problem = attempt([&]() -> Refusal {
    trial = s.try_cut(text, tolerance);
    return trial.problem.empty() ? Refusal() : Refusal(trial.problem);
  });
  val value = val::object();
  value.set("problem", trial.problem);
  value.set("cuts", trial.cuts);
  value.set("lines", copy(trial.lines));
  return value;
}
std::string edit(Session& s, EditMode mode, const val& handles, const val& pins, int continuation,
                 double budget) {
  return attempt([&] { return s.edit(mode, to_targets(handles, pins, continuation), budget); });
}
std::string restore(Session& s, const val& handles, const val& pins, const val& moved,
                    const val& positions, bool keep_variations) {
  return attempt([&] {
    return s.restore(to_targets(handles, pins), to_indices(moved), to_positions(positions),
                     keep_variations);
  });
}
std::string replay(Session& s, const val& recipe, const val& base_hash) {
  return attempt([&] { return s.replay(planish::to_recipe(recipe), planish::to_hash(base_hash)); });
}
val replayed(const Session& s) {
  const planish::Replayed& done = s.replayed();
  val value = val::object();
  value.set("directions", copy(done.directions));
  value.set("moved", copy(done.centre.moved));
  value.set("positions", copy(done.centre.positions));
  value.set("deviation", done.deviation);
  return value;
}
val mark_of(const val& moved, const val& positions) {
  return to_value(planish::mark_of({to_indices(moved), to_positions(positions)}));
}
std::uint32_t base_hash(const Session& s) { return planish::mesh_hash(s.uncut()); }
std::string explore(Session& s, const val& family) {
  return attempt([&] { return s.explore(planish::to_subspace_options(family)); });
}
std::string vary(Session& s, const val& coefficients) {
  return attempt([&] { return s.vary(to_vector(coefficients)); });
}
std::string project_variation(Session& s, const val& coefficients) {
  return attempt([&] { return s.project_variation(to_vector(coefficients)); });
}
std::string make_exact(Session& s) {
  return attempt([&] { return s.make_exact(); });
}
void on_progress(Session& s, const val& callback) {
  s.set_progress([callback](const IterationRecord& record) {
    return callback(record.primal_residual).as<bool>() ? Flow::kContinue : Flow::kStop;
  });
}
val write(const Session& s, const std::string& format) {
  return copy(s.write(format).value_or(""));
}

std::string set_groups(Session& s, const std::string& lines) {
  return attempt([&] { return s.set_groups(lines); });
}

val variation_support(const Session& s) { return copy(s.variations().support); }
/// 3 × |support| numbers for each variation.
val variation_displacements(const Session& s) {
  std::vector<double> all;
  for (const Positions& move : s.variations().displacements) {
    all.insert(all.end(), move.data(), move.data() + move.size());
  }
  return copy(all);
}
/// A copy of what the session has.
template <auto kGet>
val copied(const Session& s) {
  return copy((s.*kGet)());
}
val base_positions(const Session& s) { return copy(s.base().positions); }
val face_offsets(const Session& s) { return copy(s.base().face_offsets); }
val face_vertices(const Session& s) { return copy(s.base().face_vertices); }
val take_changes(Session& s) { return copy(s.take_changes()); }
val projected_moved(const Session& s) { return copy(s.projected().moved); }
val projected_positions(const Session& s) { return copy(s.projected().positions); }
/// A report that the session has, as an object.
template <auto kGet>
val report(const Session& s) {
  return to_value((s.*kGet)());
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish) {
  emscripten::enum_<EditMode>("EditMode")
      .value("drag", EditMode::kDrag)
      .value("release", EditMode::kRelease)
      .value("solve", EditMode::kSolve);
  emscripten::class_<Session>("Session")
      .constructor<>()
      .function("openSample", &open_sample)
      .function("openFile", &open_file)
      .function("planarise", &planarise)
      .function("takePlanarised", &take_planarised)
      .function("setOptions", &set_options)
      .function("setSupports", &set_supports)
      .function("setCuts", &set_cuts)
      .function("tryCut", &try_cut)
      .function("edit", &edit)
      .function("keepEdit", &Session::keep_edit)
      .function("goBack", &Session::go_back)
      .function("showKept", &Session::show_kept)
      .function("restore", &restore)
      .function("replay", &replay)
      .function("replayed", &replayed)
      .function("baseHash", &base_hash)
      .function("explore", &explore)
      .function("vary", &vary)
      .function("projectVariation", &project_variation)
      .function("makeExact", &make_exact)
      .function("onProgress", &on_progress)
      .function("write", &write)
      .function("groups", &Session::groups)
      .function("setGroups", &set_groups)
      .function("variationSupport", &variation_support)
      .function("variationDisplacements", &variation_displacements)
      .function("basePositions", &base_positions)
      .function("beforePlanarising", &copied<&Session::before_planarising>)
      .function("faceOffsets", &face_offsets)
      .function("faceVertices", &face_vertices)
      .function("panelParents", &copied<&Session::panel_parents>)
      .function("displayBase", &copied<&Session::display_base>)
      .function("takeChanges", &take_changes)
      .function("moved", &copied<&Session::moved>)
      .function("movedPositions", &copied<&Session::moved_positions>)
      .function("projectedMoved", &projected_moved)
      .function("projectedPositions", &projected_positions)
      .function("projectedReport", &report<&Session::projected_report>)
      .function("meshReport", &report<&Session::mesh_report>)
      .function("shapeReport", &report<&Session::shape_report>)
      .function("variationsReport", &report<&Session::variations_report>);
  emscripten::function("markOf", &mark_of);
}
