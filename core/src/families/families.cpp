// SPDX-License-Identifier: MIT
#include "planish/families/families.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "families/family_search.hpp"
#include "families/shape_space.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Shapes as the search sees them: of one number of columns, each once.
struct Distinct {
  std::vector<MeasuredShape> shapes;
  std::vector<std::vector<int>> which;  ///< of the given shapes, that each stands for
};

/// The mean side of all outlines, so that lengths are about 1; 1 for a cycle, or without lengths.
double unit_of(const std::vector<FamilyShape>& shapes, ShapeMeasure measure) {
  if (measure == ShapeMeasure::kCycle) return 1.0;
  double largest = 0.0;
  for (const FamilyShape& shape : shapes) largest = std::max(largest, shape.cwiseAbs().maxCoeff());
  if (!(largest > 0.0)) return 1.0;
  double sum = 0.0;
  double sides = 0.0;
  for (const FamilyShape& shape : shapes) {
    for (Eigen::Index k = 0; k < shape.cols(); ++k) {
      sum += ((shape.col((k + 1) % shape.cols()) - shape.col(k)) / largest).norm();
      sides += 1.0;
    }
  }
  return sum > 0.0 ? sum / sides * largest : largest;
}

/// What puts shapes in an order that neither their numbers nor their first corners decide: keys
/// without their rounding, then the hand.
std::vector<double> rounded_key(const MeasuredShape& shape) {
  std::vector<double> key;
  for (Eigen::Index k = 0; k < shape.key.size(); ++k) {
    key.push_back(std::round(shape.key(k) / kShapeRounding));
  }
  key.push_back(std::round(shape.hand / kShapeRounding));
  return key;
}

/// The column that the shape begins with in the search: a shape that begins elsewhere in its file
/// is then laid on others in the same way, also where several ways are as good.
Eigen::Index first_column(const MeasuredShape& shape) {
  const Eigen::Index k = shape.points.cols();
  const auto rounded = [&](Eigen::Index i) { return std::round(shape.marks(i) / kShapeRounding); };
  Eigen::Index best = 0;
  for (Eigen::Index start = 1; start < k; ++start) {
    for (Eigen::Index i = 0; i < 2 * k; ++i) {
      const Eigen::Index row = i < k ? 0 : k;
      const double here = rounded(row + (start + i) % k), there = rounded(row + (best + i) % k);
      if (here < there) best = start;
      if (here != there) break;
    }
  }
  return best;
}

FamilyShape from_column(const FamilyShape& shape, Eigen::Index first) {
  FamilyShape result(2, shape.cols());
  for (Eigen::Index i = 0; i < shape.cols(); ++i) {
    result.col(i) = shape.col((first + i) % shape.cols());
  }
  return result;
}

/// Joins shapes that are the same up to `same`.
Distinct distinct_of(std::vector<std::pair<int, MeasuredShape>> all, ShapeSpace& space,
                     double same) {
  std::vector<std::vector<double>> keys;
  keys.reserve(all.size());
  for (const auto& [number, shape] : all) keys.push_back(rounded_key(shape));
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  Distinct distinct;
  for (const std::size_t k : order) {
    const MeasuredShape& shape = all[k].second;
    bool known = false;
    // Those before it with the same first number stand right before it.
    for (std::size_t d = distinct.shapes.size(); d-- > 0 && !known;) {
      if (shape.key(0) - distinct.shapes[d].key(0) > same + kShapeRounding) break;
      if ((shape.key - distinct.shapes[d].key).cwiseAbs().maxCoeff() > same) continue;
      known = space.place(shape, distinct.shapes[d], same).distance <= same;
      if (known) distinct.which[d].push_back(all[k].first);
    }
    if (known) continue;
    distinct.shapes.push_back(shape);
    distinct.which.push_back({all[k].first});
  }
  return distinct;
}

/// How a shape with its corners about `mean` lies on the template of a family.
FamilyMember member_on(const Eigen::Vector2d& mean, const ShapePlacement& placement, int family,
                       double unit) {
  FamilyMember member;
  member.family = family;
  member.first = placement.turn;
  member.mirrored = placement.mirrored;
  member.distance = placement.distance * unit;
  member.rotation << placement.cosine, -placement.sine, placement.sine, placement.cosine;
  if (placement.mirrored) member.rotation.row(1) *= -1.0;
  member.shift = mean;
  return member;
}

class Sorting {
 public:
  Sorting(const std::vector<FamilyShape>& shapes, const FamilyOptions& options)
      : given_(shapes),
        options_(options),
        unit_(unit_of(shapes, options.measure)),
        within_(options.within / unit_),
        same_(std::min(kShapeRounding, 1e-4 * within_)),
        space_(options.measure, options.mirrored, same_) {
    result_.members.resize(shapes.size());
    measured_.reserve(shapes.size());
    for (const FamilyShape& shape : shapes) measured_.push_back(space_.measured(shape / unit_));
  }

  Families take() {
    std::map<Eigen::Index, std::vector<int>> by_size;
    for (std::size_t k = 0; k < given_.size(); ++k) {
      by_size[given_[k].cols()].push_back(static_cast<int>(k));
    }
    for (const auto& [size, numbers] : by_size) sort_alike(numbers);
    order_families();
    result_.alignments = space_.alignments();
    return std::move(result_);
  }

 private:
  /// Shapes with as many columns each.
  void sort_alike(const std::vector<int>& numbers) {
    std::vector<std::pair<int, MeasuredShape>> all;
    for (const int k : numbers) {
      const MeasuredShape& shape = measured_[at(k)];
      all.emplace_back(k, space_.measured(from_column(shape.points, first_column(shape))));
    }
    const Distinct distinct = distinct_of(std::move(all), space_, same_);
    // What stands for shapes that are not quite the same must reach them all.
    FamilySearch search(space_, distinct.shapes, within_ - 4.0 * same_);
    for (const Cluster& cluster : search.find()) {
      std::vector<int> members;
      for (const int d : cluster.members) {
        members.insert(members.end(), distinct.which[at(d)].begin(), distinct.which[at(d)].end());
      }
      add_family(cluster.shape, members);
    }
  }

  /// Adds a family of all of `members` that are within the distance; the others found one of their
  /// own.
  void add_family(const MeasuredShape& shape, const std::vector<int>& members) {
    const int number = static_cast<int>(result_.families.size());
    Family family{shape.points * unit_, {}, 0.0};
    std::vector<int> others;
    for (const int k : members) {
      const MeasuredShape& member = measured_[at(k)];
      const ShapePlacement placement = space_.place(member, shape, within_);
      if (!(placement.distance <= within_)) {
        others.push_back(k);
        continue;
      }
      const Eigen::Vector2d mean = given_[at(k)].rowwise().mean();
      result_.members[at(k)] = member_on(mean, placement, number, unit_);
      family.members.push_back(k);
      family.worst = std::max(family.worst, result_.members[at(k)].distance);
    }
    std::sort(family.members.begin(), family.members.end());
    if (!family.members.empty()) result_.families.push_back(std::move(family));
    if (!others.empty()) add_family(measured_[at(others[0])], others);
  }

  void order_families() {
    std::vector<Family>& families = result_.families;
    std::sort(families.begin(), families.end(), [](const Family& a, const Family& b) {
      return a.members.size() != b.members.size() ? a.members.size() > b.members.size()
                                                  : a.members[0] < b.members[0];
    });
    for (std::size_t f = 0; f < families.size(); ++f) {
      for (const int k : families[f].members) result_.members[at(k)].family = static_cast<int>(f);
    }
  }

  const std::vector<FamilyShape>& given_;
  FamilyOptions options_;
  double unit_, within_;
  double same_;  ///< distances below are rounding
  ShapeSpace space_;
  std::vector<MeasuredShape> measured_;
  Families result_;
};

}  // namespace

std::vector<int> Families::sizes() const {
  std::vector<int> sizes;
  sizes.reserve(families.size());
  for (const Family& family : families) sizes.push_back(static_cast<int>(family.members.size()));
  return sizes;
}

Families find_families(const std::vector<FamilyShape>& shapes, const FamilyOptions& options) {
  return Sorting(shapes, options).take();
}

}  // namespace planish
