// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "commands.hpp"
#include "design_input.hpp"
#include "edit_options.hpp"
#include "files.hpp"
#include "planish/fabrication/cutting_package.hpp"
#include "planish/io/gltf.hpp"
#include "report.hpp"

namespace planish::cli {
namespace {

/// What is cut, and what it is compared with.
struct ShopInput {
  Mesh mesh;
  std::optional<Mesh> base;
  std::string model_unit;
  double tolerance = 1e-6;  ///< mm/m, up to which a panel is flat
};

Mesh with_positions(Mesh mesh, const Positions& positions) {
  mesh.positions = positions;
  return mesh;
}

ShopInput replay_input(const std::string& path) {
  const OpenedDesign opened = open_design(path);
  auto result = replay(opened.design, opened.base ? &*opened.base : nullptr, progress_line());
  clear_progress_line();
  if (auto* sentence = std::get_if<std::string>(&result)) refuse_file(path, *sentence);
  auto& replayed = std::get<Replay>(result);
  Mesh mesh = with_positions(replayed.base, replayed.shape);
  return {std::move(mesh), std::move(replayed.base), opened.design.unit,
          opened.design.options.tolerance};
}

/// A GLB with a base holds the finished design: nothing is solved.
ShopInput read_glb_input(const std::string& path, const std::string& unit) {
  auto read = read_glb_design(load_bytes(path));
  if (auto* error = std::get_if<ReadError>(&read)) refuse_file(path, error->message);
  auto& glb = std::get<GlbFile>(read);
  ShopInput input{glb.file.mesh, std::nullopt, unit};
  if (glb.base) input.base = with_positions(std::move(glb.file.mesh), *glb.base);
  if (glb.design.empty()) return input;
  const OpenedDesign opened = open_design(path);
  input.model_unit = opened.design.unit;
  input.tolerance = opened.design.options.tolerance;
  return input;
}

ShopInput load_input(const Arguments& arguments) {
  const std::string path = arguments.only_positional("MESH or DESIGN");
  const std::string unit = model_unit(arguments);
  ShopInput input;
  if (path.ends_with(".json")) {
    input = replay_input(path);
  } else if (path.ends_with(".glb")) {
    input = read_glb_input(path, unit);
  } else {
    input = {load_mesh(path).mesh, std::nullopt, unit};
  }
  if (arguments.has("--model-unit")) input.model_unit = unit;
  if (const auto text = arguments.value("--tolerance")) {
    input.tolerance = parse_finite(*text, "--tolerance");
  }
  if (const auto against = arguments.value("--against")) input.base = load_mesh(*against).mesh;
  return input;
}

/// "2500x1250".
void set_sheet(const std::string& text, CuttingOptions& options) {
  const std::size_t by = text.find('x');
  if (by == std::string::npos) {
    throw CommandError(kWrongUsage, "--sheet: \"" + text + "\" is not WxH");
  }
  options.sheet_width = parse_finite(std::string_view(text).substr(0, by), "--sheet");
  options.sheet_height = parse_finite(std::string_view(text).substr(by + 1), "--sheet");
  if (!(options.sheet_width > 0.0 && options.sheet_height > 0.0)) {
    throw CommandError(kWrongUsage, "--sheet needs two lengths greater than 0");
  }
}

/// `all`, `remake`, or panels by index from 0.
void set_scope(const std::string& text, CuttingOptions& options) {
  if (text == "all") return;
  if (text == "remake") {
    options.remake_only = true;
    return;
  }
  for (const std::string_view word : split_at_commas(text)) {
    options.panels.push_back(parse_whole(word, "--scope"));
  }
}

/// The last part of a path, without its extension.
std::string stem_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  return name.substr(0, name.find_last_of('.'));
}

CuttingOptions cutting_options(const Arguments& arguments, const ShopInput& input) {
  CuttingOptions options;
  options.name = stem_of(arguments.only_positional("MESH or DESIGN"));
  options.model_unit = input.model_unit;
  if (const auto text = arguments.value("--unit")) options.unit = *text;
  if (const auto text = arguments.value("--gap")) options.gap = parse_finite(*text, "--gap");
  if (const auto text = arguments.value("--thickness")) {
    options.thickness = parse_finite(*text, "--thickness");
  }
  if (const auto text = arguments.value("--sheet")) set_sheet(*text, options);
  if (const auto text = arguments.value("--scope")) set_scope(*text, options);
  if (const auto problem = find_problem(options, input.mesh, input.base.has_value())) {
    throw CommandError(kWrongUsage, *problem);
  }
  return options;
}

/// What the package does not hold as it was asked for.
void print_shortfalls(const CuttingReport& report, bool flat) {
  if (!flat) {
    print_message("not flat: a panel is out of its plane by " + three_digits(report.flatness) +
                  " mm/m; its outline is not exact");
  }
  if (!report.vanished.empty()) {
    print_message(
        std::to_string(report.vanished.size()) +
        " panels are not drawn: the gap leaves nothing of them, or they cross themselves; "
        "the first is " +
        panel_name(report.vanished[0]));
  }
  if (!report.oversize.empty()) {
    print_message(std::to_string(report.oversize.size()) +
                  " panels are larger than a sheet; the first is " +
                  panel_name(report.oversize[0]));
  }
}

ExitCode run_panels(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (!output) throw CommandError(kWrongUsage, "-o PACKAGE.zip is missing");
  const ShopInput input = load_input(arguments);
  const CuttingOptions options = cutting_options(arguments, input);
  if (input.mesh.face_count() > kMostPackagePanels) {
    throw CommandError(kInvalidMesh,
                       "a package holds at most " + std::to_string(kMostPackagePanels) + " panels");
  }
  const CuttingPackage package =
      write_cutting_package(input.mesh, input.base ? &*input.base : nullptr, options);
  save_bytes(*output, package.zip);
  const bool flat = package.report.excess <= input.tolerance;
  print_shortfalls(package.report, flat);
  if (const auto path = arguments.value("--report")) {
    save_bytes(*path, Json::parse(package.header).dump(2) + "\n");
  }
  const bool complete = flat && package.report.vanished.empty() && package.report.oversize.empty();
  return complete ? kDone : kToleranceNotMet;
}

}  // namespace

Command panels_command() {
  return {
      "panels",
      "MESH|DESIGN -o PACKAGE.zip [options] [--report R.json]",
      "a cutting package: tables, DXF of every panel, sheets, a map",
      {{"-o", "PACKAGE.zip", "where the package goes (or -)"},
       {"--unit", "UNIT", "of everything in the package: mm (default), cm, m, km, in or ft"},
       {"--model-unit", "UNIT", "of the coordinates; default the design's, or m"},
       {"--gap", "G", "joint between panels: every edge goes in by half of it; default 0"},
       {"--thickness", "T", "of the panels: gives their volume"},
       {"--sheet", "WxH", "arranges the panels on sheets of this size (rectangles, not nested)"},
       {"--against", "BASE", "what was built: says which panels must be made again"},
       {"--scope", "WHICH", "draws all (default), remake, or panels V,V,... counted from 0"},
       {"--tolerance", "MM_PER_M", "up to which a panel is flat; default the design's, or 1e-6"},
       kReportRow},
      run_panels};
}

}  // namespace planish::cli
