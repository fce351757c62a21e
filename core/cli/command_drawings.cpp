// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>

#include "commands.hpp"
#include "lengths.hpp"
#include "planish/fabrication/structure_drawings.hpp"
#include "report.hpp"
#include "shop_input.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

[[noreturn]] void refuse_section(const std::string& text) {
  throw UsageError("--section: \"" + text + "\" is not x=V, y=V, z=V or plane=a,b,c,d");
}

/// "x=1.5" is seen from the right, "y=…" from the front, "z=…" from above.
SectionPlane parse_section(const std::string& text, const std::string& unit) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse_section(text);
  const std::string name = text.substr(0, equals);
  const auto words = entries_of(text.substr(equals + 1));
  if (name == "plane" && words.size() == 4) {
    Eigen::Vector3d normal;
    for (int k = 0; k < 3; ++k)
      normal[k] = parse_finite(words[static_cast<std::size_t>(k)], "--section");
    const double length = normal.stableNorm();
    if (!(length > 0.0)) throw UsageError("--section: a plane needs a direction");
    return {normal / length, parse_length(words[3], "--section", unit) / length};
  }
  if (words.size() != 1) refuse_section(text);
  const double value = parse_length(words[0], "--section", unit);
  if (name == "x") return {Eigen::Vector3d::UnitX(), value};
  if (name == "y") return {{0.0, -1.0, 0.0}, -value};
  if (name == "z") return {Eigen::Vector3d::UnitZ(), value};
  refuse_section(text);
}

/// "x=500mm:A" with its place as a number, its name as it is.
std::string plain_place(const std::string& text, const std::string& unit) {
  const std::size_t end = std::min(text.find(':'), text.size());
  return plain_lengths(std::string_view(text).substr(0, end), unit) + text.substr(end);
}

DrawingOptions drawing_options(const Arguments& arguments, const ShopInput& input) {
  DrawingOptions options;
  options.name = input.name;
  options.model_unit = input.model_unit;
  options.names = input.names;
  if (const auto text = arguments.value("--unit")) options.unit = *text;
  if (const auto text = arguments.value("--scale"); text == "each") {
    options.own_scales = true;
  } else if (text) {
    options.scale = parse_finite(*text, "--scale");
    if (!(options.scale > 0.0)) throw UsageError("--scale must be greater than 0");
  }
  for (const std::string& text : arguments.texts("--section")) {
    options.sections.push_back(parse_section(text, options.model_unit));
  }
  for (const std::string& text : arguments.texts("--axis")) {
    const auto axis = parse_drawing_axis(plain_place(text, options.model_unit));
    if (!axis) {
      throw UsageError("--axis: \"" + text + "\" is not " + std::string(kDrawingAxisForm));
    }
    options.axes.push_back(*axis);
  }
  if (const auto problem = find_problem(options, input.mesh)) throw UsageError(*problem);
  return options;
}

ExitCode run_drawings(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (!output) throw UsageError("-o DRAWINGS.zip is missing");
  check_zip_name(*output, "a set of drawings");
  const ShopInput input = load_shop_input(arguments);
  const StructureDrawings drawings = write_drawings(input.mesh, drawing_options(arguments, input));
  save_bytes(*output, drawings.zip);
  for (const int section : drawings.missed) {
    print_message("section " + std::to_string(section + 1) + " does not meet the structure");
  }
  if (const auto path = arguments.value("--report")) {
    save_bytes(*path, Json::parse(drawings.header).dump(2) + "\n");
  }
  return drawings.missed.empty() ? kDone : kToleranceNotMet;
}

}  // namespace

Command drawings_command() {
  return {"drawings",
          "MESH|DESIGN -o DRAWINGS.zip [--section x=V]... [--axis x=V:A]... [options] [--report "
          "R.json]",
          "plan, elevations and sections to scale, as SVG and DXF",
          {{"-o", "DRAWINGS.zip", "where the drawings go (or -)"},
           {"--section", "WHERE",
            "x=V, y=V, z=V or plane=a,b,c,d (a·x + b·y + c·z = d), model "
            "units; several are allowed"},
           {"--axis", "WHERE",
            "x=V:NAME or y=V:NAME, an axis, or z=V:NAME, a level beside those of the lowest and "
            "the highest point, model units; several are allowed, names may be left out"},
           {"--scale", "N|each",
            "of the SVG, 1 : N; default the first usual one at which all fit A3; each: every\n"
            "drawing the first at which it does"},
           {"--unit", "UNIT", "of the DXF, full size: mm (default), cm, m, km, in or ft"},
           {"--model-unit", "UNIT", "of the coordinates; default the design's, or m"},
           kReportRow},
          run_drawings};
}

}  // namespace planish::cli
