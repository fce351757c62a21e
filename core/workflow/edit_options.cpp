// SPDX-License-Identifier: MIT
#include "edit_options.hpp"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

#include "cut_run.hpp"
#include "fair_run.hpp"
#include "lengths.hpp"
#include "mesh_files.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/edit/edit_option_table.hpp"
#include "planish/variations/subspace.hpp"
#include "split_run.hpp"
#include "thread_pool.hpp"
#include "type_change.hpp"

namespace planish::workflow {
namespace {

constexpr std::string_view kClearance = "--clearance";

/// {"angle": [60, 120]} as a design says it.
std::string bound_text(const Json& stated) {
  if (!stated.is_object()) return text_of(stated);
  const Json& value = stated.front();
  const std::string name = stated.begin().key();
  if (value.is_boolean()) return name + (value.get<bool>() ? "=on" : "=off");
  const char* separator = "=";
  std::string text = name;
  for (const Json& number : entries_of(value)) {
    text.append(separator).append(text_of(number));
    separator = name == "sheet" ? "x" : ":";
  }
  return text;
}

/// All that --bound takes: what is no limit of panels or points stands around those.
std::string known_bounds() { return "shape=on, shape=off, " + known_limits() + ", flat=MM_PER_M"; }

/// Lengths and areas that have a unit as plain numbers.
std::string in_model_units(const std::string& text, const std::string& unit) {
  if (text.starts_with("area=")) return plain_areas(text, unit);
  for (const std::string_view name : {"edge=", "sheet=", "slide="}) {
    if (text.starts_with(name)) return plain_lengths(text, unit);
  }
  return text;
}

}  // namespace

Bounds parse_bounds(const Request& request) {
  const std::string unit = model_unit(request);
  Bounds bounds;
  for (const Json& stated : request.values("--bound")) {
    const std::string text = in_model_units(bound_text(stated), unit);
    if (text == "shape=on" || text == "shape=off") {
      bounds.keep_shape = text == "shape=on";
    } else if (text.starts_with("flat=")) {
      bounds.flat = parse_finite(std::string_view(text).substr(5), "--bound flat");
      if (!(*bounds.flat > 0.0)) throw UsageError("--bound: flat=MM_PER_M must be greater than 0");
    } else if (auto limit = parse_stated_limit(text)) {
      bounds.limits.push_back(std::move(*limit));
    } else if (const std::string name = text.substr(0, text.find('='));
               const auto form = limit_form(name)) {
      throw UsageError("--bound: \"" + text + "\" is not " + name + "=" + *form);
    } else {
      throw UsageError("--bound: \"" + text + "\" is none of " + known_bounds());
    }
  }
  return bounds;
}

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
           "angle=MIN:MAX, edge=MIN:MAX, area=MAX, sheet=WxH; of points, handles too:\n"
           "slide=MAX across the normal of MESH there; flat=MM_PER_M: panels bent by up to\n"
           "that stay as bent as they are, none bends more (repeatable)"},
          {"--keep-out", "KIND=VALUE",
           "where no point may go: below=Z, above=Z or plane=a,b,c,d (where\n"
           "a·x + b·y + c·z > d); where no panel may: box=x0,y0,z0,x1,y1,z1; "
           "mesh=FILE: through none of\nits panels; self: through no other panel;\n"
           "what is there in MESH goes no deeper (repeatable)"},
          {kClearance, "D", "kept from every --keep-out (units of the mesh)"},
          kConstraintRow,
          {"--locality", "W", "weight ω_s, default 1: higher moves fewer vertices"},
          {"--smoothness", "W", "weight ω_f, default 1: higher bends more softly"},
          {"--softness", "S", "1 … 10, in place of these two weights: higher is wider and gentler"},
          {"--reach", "R", "nothing moves beyond R face rings, or a length such as 1.5m"},
          {"--keep-boundary", "", "boundary points stay, handles excepted"},
          kModelUnitRow,
          {"--attraction", "W", "weight ω_h, default 1000: higher meets the handles closer"},
          {"--fairness", "KIND", "laplacian, second or third; default second"},
          {"--sparsity", "KIND", "l21, l2 or none; default l21"},
          {"--solver", "NAME", "newton or alm; default newton"},
          {"--tolerance", "MM_PER_M", "flatness of the result, default 1e-6"}};
}

std::vector<OptionRow> edit_command_rows() {
  std::vector<OptionRow> rows = edit_option_rows();
  rows.push_back(kThreadsRow);
  rows.push_back({"--cut", "KIND=VALUE",
                  "before the edit, in the order given: split=F:A,B, strip=V-W[@T],\n"
                  "corner=F:V[@T], refine=F,F,...[:collar], trim=a,b,c,d, as planish cut\n"
                  "has them; handles may name the points that these add (repeatable)"});
  rows.push_back({"--fewest", "panels|points|N",
                  "few to make again: holds points as long as the handles arrive, until\n"
                  "none can be held any more, or N panels at most are left to make\n"
                  "again; they are pins of the design"});
  rows.push_back({"--within-handle", "P%",
                  "of the longest way of a handle, within which handles have arrived for\n"
                  "--fewest and --split-where-needed; default 5%"});
  rows.push_back(split_option_row());
  rows.push_back(fair_option_row());
  for (OptionRow& row : type_counting_rows()) rows.push_back(std::move(row));
  rows.push_back({"--symmetry", "auto|off|x|y|z|axis:N",
                  "default off; an edit of one point edits its images. x, y, z: the mirror\n"
                  "plane at right angles to it through the middle; axis:N, axis:x:N: N-fold\n"
                  "turns about z, or x; several joined by commas; auto: all that MESH has"});
  return rows;
}

namespace {

/// ω_h of an edit whose handles are to arrive, where none is asked for.
constexpr double kArrivingAttraction = 1e5;

/// "4" (face rings) or "1.5m" (a length).
void set_reach(std::string_view text, const std::string& unit, HandleEditOptions& options) {
  if (text.empty() || text.back() < 'a' || text.back() > 'z') {
    options.reach = parse_whole(text, "--reach");
    if (options.reach < 1) throw UsageError("--reach must be at least 1 face ring");
    return;
  }
  options.reach_length = parse_length(text, "--reach", unit);
  if (!(options.reach_length > 0.0)) throw UsageError("--reach must be longer than 0");
}

void check_softness(const Request& request, const HandleEditOptions& options) {
  if (!request.has("--softness")) return;
  if (request.has("--locality") || request.has("--smoothness")) {
    throw UsageError(
        "--softness takes the place of --locality and --smoothness: give one or the "
        "other");
  }
  if (options.softness == 0.0) throw UsageError("--softness must be from 1 to 10");
}

/// "circular:1e-6" as its kind and tolerance; null for its own. {"circular": 1e-6} is that already.
std::pair<std::string, Json> parts_of_constraint(const Json& stated) {
  if (stated.is_object()) return {stated.begin().key(), stated.begin().value()};
  const std::string text = text_of(stated);
  const std::size_t colon = text.find(':');
  const bool own = colon == std::string::npos;
  return {text.substr(0, colon), own ? Json() : Json(text.substr(colon + 1))};
}

}  // namespace

std::vector<KeptConstraint> parse_constraints(const Request& request, double& planar) {
  std::vector<KeptConstraint> constraints;
  for (const Json& stated : request.values("--constraint")) {
    const auto [kind, given] = parts_of_constraint(stated);
    const double tolerance =
        given.is_null() ? own_tolerance(kind).value_or(1.0) : parse_finite(given, "--constraint");
    if (kind != PlanarPolygon::kName) {
      constraints.push_back({kind, tolerance});
    } else if (!given.is_null()) {
      planar = tolerance;
    }
  }
  return constraints;
}

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

/// A keep-out as designs say it; a model may also be a file.
KeepOut to_keep_out(const std::string& text, const std::string& unit) {
  constexpr std::string_view kMesh = "mesh=";
  const bool is_mesh = text.starts_with(kMesh);
  if (auto keep_out = parse_keep_out(is_mesh ? text : plain_lengths(text, unit))) {
    return std::move(*keep_out);
  }
  if (is_mesh) {
    const LoadedSource model = open_source(text.substr(kMesh.size()));
    return {.kind = KeepOut::Kind::kMesh, .mesh = to_context(model.mesh)};
  }
  throw UsageError("--keep-out: \"" + text + "\" is none of " + std::string(known_keep_outs()));
}

void set_keep_outs(const Request& request, HandleEditOptions& options) {
  const std::string unit = model_unit(request);
  for (const std::string& text : request.texts("--keep-out")) {
    options.keep_outs.push_back(to_keep_out(text, unit));
  }
  if (request.has(kClearance) && options.keep_outs.empty()) {
    throw UsageError("--clearance is from a --keep-out: there is none");
  }
}

/// What is one number, word or switch has the name that it has in designs; the rest says more.
void read_table(const Request& request, HandleEditOptions& options) {
  for_each_edit_option([&]<class Value>(const EditOption<Value>& option) {
    std::string name = std::string("--").append(option.name);
    std::replace(name.begin(), name.end(), '_', '-');
    Value& value = options.*option.member;
    if constexpr (std::is_same_v<Value, bool>) {
      value = value || request.has(name);
    } else if constexpr (std::is_same_v<Value, double>) {
      if (name == kClearance) return read_length(request, name, model_unit(request), value);
      request.read(name, value);
    } else if constexpr (requires { words_for(value); }) {
      read_word(request, name, value);
    }
  });
}

}  // namespace

void set_within_handle(const Request& request, double& share) {
  if (const auto text = request.value("--within-handle")) {
    share = parse_share(*text, "--within-handle");
  }
}

HandleEditOptions edit_options(const Request& request) {
  HandleEditOptions options;
  // Handles that stop short for the sake of a soft edit would not have arrived.
  if (request.has("--fewest") || request.has(kSplitOption)) {
    options.attraction = kArrivingAttraction;
  }
  read_table(request, options);
  Bounds bounds = parse_bounds(request);
  if (bounds.flat) {
    if (request.has("--tolerance")) throw UsageError("--bound: flat=MM_PER_M takes no --tolerance");
    options.tolerance = *bounds.flat;
    options.keep_bends = true;
  }
  options.keep_shape = bounds.keep_shape;
  options.bounds = std::move(bounds.limits);
  set_keep_outs(request, options);
  options.constraints = parse_constraints(request, options.tolerance);
  check_softness(request, options);
  if (const auto text = request.value("--reach")) {
    set_reach(*text, model_unit(request), options);
  }
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  return options;
}

std::vector<int> parse_vertices(const Request& request, std::string_view option) {
  std::vector<int> vertices;
  for (const Json& list : request.values(option)) {
    for (const Json& stated : entries_of(list)) vertices.push_back(parse_whole(stated, option));
  }
  return vertices;
}

void check_vertices(const std::vector<int>& vertices, std::string_view option, const Mesh& mesh) {
  for (const int vertex : vertices) {
    if (vertex >= 0 && vertex < mesh.vertex_count()) continue;
    throw UsageError(std::string(option) + ": there is no vertex " + std::to_string(vertex) +
                     "; the mesh has " + std::to_string(mesh.vertex_count()) + " (from 0)");
  }
}

namespace {

/// A support as designs say it; a surface may also be a file.
std::optional<PointSupport> to_support(const std::string& text, const std::string& unit) {
  constexpr std::string_view kSurface = "surface=";
  const bool placed = text.starts_with("plane=") || text.starts_with("line=");
  if (auto support = parse_point_support(placed ? plain_lengths(text, unit) : text)) return support;
  const std::size_t colon = text.rfind(':');
  if (!text.starts_with(kSurface) || colon == std::string::npos) return std::nullopt;
  auto support = parse_point_support("surface" + text.substr(colon));
  if (!support) return std::nullopt;
  const std::string path = text.substr(kSurface.size(), colon - kSurface.size());
  support->surface = to_context(open_source(path).mesh);
  return support;
}

}  // namespace

std::vector<PointSupport> parse_supports(const Request& request) {
  const std::string unit = model_unit(request);
  std::vector<PointSupport> supports;
  for (const std::string& text : request.texts("--support")) {
    auto support = to_support(text, unit);
    if (!support) {
      throw UsageError("--support: \"" + text + "\" is none of " + std::string(known_supports()));
    }
    supports.push_back(std::move(*support));
  }
  return supports;
}

}  // namespace planish::workflow
