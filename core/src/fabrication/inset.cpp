// SPDX-License-Identifier: MIT
#include "planish/fabrication/inset.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "fabrication/grid_difference.hpp"
#include "fabrication/moved_sides.hpp"
#include "fabrication/outline_side.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// One part in 2^30 of a panel's size is one step of the grid. What is narrower than kSliver steps
/// is no part of a panel: no saw can leave it, and six decimals may not show it.
constexpr double kGridSteps = 1073741824.0;
constexpr double kSliver = 16.0;

double step_of(const Outline& outline) {
  return (outline.rowwise().maxCoeff() - outline.rowwise().minCoeff()).maxCoeff() / kGridSteps;
}

/// Every corner where its two sides meet once they have moved; nullopt where a side would vanish or
/// sides would come too near to each other. Exact to the last digits.
std::optional<CutPiece> mitred(const Outline& outline, double distance) {
  constexpr double kSpike = 1e-6;
  const Eigen::Index n = outline.cols();
  CutPiece piece{outline, std::vector<int>(at(n))};
  std::iota(piece.sides.begin(), piece.sides.end(), 0);
  const auto side_at = [n](const Outline& of, Eigen::Index k) -> Eigen::Vector2d {
    return of.col((k + 1) % n) - of.col(k);
  };
  for (Eigen::Index k = 0; k < n && distance > 0.0; ++k) {
    const Eigen::Vector2d in = side_at(outline, (k + n - 1) % n).normalized();
    const Eigen::Vector2d out = side_at(outline, k).normalized();
    const double opening = 1.0 + in.dot(out);
    if (!(opening > kSpike)) return std::nullopt;  // the sides lie on each other
    const Eigen::Vector2d sum(-in.y() - out.y(), in.x() + out.x());
    piece.corners.col(k) = outline.col(k) + distance / opening * sum;
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!(side_at(piece.corners, k).dot(side_at(outline, k)) > 0.0)) return std::nullopt;
  }
  if (!(area_of(piece.corners) > 0.0)) return std::nullopt;
  if (!is_simple(sides_of(piece.corners), kSliver * step_of(outline))) return std::nullopt;
  return piece;
}

/// What the joint takes: a strip along each side, and at each reflex corner what its mitre adds.
std::vector<Outline> strips_along(const std::vector<OutlineSide>& sides, double width,
                                  double reach) {
  std::vector<Outline> strips;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const OutlineSide& in = sides[(k + sides.size() - 1) % sides.size()];
    const OutlineSide& out = sides[k];
    const Eigen::Vector2d inwards = width * left_of(out.along), before = width * left_of(in.along);
    Outline strip(2, 4);
    strip << out.from, out.to, out.to + inwards, out.from + inwards;
    strips.push_back(strip);
    const double turn = turn_of(in.along, out.along), opening = 1.0 + in.along.dot(out.along);
    const bool folds = turn == 0.0 && opening < 1.0;
    if (turn >= 0.0 && !folds) continue;
    // Both sides run on as far as they meet, but not beyond the panel; of a slit, as far as its
    // strip is wide.
    const double along = folds ? width : std::min(-width * turn / opening, reach);
    Outline wedge(2, 5);
    wedge << out.from, out.from + before, out.from + before + along * in.along,
        out.from + inwards - along * out.along, out.from + inwards;
    strips.push_back(wedge);
  }
  return strips;
}

/// Makes the piece start at the corner nearest to `p`; how far that is.
double start_near(const Eigen::Vector2d& p, CutPiece& piece) {
  Eigen::Index first = 0;
  const double squared = (piece.corners.colwise() - p).colwise().squaredNorm().minCoeff(&first);
  Outline turned(2, piece.corners.cols());
  for (Eigen::Index k = 0; k < turned.cols(); ++k) {
    turned.col(k) = piece.corners.col((first + k) % turned.cols());
  }
  piece.corners = turned;
  std::rotate(piece.sides.begin(), piece.sides.begin() + first, piece.sides.end());
  return squared;
}

/// A panel on the grid: its middle is the origin.
struct GridPanel {
  explicit GridPanel(const Outline& outline)
      : middle(0.5 * (outline.rowwise().minCoeff() + outline.rowwise().maxCoeff())),
        centred(outline.colwise() - middle),
        size(centred.cwiseAbs().maxCoeff()),
        step(4.0 * size / kGridSteps) {}

  [[nodiscard]] std::vector<Outline> without(const std::vector<Outline>& strips) const {
    return grid_difference(centred, strips, 1.0 / step);
  }

  Eigen::Vector2d middle;
  Outline centred;
  double size, step;
};

/// Whether the sides of an outline that touches itself enclose each place once.
bool encloses_once(const Outline& outline) {
  constexpr double kRounding = 1e-6;
  double covered = 0.0;
  for (const Outline& part : GridPanel(outline).without({})) covered += area_of(part);
  const double area = area_of(outline);
  return std::abs(covered - area) <= kRounding * area;
}

/// What the grid leaves of a panel whose sides vanish or meet others.
std::vector<CutPiece> clipped(const Outline& outline, double distance) {
  const GridPanel panel(outline);
  const double half = panel.centred.cwiseAbs().rowwise().maxCoeff().minCoeff();
  if (!(distance < half)) return {};
  const std::vector<OutlineSide> sides = sides_of(panel.centred);
  // A sliver's half deeper: what is no wider than a sliver is not left, and ties are decided.
  const double deeper = distance > 0.0 ? kSliver * panel.step : 0.0;
  std::vector<Outline> strips;  // beyond the panel, but not off the grid
  if (distance > 0.0) strips = strips_along(sides, distance + deeper, 3.0 * panel.size);
  std::vector<std::pair<double, CutPiece>> pieces;
  const MovedSides moved(sides, distance, panel.step);
  for (const Outline& part : panel.without(strips)) {
    CutPiece piece = moved.corners(part, deeper);
    if (!is_simple(sides_of(piece.corners), panel.step)) {
      piece = {part, std::vector<int>(at(part.cols()), -1)};
      if (!is_simple(sides_of(part), panel.step)) continue;
    }
    if (!(area_of(piece.corners) > 0.0)) continue;
    const double squared = start_near(panel.centred.col(0), piece);
    piece.corners.colwise() += panel.middle;
    pieces.emplace_back(squared, std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<CutPiece> result;
  result.reserve(pieces.size());
  for (auto& [squared, piece] : pieces) result.push_back(std::move(piece));
  return result;
}

}  // namespace

std::vector<CutPiece> inset(const Outline& outline, double distance) {
  const std::vector<OutlineSide> sides = sides_of(outline);
  if (has_crossing(sides)) return {};
  if (auto piece = mitred(outline, distance)) return {*std::move(piece)};
  if (!is_simple(sides, step_of(outline)) && !encloses_once(outline)) return {};
  return clipped(outline, distance);
}

double area_of(const std::vector<CutPiece>& pieces) {
  double area = 0.0;
  for (const CutPiece& piece : pieces) area += area_of(piece.corners);
  return area;
}

Outline corners_of(const std::vector<CutPiece>& pieces) {
  Outline corners(2, 0);
  for (const CutPiece& piece : pieces) {
    const Eigen::Index before = corners.cols();
    corners.conservativeResize(2, before + piece.corners.cols());
    corners.rightCols(piece.corners.cols()) = piece.corners;
  }
  return corners;
}

}  // namespace planish
