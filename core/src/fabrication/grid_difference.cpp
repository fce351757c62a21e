// SPDX-License-Identifier: MIT
#include "fabrication/grid_difference.hpp"

#include <boost/polygon/polygon.hpp>
#include <cmath>

namespace planish {
namespace {

using GridPoint = boost::polygon::point_data<int>;
using GridPolygon = boost::polygon::polygon_data<int>;
using GridPolygonSet = boost::polygon::polygon_set_data<int>;

GridPolygon on_grid(const Outline& outline, double scale) {
  std::vector<GridPoint> points;
  for (const auto p : outline.colwise()) {
    points.emplace_back(static_cast<int>(std::round(scale * p.x())),
                        static_cast<int>(std::round(scale * p.y())));
  }
  GridPolygon polygon;
  polygon.set(points.begin(), points.end());
  return polygon;
}

Outline from_grid(const GridPolygon& polygon, double scale) {
  std::vector<GridPoint> points(polygon.begin(), polygon.end());
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  Outline outline(2, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    const GridPoint& p = points[static_cast<std::size_t>(k)];
    outline.col(k) << p.x() / scale, p.y() / scale;
  }
  return area_of(outline) < 0.0 ? Outline(outline.rowwise().reverse()) : outline;
}

}  // namespace

std::vector<Outline> grid_difference(const Outline& outline, const std::vector<Outline>& taken,
                                     double scale) {
  GridPolygonSet rest;
  GridPolygonSet removed;
  rest.insert(on_grid(outline, scale));
  for (const Outline& polygon : taken) removed.insert(on_grid(polygon, scale));
  boost::polygon::operators::operator-=(rest, removed);
  std::vector<GridPolygon> polygons;
  rest.get(polygons);
  std::vector<Outline> parts;
  parts.reserve(polygons.size());
  for (const GridPolygon& polygon : polygons) parts.push_back(from_grid(polygon, scale));
  return parts;
}

}  // namespace planish
