// SPDX-License-Identifier: MIT
#include "edit_options.hpp"

#include <string>
#include <utility>

#include "files.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/edit/design_words.hpp"
#include "split_run.hpp"

namespace planish::cli {
namespace {

/// One of a few words, each with its meaning.
template <class Value, std::size_t kCount>
Value parse_word(std::string_view text, std::string_view what, const Words<Value, kCount>& words) {
  std::string known;
  for (const auto& [word, value] : words) {
    if (word == text) return value;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  throw CommandError(kWrongUsage,
                     std::string(what) + ": \"" + std::string(text) + "\" is none of " + known);
}

void set_number(const Arguments& arguments, std::string_view option, double& value) {
  if (const auto text = arguments.value(option)) value = parse_finite(*text, option);
}

}  // namespace

Bounds parse_bounds(const Arguments& arguments) {
  Bounds bounds;
  for (const std::string& text : arguments.values("--bound")) {
    if (text == "shape=on" || text == "shape=off") {
      bounds.keep_shape = text == "shape=on";
    } else if (text.starts_with("flat=")) {
      bounds.flat = parse_finite(std::string_view(text).substr(5), "--bound flat");
      if (!(*bounds.flat > 0.0)) {
        throw CommandError(kWrongUsage, "--bound: flat=MM_PER_M must be greater than 0");
      }
    } else if (auto limit = parse_stated_limit(text)) {
      bounds.limits.push_back(std::move(*limit));
    } else if (const std::string name = text.substr(0, text.find('='));
               const auto form = limit_form(name)) {
      throw CommandError(kWrongUsage, "--bound: \"" + text + "\" is not " + name + "=" + *form);
    } else {
      throw CommandError(kWrongUsage, "--bound: \"" + text + "\" is none of shape=on, shape=off, " +
                                          known_limits());
    }
  }
  return bounds;
}

namespace {

int parse_vertex(std::string_view text, std::string_view what, const Mesh& mesh) {
  const int vertex = parse_whole(text, what);
  if (vertex < 0 || vertex >= mesh.vertex_count()) {
    throw CommandError(kWrongUsage, std::string(what) + ": there is no vertex " +
                                        std::string(text) + "; the mesh has " +
                                        std::to_string(mesh.vertex_count()) + " (from 0)");
  }
  return vertex;
}

/// "V=x,y,z" or "V+=dx,dy,dz".
Handle parse_handle(std::string_view text, const Mesh& base) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    throw CommandError(kWrongUsage,
                       "--handle: \"" + std::string(text) + "\" is not V=x,y,z or V+=dx,dy,dz");
  }
  const bool relative = text[equals - 1] == '+';
  Handle handle;
  handle.vertex = parse_vertex(text.substr(0, equals - (relative ? 1 : 0)), "--handle", base);
  const auto numbers = split_at_commas(text.substr(equals + 1));
  if (numbers.size() != 3) {
    throw CommandError(kWrongUsage, "--handle: \"" + std::string(text) + "\" needs 3 coordinates");
  }
  for (int c = 0; c < 3; ++c) {
    handle.target[c] = parse_finite(numbers[static_cast<std::size_t>(c)], "--handle");
  }
  if (relative) handle.target += base.positions.col(handle.vertex);
  return handle;
}

}  // namespace

OptionRow support_row() {
  return {"--support", "KIND:POINTS",
          "points that slide on what they are on: level (keeps z), level=x|y|z,\n"
          "plane=a,b,c,d (a·x + b·y + c·z = d), line=x,y,z,dx,dy,dz, outline\n"
          "(the boundary as it is drawn), polyline (the line of MESH through V,V,...\n"
          "in this order), surface (MESH itself) or surface=FILE; spring=STIFFNESS\n"
          "leaves them free: above 1 they move less willingly, below 1 more;\n"
          "POINTS is V,V,... or boundary or all (repeatable)"};
}

std::vector<OptionRow> edit_option_rows() {
  return {{"--handle", "V=x,y,z", "move vertex V (from 0) there; V+=dx,dy,dz moves it by that"},
          {"--pin", "V,V,...", "vertices that stay where they are"},
          support_row(),
          {"--continuation", "N",
           "handles go to their targets in N equal steps, each solved from the\n"
           "last, as in a drag: another minimum where there is more than one"},
          {"--hard", "", "handles reach their targets exactly"},
          {"--bound", "NAME=VALUE",
           "shape=on|off, default on: no panel becomes concave, crossing,\n"
           "turned over or collapsed that was not; limits of panels, each at most\n"
           "as broken as in MESH: fold=MAX degrees or fold=+MAX beyond what it was,\n"
           "angle=MIN:MAX, edge=MIN:MAX, area=MAX, sheet=WxH (repeatable)"},
          {"--keep-out", "KIND=VALUE",
           "where no point may go: below=Z, above=Z or plane=a,b,c,d (where\n"
           "a·x + b·y + c·z > d); where no panel may: box=x0,y0,z0,x1,y1,z1; "
           "mesh=FILE: through none of\nits panels; self: through no other panel;\n"
           "what is there in MESH goes no deeper (repeatable)"},
          {"--clearance", "D", "kept from every --keep-out (units of the mesh)"},
          kConstraintRow,
          {"--locality", "W", "weight ω_s, default 1: higher moves fewer vertices"},
          {"--smoothness", "W", "weight ω_f, default 1: higher bends more softly"},
          {"--softness", "S", "1 … 10, in place of these two weights: higher is wider and gentler"},
          {"--reach", "R", "nothing moves beyond R face rings, or a length such as 1.5m"},
          {"--keep-boundary", "", "boundary points stay, handles excepted"},
          {"--model-unit", "UNIT", "of the coordinates: mm, cm, m, km, in or ft; default m"},
          {"--attraction", "W", "weight ω_h, default 1000: higher meets the handles closer"},
          {"--fairness", "KIND", "laplacian, second or third; default second"},
          {"--sparsity", "KIND", "l21, l2 or none; default l21"},
          {"--solver", "NAME", "newton or alm; default newton"},
          {"--tolerance", "MM_PER_M", "flatness of the result, default 1e-6"}};
}

std::vector<OptionRow> edit_command_rows() {
  std::vector<OptionRow> rows = edit_option_rows();
  rows.push_back({"--cut", "KIND=VALUE",
                  "before the edit, in the order given: split=F:A,B, strip=V-W[@T],\n"
                  "corner=F:V[@T], refine=F,F,...[:collar], trim=a,b,c,d, as planish cut\n"
                  "has them; handles may name the points that these add (repeatable)"});
  rows.push_back({"--fewest", "panels|points",
                  "few to make again: holds points as long as the handles arrive, until\n"
                  "none can be held any more; they are pins of the design"});
  rows.push_back({"--within-handle", "P%",
                  "of the longest way of a handle, within which handles have arrived for\n"
                  "--fewest and --split-where-needed; default 5%"});
  rows.push_back(split_option_row());
  rows.push_back({"--symmetry", "auto|off|x|y|z|axis:N",
                  "default off; an edit of one point edits its images. x, y, z: the mirror\n"
                  "plane at right angles to it through the middle; axis:N, axis:x:N: N-fold\n"
                  "turns about z, or x; several joined by commas; auto: all that MESH has"});
  return rows;
}

namespace {

constexpr Words<FewestOf, 2> kFewestWords = {
    {{"panels", FewestOf::kPanels}, {"points", FewestOf::kPoints}}};

/// ω_h of an edit whose handles are to arrive, where none is asked for.
constexpr double kArrivingAttraction = 1e5;

constexpr Words<double, 6> kUnits = {
    {{"mm", 0.001}, {"cm", 0.01}, {"m", 1.0}, {"km", 1000.0}, {"in", 0.0254}, {"ft", 0.3048}}};

/// "4" (face rings) or "1.5m" (a length).
void set_reach(std::string_view text, std::string_view model_unit, HandleEditOptions& options) {
  const std::size_t unit = text.find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1;
  if (unit == text.size()) {
    options.reach = parse_whole(text, "--reach");
    if (options.reach < 1) throw CommandError(kWrongUsage, "--reach must be at least 1 face ring");
    return;
  }
  const double metres = parse_word(text.substr(unit), "--reach", kUnits) *
                        parse_finite(text.substr(0, unit), "--reach");
  options.reach_length = metres / parse_word(model_unit, "--model-unit", kUnits);
  if (!(options.reach_length > 0.0)) {
    throw CommandError(kWrongUsage, "--reach must be longer than 0");
  }
}

void set_softness(const Arguments& arguments, HandleEditOptions& options) {
  const auto text = arguments.value("--softness");
  if (!text) return;
  if (arguments.has("--locality") || arguments.has("--smoothness")) {
    throw CommandError(kWrongUsage,
                       "--softness takes the place of --locality and --smoothness: give one or the "
                       "other");
  }
  options.softness = parse_finite(*text, "--softness");
  if (options.softness == 0.0) throw CommandError(kWrongUsage, "--softness must be from 1 to 10");
}

}  // namespace

std::vector<KeptConstraint> parse_constraints(const Arguments& arguments, double& planar) {
  std::vector<KeptConstraint> constraints;
  for (const std::string& text : arguments.values("--constraint")) {
    const std::size_t colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    const bool own = colon == std::string::npos;
    const double tolerance = own ? own_tolerance(kind).value_or(1.0)
                                 : parse_finite(text.substr(colon + 1), "--constraint");
    if (kind != PlanarPolygon::kName) {
      constraints.push_back({kind, tolerance});
    } else if (!own) {
      planar = tolerance;
    }
  }
  return constraints;
}

std::string model_unit(const Arguments& arguments) {
  const std::string unit = arguments.value("--model-unit").value_or("m");
  static_cast<void>(parse_word(unit, "--model-unit", kUnits));
  return unit;
}

FairnessKind parse_fairness(std::string_view text) {
  return parse_word(text, "--fairness", kFairnessWords);
}

Engine parse_engine(std::string_view text) { return parse_word(text, "--solver", kEngineWords); }

namespace {

ContextMesh to_context(const Mesh& mesh) {
  ContextMesh context;
  for (const auto point : mesh.positions.colwise()) {
    context.points.push_back({point.x(), point.y(), point.z()});
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    context.panels.emplace_back(face.begin(), face.end());
  }
  return context;
}

/// As designs say it; a model may also be a file.
KeepOut to_keep_out(const std::string& text) {
  constexpr std::string_view kMesh = "mesh=";
  if (auto keep_out = parse_keep_out(text)) return std::move(*keep_out);
  if (text.starts_with(kMesh)) {
    const LoadedSource model = open_source(text.substr(kMesh.size()));
    return {.kind = KeepOut::Kind::kMesh, .mesh = to_context(model.mesh)};
  }
  throw CommandError(kWrongUsage,
                     "--keep-out: \"" + text + "\" is none of " + std::string(known_keep_outs()));
}

void set_keep_outs(const Arguments& arguments, HandleEditOptions& options) {
  for (const std::string& text : arguments.values("--keep-out")) {
    options.keep_outs.push_back(to_keep_out(text));
  }
  set_number(arguments, "--clearance", options.clearance);
  if (arguments.has("--clearance") && options.keep_outs.empty()) {
    throw CommandError(kWrongUsage, "--clearance is from a --keep-out: there is none");
  }
}

}  // namespace

std::optional<FewestOptions> fewest_options(const Arguments& arguments) {
  const auto of = arguments.value("--fewest");
  if (!of) {
    if (arguments.has("--within-handle") && !arguments.has(kSplitOption)) {
      throw CommandError(
          kWrongUsage, "--within-handle is for --fewest or --split-where-needed: there is neither");
    }
    return std::nullopt;
  }
  FewestOptions options;
  options.of = parse_word(*of, "--fewest", kFewestWords);
  set_within_handle(arguments, options.within_handle);
  return options;
}

void set_within_handle(const Arguments& arguments, double& share) {
  const auto text = arguments.value("--within-handle");
  if (!text) return;
  if (!text->ends_with('%')) {
    throw CommandError(kWrongUsage, "--within-handle: \"" + *text + "\" is not P%");
  }
  share =
      0.01 * parse_finite(std::string_view(*text).substr(0, text->size() - 1), "--within-handle");
}

HandleEditOptions edit_options(const Arguments& arguments) {
  HandleEditOptions options;
  // Handles that stop short for the sake of a soft edit would not have arrived.
  if (arguments.has("--fewest") || arguments.has(kSplitOption)) {
    options.attraction = kArrivingAttraction;
  }
  set_number(arguments, "--locality", options.locality);
  set_number(arguments, "--smoothness", options.smoothness);
  set_number(arguments, "--attraction", options.attraction);
  set_number(arguments, "--tolerance", options.tolerance);
  options.hard_handles = arguments.has("--hard");
  Bounds bounds = parse_bounds(arguments);
  if (bounds.flat) {
    throw CommandError(kWrongUsage,
                       "--bound: flat=MM_PER_M is for project; an edit leaves out of flat what "
                       "--tolerance allows");
  }
  options.keep_shape = bounds.keep_shape;
  options.bounds = std::move(bounds.limits);
  set_keep_outs(arguments, options);
  options.constraints = parse_constraints(arguments, options.tolerance);
  if (const auto text = arguments.value("--fairness")) options.fairness = parse_fairness(*text);
  if (const auto text = arguments.value("--solver")) options.engine = parse_engine(*text);
  set_softness(arguments, options);
  if (const auto text = arguments.value("--reach")) {
    set_reach(*text, model_unit(arguments), options);
  }
  options.keep_boundary = arguments.has("--keep-boundary");
  if (const auto text = arguments.value("--sparsity")) {
    options.sparsity = parse_word(*text, "--sparsity", kSparsityWords);
  }
  if (const auto problem = find_problem(options)) throw CommandError(kWrongUsage, *problem);
  if (arguments.has("--support") && options.engine != Engine::kNewton) {
    throw CommandError(kWrongUsage, "--support: the solver alm knows none; supports need newton");
  }
  if (!options.keep_outs.empty() && options.engine != Engine::kNewton) {
    throw CommandError(kWrongUsage, "--keep-out: the solver alm knows none; it needs newton");
  }
  if (arguments.has("--continuation") && options.engine != Engine::kNewton) {
    throw CommandError(kWrongUsage, "--continuation: the solver alm knows none; it needs newton");
  }
  return options;
}

std::vector<int> parse_vertices(const Arguments& arguments, std::string_view option,
                                const Mesh& mesh) {
  std::vector<int> vertices;
  for (const std::string& list : arguments.values(option)) {
    for (const std::string_view word : split_at_commas(list)) {
      vertices.push_back(parse_vertex(word, option, mesh));
    }
  }
  return vertices;
}

std::vector<int> parse_pins(const Arguments& arguments, const Mesh& mesh) {
  return parse_vertices(arguments, "--pin", mesh);
}

namespace {

/// As designs say it; a surface may also be a file.
std::optional<PointSupport> to_support(const std::string& text) {
  constexpr std::string_view kSurface = "surface=";
  if (auto support = parse_point_support(text)) return support;
  const std::size_t colon = text.rfind(':');
  if (!text.starts_with(kSurface) || colon == std::string::npos) return std::nullopt;
  auto support = parse_point_support("surface" + text.substr(colon));
  if (!support) return std::nullopt;
  const std::string path = text.substr(kSurface.size(), colon - kSurface.size());
  support->surface = to_context(open_source(path).mesh);
  return support;
}

}  // namespace

std::vector<PointSupport> parse_supports(const Arguments& arguments) {
  std::vector<PointSupport> supports;
  for (const std::string& text : arguments.values("--support")) {
    auto support = to_support(text);
    if (!support) {
      throw CommandError(kWrongUsage,
                         "--support: \"" + text + "\" is none of " + std::string(known_supports()));
    }
    supports.push_back(std::move(*support));
  }
  return supports;
}

EditTargets edit_targets(const Arguments& arguments, const Mesh& base, const CutMesh* cut) {
  EditTargets targets;
  for (const std::string& text : arguments.values("--handle")) {
    targets.handles.push_back(parse_handle(text, base));
  }
  targets.pins = parse_pins(arguments, base);
  targets.supports = parse_supports(arguments);
  if (const auto text = arguments.value("--continuation")) {
    targets.continuation = parse_whole(*text, "--continuation");
  }
  if (targets.handles.empty()) throw CommandError(kWrongUsage, "--handle is missing");
  EditTargets carried = targets;
  if (cut != nullptr) carried.supports = supports_after_cuts(targets.supports, *cut);
  if (const auto problem = find_problem(carried, base)) {
    throw CommandError(kWrongUsage, *problem);
  }
  return targets;
}

}  // namespace planish::cli
