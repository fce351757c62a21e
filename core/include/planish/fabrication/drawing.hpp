// SPDX-License-Identifier: MIT
/// A drawing of outlines and centred texts, written as DXF or SVG.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "planish/fabrication/flat_panel.hpp"

namespace planish {

/// What a line is, and what a machine does with it.
enum class DrawingLayer {
  kCut,    ///< cuts it
  kMark,   ///< marks it: the triangle at corner 0
  kText,   ///< writes it
  kGap,    ///< nothing: the panel without its joints
  kSheet,  ///< nothing: the edge of the sheet
  // Of the whole structure:
  kOutside,  ///< a panel that shows its outside
  kInside,   ///< a panel that shows its inside
  kSection,  ///< where a plane cuts it
  kAxis,     ///< an axis of the building
  kLevel,    ///< a height
  kPlane,    ///< where a section cuts
  kSize,     ///< a dimension
};

struct DrawnLoop {
  DrawingLayer layer = DrawingLayer::kCut;
  Outline points;
  bool closed = true;  ///< the last point is joined to the first
};

/// A text on layer kText, centred on its position.
struct DrawnText {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double height = 1.0;
  double degrees = 0.0;  ///< of its baseline, anticlockwise from x
  std::string text;      ///< any bytes; what is no UTF-8 is written as U+FFFD
};

struct Drawing {
  std::vector<DrawnLoop> loops;
  std::vector<DrawnText> texts;
};

/// How wide a text of this height is at most: a character is 0.9 of its height wide or less.
[[nodiscard]] double text_width(const std::string& text, double height);

/// A rotation, then a shift: nothing here is ever mirrored.
struct PlanarMotion {
  Eigen::Vector2d x_axis = Eigen::Vector2d::UnitX();  ///< unit, where the x axis goes
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d apply(const Eigen::Vector2d& p) const {
    return {x_axis.x() * p.x() - x_axis.y() * p.y() + shift.x(),
            x_axis.y() * p.x() + x_axis.x() * p.y() + shift.y()};
  }
};

void add_moved(Drawing& drawing, const Drawing& part, const PlanarMotion& motion);

/// DXF R12 (AC1009), ASCII: polylines and texts, coordinates with 6 decimals. The header names
/// `unit` (mm, cm, m, km, in or ft; any other is not named).
[[nodiscard]] std::string write_dxf(const Drawing& drawing, std::string_view unit);

/// An SVG of the area from (0, 0) to (width, height), y up; `unit` is the unit of all
/// lengths. What comes later covers what came before, where its layer is filled.
[[nodiscard]] std::string write_svg(const Drawing& drawing, double width, double height,
                                    const std::string& unit);

/// Appends `value` with 6 decimals, as printf's %.6f but without zeros at the end and never "-0".
void append_decimals(std::string& text, double value);

}  // namespace planish
