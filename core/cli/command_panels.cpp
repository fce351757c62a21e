// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "lengths.hpp"
#include "link_code.hpp"
#include "planish/fabrication/cutting_package.hpp"
#include "planish/fabrication/ifc.hpp"
#include "planish/text/number.hpp"
#include "report.hpp"
#include "shop_input.hpp"
#include "terminal.hpp"
#include "types_run.hpp"

namespace planish::cli {
namespace {

/// "2500x1250".
void set_sheet(const std::string& text, CuttingOptions& options) {
  const std::size_t by = text.find('x');
  if (by == std::string::npos) throw UsageError("--sheet: \"" + text + "\" is not WxH");
  options.sheet_width = parse_length(text.substr(0, by), "--sheet", options.unit);
  options.sheet_height = parse_length(text.substr(by + 1), "--sheet", options.unit);
  if (!(options.sheet_width > 0.0 && options.sheet_height > 0.0)) {
    throw UsageError("--sheet needs two lengths greater than 0");
  }
}

/// `all`, `remake`, or panels by index from 0.
void set_scope(const std::string& text, CuttingOptions& options) {
  if (text == "all") return;
  if (text == "remake") {
    options.remake_only = true;
    return;
  }
  for (const Json& word : entries_of(text)) {
    options.panels.push_back(parse_whole(word, "--scope"));
  }
}

/// `panel` or `type`.
void set_by(const Arguments& arguments, const std::string& text, CuttingOptions& options) {
  if (text != "panel" && text != "type") {
    throw UsageError("--by: \"" + text + "\" is not panel or type");
  }
  options.by_type = text == "type";
  if (options.by_type && !arguments.has("--joint") && !arguments.has("--within")) {
    throw UsageError(
        "--by type needs --joint MIN:MAX or --within D: by how much joints, or "
        "panels of a type, may vary");
  }
}

/// Types where they are asked for; templates are cut with the joint that they are found for.
void add_types(const Arguments& arguments, const ShopInput& input, CuttingOptions& options) {
  const bool wanted = options.by_type || arguments.has("--joint") || arguments.has("--within") ||
                      arguments.has("--mirrored");
  if (!wanted || !metres_in(options.model_unit) || !metres_in(options.unit)) return;
  options.types = type_options(arguments, input.mesh, options.model_unit, options.unit);
  if (options.by_type && options.types->joint && !arguments.has("--gap")) {
    options.gap = 0.5 * (options.types->joint->min + options.types->joint->max);
  }
}

CuttingOptions cutting_options(const Arguments& arguments, const ShopInput& input) {
  CuttingOptions options;
  options.name = input.name;
  options.model_unit = input.model_unit;
  options.names = input.names;
  if (const auto text = arguments.value("--unit")) options.unit = *text;
  read_length(arguments, "--gap", options.unit, options.gap);
  read_length(arguments, "--thickness", options.unit, options.thickness);
  read_length(arguments, "--text-height", options.unit, options.text_height);
  if (const auto text = arguments.value("--sheet")) set_sheet(*text, options);
  if (const auto text = arguments.value("--scope")) set_scope(*text, options);
  if (const auto text = arguments.value("--by")) set_by(arguments, *text, options);
  add_types(arguments, input, options);
  if (const auto problem = find_problem(options, input.mesh, input.base.has_value())) {
    throw UsageError(*problem);
  }
  return options;
}

/// `one` of the only panel, or `more` of all of them and which is the first.
void print_panels(const PanelNames& names, const std::vector<int>& faces, const std::string& one,
                  const std::string& more) {
  if (faces.empty()) return;
  const std::string first = names.of(faces[0]);
  print_message(faces.size() == 1
                    ? first + " " + one
                    : std::to_string(faces.size()) + " panels " + more + "; the first is " + first);
}

/// Whether all of every panel is there but its joints; says so if not.
bool check_whole(const PanelNames& names, const DrawnReport& report) {
  print_panels(names, report.vanished,
               "is not drawn: the gap leaves nothing of it, or it crosses itself",
               "are not drawn: the gap leaves nothing of them, or they cross themselves");
  std::vector<int> apart;
  std::string pieces;
  for (const PanelApart& panel : report.apart) {
    if (apart.empty()) pieces = " into " + std::to_string(panel.pieces) + " pieces";
    apart.push_back(panel.face);
  }
  print_panels(names, apart, "is cut" + pieces + " by the gap",
               "are cut into pieces by the gap, the first" + pieces);
  print_panels(names, report.lost_sides, "loses whole sides to the gap",
               "lose whole sides to the gap");
  return report.vanished.empty() && apart.empty();
}

/// Whether every panel is flat; says so if not.
bool check_flat(const ShopInput& input, const DrawnReport& report) {
  const bool flat = report.excess <= input.tolerance;
  if (!flat) {
    print_message("not flat: a panel is out of its plane by " + three_digits(report.flatness) +
                  " mm/m; its outline is not exact: use planish project first");
  }
  return flat;
}

void save_report(const Arguments& arguments, const std::string& header) {
  const auto path = arguments.value("--report");
  if (path) save_bytes(*path, Json::parse(header).dump(2) + "\n");
}

ExitCode write_package(const Arguments& arguments, const ShopInput& input,
                       const CuttingOptions& options, const std::string& output) {
  const LinkCode code = make_link_code(arguments.value("--link").value_or(""));
  const bool has_link = code.size > 0 || code.link.empty();
  std::string zip;  // whole, as a file is written whole or not at all
  const CuttingPackage package = write_cutting_package(
      input.mesh, input.base_or_null(), options, [&](std::string_view piece) { zip += piece; },
      code);
  save_bytes(output, zip);
  const CuttingReport& report = package.report;
  const bool flat = check_flat(input, report);
  const bool whole = check_whole(input.names, report);
  print_panels(input.names, report.oversize, "is larger than a sheet", "are larger than a sheet");
  if (!has_link) print_message("the link is too long for a QR code: the labels carry none");
  save_report(arguments, package.header);
  const bool complete = flat && whole && has_link && report.oversize.empty();
  return complete ? kDone : kToleranceNotMet;
}

ExitCode write_model(const Arguments& arguments, const ShopInput& input,
                     const CuttingOptions& options, const std::string& output) {
  for (const char* name : {"--sheet", "--text-height", "--link", "--by"}) {
    if (arguments.has(name)) throw UsageError(std::string(name) + " is for packages, not for IFC");
  }
  const CuttingPlan plan = make_cutting_plan(input.mesh, input.base_or_null(), options);
  const IfcModel model = write_ifc(plan);
  save_bytes(output, model.text);
  save_report(arguments, model.header);
  const bool flat = check_flat(input, model.report);
  const bool whole = check_whole(input.names, model.report);
  return flat && whole ? kDone : kToleranceNotMet;
}

ExitCode run_panels(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (!output) throw UsageError("-o PACKAGE.zip or -o MODEL.ifc is missing");
  const bool is_model = extension_of(*output) == "ifc";
  if (!is_model) check_zip_name(*output, "a cutting package");
  const ShopInput input = load_shop_input(arguments);
  const CuttingOptions options = cutting_options(arguments, input);
  if (is_model) return write_model(arguments, input, options, *output);
  if (input.mesh.face_count() > kMostPackagePanels) {
    throw MeshError("a package holds at most " + std::to_string(kMostPackagePanels) + " panels");
  }
  return write_package(arguments, input, options, *output);
}

}  // namespace

Command panels_command() {
  return {
      "panels",
      "MESH|DESIGN -o PACKAGE.zip|MODEL.ifc [options] [--report R.json]",
      "a cutting package (tables, DXF of every panel, sheets, a map, labels), or IFC4",
      {{"-o", "OUT", "where it goes: .ifc a curtain wall of plates, else (or -) the package"},
       {"--unit", "UNIT", "of everything in the package: mm (default), cm, m, km, in or ft"},
       {"--model-unit", "UNIT", "of the coordinates; default the design's, or m"},
       {"--gap", "G", "joint between panels, mm: every edge goes in by half of it; default 0"},
       {"--thickness", "T", "of the panels, mm: gives their volume; in IFC makes them solid"},
       {"--sheet", "WxH", "arranges the panels on sheets of this size (rectangles, not nested)"},
       {"--text-height", "H", "of texts on panels where they fit; default by the panel's size"},
       {"--joint", "MIN:MAX", "adds the types of panels to the tables; as for types, as also"},
       {"--within", "D|P%", "how far a corner may be from the template's, and"},
       {"--mirrored", "", "that a panel may be its template turned over"},
       {"--by", "type", "draws one template a type, and as many on sheets as there are panels"},
       {"--link", "URL", "that opens the design: the labels carry it as a QR code"},
       {"--against", "BASE", "what was built: says which panels must be made again"},
       {"--scope", "WHICH", "draws all (default), remake, or panels V,V,... counted from 0"},
       {"--tolerance", "MM_PER_M", "up to which a panel is flat; default the design's, or 1e-6"},
       kReportRow},
      run_panels};
}

}  // namespace planish::cli
