// SPDX-License-Identifier: MIT
#include "planish/fabrication/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "numeric/trigonometry.hpp"
#include "planish/text/number.hpp"
#include "planish/text/utf8.hpp"

namespace planish {
namespace {

struct LayerStyle {
  std::string_view name;    ///< of the DXF layer: A–Z only
  int colour;               ///< AutoCAD colour index
  std::string_view stroke;  ///< in SVG
  std::string_view fill;    ///< in SVG
  std::string_view width;   ///< in SVG, pixels at any zoom: 0.26 mm each on paper
};

/// In the order of DrawingLayer.
constexpr std::array<LayerStyle, 12> kLayers = {{{"CUT", 7, "#111", "none", "1"},
                                                 {"MARK", 1, "#c22", "none", "1"},
                                                 {"TEXT", 3, "#272", "none", "1"},
                                                 {"GAP", 8, "#999", "none", "0.7"},
                                                 {"SHEET", 5, "#36c", "none", "1"},
                                                 {"OUTSIDE", 7, "#222", "#fff", "1"},
                                                 {"INSIDE", 9, "#999", "#eee", "0.7"},
                                                 {"SECTION", 1, "#c22", "none", "2"},
                                                 {"AXIS", 8, "#777", "none", "0.5"},
                                                 {"LEVEL", 5, "#36c", "none", "0.7"},
                                                 {"PLANE", 1, "#c22", "none", "2"},
                                                 {"SIZE", 3, "#272", "none", "0.5"}}};

const LayerStyle& style_of(DrawingLayer layer) { return kLayers[static_cast<std::size_t>(layer)]; }

/// Adds one pair of a DXF file: the group code and its value, a line each.
void add_pair(std::string& dxf, int code, std::string_view value) {
  append_integer(dxf, code);
  dxf += '\n';
  dxf += value;
  dxf += '\n';
}

void add_pair(std::string& dxf, int code, double value) {
  append_integer(dxf, code);
  dxf += '\n';
  append_decimals(dxf, value);
  dxf += '\n';
}

void add_pair(std::string& dxf, int code, int value) {
  append_integer(dxf, code);
  dxf += '\n';
  append_integer(dxf, value);
  dxf += '\n';
}

void begin_table(std::string& dxf, std::string_view name, int entries) {
  add_pair(dxf, 0, "TABLE");
  add_pair(dxf, 2, name);
  add_pair(dxf, 70, entries);
}

/// The layers that something is on.
std::vector<LayerStyle> used_layers(const Drawing& drawing) {
  std::array<bool, kLayers.size()> used{};
  for (const DrawnLoop& loop : drawing.loops) used[static_cast<std::size_t>(loop.layer)] = true;
  if (!drawing.texts.empty()) used[static_cast<std::size_t>(DrawingLayer::kText)] = true;
  std::vector<LayerStyle> layers;
  for (std::size_t k = 0; k < kLayers.size(); ++k) {
    if (used[k]) layers.push_back(kLayers[k]);
  }
  return layers;
}

void add_layer_table(std::string& dxf, const std::vector<LayerStyle>& layers) {
  begin_table(dxf, "LAYER", static_cast<int>(layers.size()));
  for (const LayerStyle& layer : layers) {
    add_pair(dxf, 0, "LAYER");
    add_pair(dxf, 2, layer.name);
    add_pair(dxf, 70, 0);
    add_pair(dxf, 62, layer.colour);
    add_pair(dxf, 6, "CONTINUOUS");
  }
  add_pair(dxf, 0, "ENDTAB");
}

/// A unit as the header has it. R12 itself has no variable for it; readers know these all the same.
struct DxfUnit {
  std::string_view name;
  int insunits = 0;     ///< $INSUNITS, 0: none
  int measurement = 1;  ///< $MEASUREMENT: 0 in inches and feet, 1 metric
};
constexpr std::array<DxfUnit, 6> kDxfUnits{
    {{"mm", 4, 1}, {"cm", 5, 1}, {"m", 6, 1}, {"km", 7, 1}, {"in", 1, 0}, {"ft", 2, 0}}};

void add_unit(std::string& dxf, std::string_view name) {
  const auto* const unit = std::find_if(kDxfUnits.begin(), kDxfUnits.end(),
                                        [&](const DxfUnit& one) { return one.name == name; });
  if (unit == kDxfUnits.end()) return;
  add_pair(dxf, 9, "$INSUNITS");
  add_pair(dxf, 70, unit->insunits);
  add_pair(dxf, 9, "$MEASUREMENT");
  add_pair(dxf, 70, unit->measurement);
}

/// Everything before the entities.
std::string dxf_preamble(const Drawing& drawing, std::string_view unit) {
  std::string dxf;
  add_pair(dxf, 0, "SECTION");
  add_pair(dxf, 2, "HEADER");
  add_pair(dxf, 9, "$ACADVER");
  add_pair(dxf, 1, "AC1009");
  add_unit(dxf, unit);
  add_pair(dxf, 0, "ENDSEC");
  add_pair(dxf, 0, "SECTION");
  add_pair(dxf, 2, "TABLES");
  begin_table(dxf, "LTYPE", 1);
  add_pair(dxf, 0, "LTYPE");
  add_pair(dxf, 2, "CONTINUOUS");
  add_pair(dxf, 70, 0);
  add_pair(dxf, 3, "Solid line");
  add_pair(dxf, 72, 65);
  add_pair(dxf, 73, 0);
  add_pair(dxf, 40, 0);
  add_pair(dxf, 0, "ENDTAB");
  add_layer_table(dxf, used_layers(drawing));
  add_pair(dxf, 0, "ENDSEC");
  add_pair(dxf, 0, "SECTION");
  add_pair(dxf, 2, "ENTITIES");
  return dxf;
}

void add_polyline(std::string& dxf, const DrawnLoop& loop) {
  const std::string_view layer = style_of(loop.layer).name;
  add_pair(dxf, 0, "POLYLINE");
  add_pair(dxf, 8, layer);
  add_pair(dxf, 66, 1);
  for (const int code : {10, 20, 30}) add_pair(dxf, code, 0);
  add_pair(dxf, 70, loop.closed ? 1 : 0);
  for (const auto point : loop.points.colwise()) {
    add_pair(dxf, 0, "VERTEX");
    add_pair(dxf, 8, layer);
    add_pair(dxf, 10, point.x());
    add_pair(dxf, 20, point.y());
    add_pair(dxf, 30, 0);
  }
  add_pair(dxf, 0, "SEQEND");
  add_pair(dxf, 8, layer);
}

/// ASCII; anything else as \U+XXXX, which readers of R12 that know more than it show as meant.
std::string dxf_quoted(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string quoted;
  while (!text.empty()) {
    const std::uint32_t code = take_code_point(text);
    if (code >= 0x20 && code < 0x7F) {
      quoted += static_cast<char>(code);
      continue;
    }
    quoted += "\\U+";
    const std::uint32_t written = code > 0xFFFF ? 0xFFFD : code;
    for (int shift = 12; shift >= 0; shift -= 4) quoted += kDigits[written >> shift & 0xFu];
  }
  return quoted;
}

void add_text(std::string& dxf, const DrawnText& text) {
  add_pair(dxf, 0, "TEXT");
  add_pair(dxf, 8, style_of(DrawingLayer::kText).name);
  for (const int code : {10, 11}) {  // where it is aligned; 11 counts, 10 is for old readers
    add_pair(dxf, code, text.position.x());
    add_pair(dxf, code + 10, text.position.y());
    add_pair(dxf, code + 20, 0);
  }
  add_pair(dxf, 40, text.height);
  add_pair(dxf, 1, dxf_quoted(text.text));
  add_pair(dxf, 50, text.degrees);
  add_pair(dxf, 72, 1);  // centred
  add_pair(dxf, 73, 2);  // on its middle
}

void add_attribute(std::string& svg, std::string_view name, double value) {
  svg += ' ';
  svg += name;
  svg += "=\"";
  append_decimals(svg, value);
  svg += '"';
}

void add_line(std::string& svg, const DrawnLoop& loop, double height) {
  svg += loop.closed ? "<polygon class=\"" : "<polyline class=\"";
  svg += style_of(loop.layer).name;
  svg += "\" points=\"";
  for (Eigen::Index k = 0; k < loop.points.cols(); ++k) {
    if (k > 0) svg += ' ';
    append_decimals(svg, loop.points(0, k));
    svg += ',';
    append_decimals(svg, height - loop.points(1, k));
  }
  svg += "\"/>\n";
}

void add_svg_text(std::string& svg, const DrawnText& text, double height) {
  svg += "<text transform=\"translate(";
  append_decimals(svg, text.position.x());
  svg += ' ';
  append_decimals(svg, height - text.position.y());
  svg += ") rotate(";
  append_decimals(svg, -text.degrees);
  svg += ")\"";
  add_attribute(svg, "font-size", 1.4 * text.height);  // capitals are 0.7 of it
  svg += " dy=\"0.35em\">" + markup_quoted(text.text) + "</text>\n";
}

}  // namespace

void append_decimals(std::string& text, double value) {
  constexpr double kMillionths = 1e6;
  constexpr double kLargest = 9e15;  // whole numbers are exact below it
  const double scaled = std::round(std::abs(value) * kMillionths);
  if (!(scaled < kLargest)) return append_number(text, value, 17);
  if (scaled == 0.0) return append_integer(text, 0);
  const auto whole = static_cast<long long>(scaled);
  if (value < 0.0) text += '-';
  append_integer(text, whole / 1000000);
  long long rest = whole % 1000000;
  if (rest == 0) return;
  text += '.';
  for (long long place = 100000; rest > 0; place /= 10) {
    text += static_cast<char>('0' + rest / place);
    rest %= place;
  }
}

double text_width(const std::string& text, double height) {
  return 0.9 * height * static_cast<double>(text.size());
}

void add_moved(Drawing& drawing, const Drawing& part, const PlanarMotion& motion) {
  for (DrawnLoop loop : part.loops) {
    for (auto point : loop.points.colwise()) point = motion.apply(point);
    drawing.loops.push_back(std::move(loop));
  }
  const double turn = arctangent(motion.x_axis.y(), motion.x_axis.x()) * 180.0 / kPi;
  for (DrawnText text : part.texts) {
    text.position = motion.apply(text.position);
    text.degrees += turn;
    drawing.texts.push_back(std::move(text));
  }
}

std::string write_dxf(const Drawing& drawing, std::string_view unit) {
  std::string dxf = dxf_preamble(drawing, unit);
  for (const DrawnLoop& loop : drawing.loops) add_polyline(dxf, loop);
  for (const DrawnText& text : drawing.texts) add_text(dxf, text);
  add_pair(dxf, 0, "ENDSEC");
  add_pair(dxf, 0, "EOF");
  return dxf;
}

std::string write_svg(const Drawing& drawing, double width, double height,
                      const std::string& unit) {
  const bool known = unit == "mm" || unit == "cm" || unit == "in";  // what CSS knows
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
  append_decimals(svg, width);
  if (known) svg += unit;
  svg += "\" height=\"";
  append_decimals(svg, height);
  if (known) svg += unit;
  svg += "\" viewBox=\"0 0 ";
  append_decimals(svg, width);
  svg += ' ';
  append_decimals(svg, height);
  svg += "\">\n<style>polygon,polyline{vector-effect:non-scaling-stroke}";
  svg += "text{font-family:sans-serif;text-anchor:middle;fill:#272}";
  for (const LayerStyle& layer : used_layers(drawing)) {
    svg.append(".").append(layer.name).append("{stroke:").append(layer.stroke);
    svg.append(";stroke-width:").append(layer.width).append("px");
    svg.append(";fill:").append(layer.fill).append("}");
  }
  svg += "</style>\n";
  for (const DrawnLoop& loop : drawing.loops) add_line(svg, loop, height);
  for (const DrawnText& text : drawing.texts) add_svg_text(svg, text, height);
  return svg + "</svg>\n";
}

}  // namespace planish
