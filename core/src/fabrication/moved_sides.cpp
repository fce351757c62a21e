// SPDX-License-Identifier: MIT
#include "fabrication/moved_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// `side` as far as `to`.
OutlineSide prolonged(const OutlineSide& side, const Eigen::Vector2d& to) {
  const double length = (to - side.from).norm();
  return {side.from, to, (to - side.from) / length, length, side.number};
}

}  // namespace

CutPiece MovedSides::corners(const Outline& rough, double deeper) const {
  std::vector<OutlineSide> parts;
  for (const OutlineSide& line : lines_of(rough, deeper)) divide(line, deeper, parts);
  CutPiece piece{Outline(2, static_cast<Eigen::Index>(parts.size())), {}};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const OutlineSide& in = parts[(k + parts.size() - 1) % parts.size()];
    piece.corners.col(static_cast<Eigen::Index>(k)) = meeting(in, parts[k], deeper);
    piece.sides.push_back(parts[k].number < 0 ? -1 : sides_[at(parts[k].number)].number);
  }
  return piece;
}

/// The sides of `rough`, those in one line as one, each with the nearest side that it runs along.
std::vector<OutlineSide> MovedSides::lines_of(const Outline& rough, double deeper) const {
  std::vector<OutlineSide> lines;
  const auto goes_on = [&](const OutlineSide& line, const OutlineSide& next) {
    return line.number >= 0 && runs_along(sides_[at(line.number)], next, deeper);
  };
  for (OutlineSide side : sides_of(rough)) {
    if (!(side.length > near())) continue;
    side.number = along_which(side, deeper);
    const bool one = !lines.empty() && goes_on(lines.back(), side);
    if (one) lines.back() = prolonged(lines.back(), side.to);
    if (!one) lines.push_back(side);
  }
  if (lines.size() > 1 && goes_on(lines.back(), lines.front())) {
    lines.front() = prolonged(lines.back(), lines.front().to);
    lines.pop_back();
  }
  return lines;
}

/// How much deeper than the moved side `p` lies.
double MovedSides::depth(const OutlineSide& side, const Eigen::Vector2d& p) const {
  return turn_of(side.along, p - side.from) - distance_;
}

bool MovedSides::runs_along(const OutlineSide& side, const OutlineSide& rough,
                            double deeper) const {
  return side.along.dot(rough.along) > 0.0 &&
         std::abs(depth(side, rough.from) - deeper) <= near() &&
         std::abs(depth(side, rough.to) - deeper) <= near();
}

/// The side that a rough one runs along, of several in one line the nearest to its middle; −1 if
/// there is none.
int MovedSides::along_which(const OutlineSide& rough, double deeper) const {
  int number = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (!runs_along(sides_[k], rough, deeper)) continue;
    const double far = distance_to(sides_[k], 0.5 * (rough.from + rough.to));
    if (far >= nearest) continue;
    number = static_cast<int>(k);
    nearest = far;
  }
  return number;
}

/// Adds `line` to `parts`, divided at the straight corners of the panel.
void MovedSides::divide(const OutlineSide& line, double deeper,
                        std::vector<OutlineSide>& parts) const {
  std::vector<double> ends{line.length};
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const OutlineSide& before = sides_[(k + sides_.size() - 1) % sides_.size()];
    const double start = line.along.dot(sides_[k].from - line.from);
    if (!(start > near() && start < line.length - near())) continue;
    if (!runs_along(sides_[k], line, deeper) || !runs_along(before, line, deeper)) continue;
    ends.push_back(start);
  }
  std::sort(ends.begin(), ends.end());
  double start = 0.0;
  for (const double end : ends) {
    OutlineSide part{line.from + start * line.along, line.from + end * line.along, line.along,
                     end - start, line.number};
    if (ends.size() > 1) part.number = along_which(part, deeper);
    parts.push_back(part);
    start = end;
  }
}

bool MovedSides::are_parallel(int a, int b) const {
  constexpr double kParallel = 1e-6;
  return std::abs(turn_of(sides_[at(a)].along, sides_[at(b)].along)) < kParallel;
}

/// Where the sides that `in` and `out` run along meet; if they are parallel, where `out` starts.
Eigen::Vector2d MovedSides::meeting(const OutlineSide& in, const OutlineSide& out,
                                    double deeper) const {
  if (in.number < 0 || out.number < 0) return out.from;
  const OutlineSide& a = sides_[at(in.number)];
  const OutlineSide& b = sides_[at(out.number)];
  const double turn = turn_of(a.along, b.along);
  const bool follows = at(out.number) == (at(in.number) + 1) % sides_.size();
  if (are_parallel(in.number, out.number) && follows) {
    return b.from + distance_ * left_of(b.along);
  }
  const Eigen::Vector2d on_side = out.from - depth(b, out.from) * left_of(b.along);
  if (are_parallel(in.number, out.number)) return on_side;
  const Eigen::Vector2d from = a.from + distance_ * left_of(a.along);
  const Eigen::Vector2d exact = from + depth(b, from) / turn * a.along;
  const double sharp = std::abs(turn) / (1.0 + std::abs(a.along.dot(b.along)));
  return (exact - out.from).norm() > 2.0 * (near() + deeper) / sharp ? on_side : exact;
}

}  // namespace planish
