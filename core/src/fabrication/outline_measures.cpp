// SPDX-License-Identifier: MIT
#include "fabrication/outline_measures.hpp"

#include <array>
#include <vector>

#include "numeric/trigonometry.hpp"

namespace planish {
namespace {

constexpr double kDegreesOfRadian = 180.0 / kPi;

}  // namespace

void add_measures(TableWriter& table, const Outline& outline) {
  std::vector<double> lengths;
  std::vector<double> angles;
  double perimeter = 0.0;
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    lengths.push_back(side_length(outline, k));
    angles.push_back(interior_angle(outline, k) * kDegreesOfRadian);
    perimeter += lengths.back();
  }
  const BoundingRectangle rectangle = bounding_rectangle(outline);
  table.add("edge_lengths", lengths)
      .add("angles", angles)
      .add("area", area_of(outline))
      .add("perimeter", perimeter)
      .add("rectangle", std::array{rectangle.width, rectangle.height});
}

}  // namespace planish
