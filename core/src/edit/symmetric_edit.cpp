// SPDX-License-Identifier: MIT
#include "planish/edit/symmetric_edit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "planish/measures/metrics.hpp"
#include "planish/numeric/index.hpp"
#include "planish/projection/planarising.hpp"
#include "planish/text/number.hpp"

namespace planish {
namespace {

/// Thrown and caught in this file: what the images contradict.
struct Contradiction {
  std::string sentence;
};

/// Collects handles, pins and supports with their images.
class ImageCollector {
 public:
  ImageCollector(const EditTargets& targets, const Mesh& base, const MeshSymmetry& symmetry)
      : given_(targets), base_(base), symmetry_(symmetry) {
    constexpr double kSame = 1e-6;  // of the mean edge
    same_ = kSame * mean_edge_length(base);
  }

  EditTargets collect() {
    all_.continuation = given_.continuation;
    for (const Handle& handle : given_.handles) targets_[handle.vertex] = handle.target;
    for (const Handle& handle : given_.handles) add_handle(handle);
    for (const Handle& image : images_) all_.handles.push_back(image);
    add_pins();
    for (const PointSupport& support : given_.supports) add_support(support);
    return std::move(all_);
  }

 private:
  void add_handle(const Handle& handle) {
    if (placed_.count(handle.vertex) != 0) return;  // the image of one before
    const Handle own{handle.vertex, on_fixed_points(handle)};
    all_.handles.push_back(own);
    placed_[own.vertex] = own.target;
    for (std::size_t k = 1; k < symmetry_.operations.size(); ++k) {
      const int image = symmetry_.operations[k].image[at(handle.vertex)];
      const Eigen::Vector3d target = symmetry_.moved(k, own.target);
      check_given(handle.vertex, image, target);
      if (placed_.count(image) != 0) continue;
      placed_[image] = target;
      images_.push_back({image, target});
    }
  }

  /// The target without what rounding took off the planes and axes that the handle is on.
  [[nodiscard]] Eigen::Vector3d on_fixed_points(const Handle& handle) const {
    for (std::size_t k = 0; k < symmetry_.operations.size(); ++k) {
      if (symmetry_.operations[k].image[at(handle.vertex)] != handle.vertex) continue;
      const double way = (symmetry_.moved(k, handle.target) - handle.target).norm();
      if (way > same_) {
        throw Contradiction{"handle " + std::to_string(handle.vertex) +
                            " is on a mirror plane or an axis of the symmetry; its target is " +
                            three_digits(0.5 * way) + " off it"};
      }
    }
    return place_on_fixed_points(symmetry_, handle.vertex, handle.target);
  }

  void check_given(int handle, int image, const Eigen::Vector3d& target) const {
    const auto given = targets_.find(image);
    if (given == targets_.end()) return;
    const double off = (given->second - target).norm();
    if (off <= same_) return;
    throw Contradiction{"handle " + std::to_string(image) + " is the image of handle " +
                        std::to_string(handle) + " by the symmetry, and its target is " +
                        three_digits(off) + " away from the image of that one's"};
  }

  void add_pins() {
    for (const SymmetryOperation& operation : symmetry_.operations) {
      for (const int pin : given_.pins) {
        if (pin >= 0 && pin < base_.vertex_count()) all_.pins.push_back(operation.image[at(pin)]);
      }
    }
    std::sort(all_.pins.begin(), all_.pins.end());
    all_.pins.erase(std::unique(all_.pins.begin(), all_.pins.end()), all_.pins.end());
  }

  void add_support(const PointSupport& support) {
    for (std::size_t k = 0; k < symmetry_.operations.size(); ++k) {
      join(k == 0 ? support : image_of(support, k));
    }
  }

  [[nodiscard]] PointSupport image_of(const PointSupport& support, std::size_t k) const {
    const SymmetryOperation& operation = symmetry_.operations[k];
    PointSupport image = support;
    for (int& v : image.vertices) {
      if (v >= 0 && v < base_.vertex_count()) v = operation.image[at(v)];
    }
    if (support.kind == PointSupport::Kind::kLevel) image.axis = level_axis(support, operation);
    if (support.kind == PointSupport::Kind::kPlane) {
      const Eigen::Map<const Eigen::Vector3d> normal(support.numbers.data());
      const Eigen::Vector3d foot = normal * (support.numbers[3] / normal.squaredNorm());
      const Eigen::Vector3d turned = operation.turn * normal;
      image.numbers = {turned.x(), turned.y(), turned.z(), turned.dot(symmetry_.moved(k, foot))};
    }
    for (auto& point : image.surface.points) {
      Eigen::Map<Eigen::Vector3d> place(point.data());
      place = symmetry_.moved(k, place);
    }
    if (support.kind == PointSupport::Kind::kLine) {
      const Eigen::Map<const Eigen::Vector3d> point(support.numbers.data());
      const Eigen::Map<const Eigen::Vector3d> along(support.numbers.data() + 3);
      const Eigen::Vector3d place = symmetry_.moved(k, point), turned = operation.turn * along;
      image.numbers = {place.x(), place.y(), place.z(), turned.x(), turned.y(), turned.z()};
    }
    return image;
  }

  static int level_axis(const PointSupport& support, const SymmetryOperation& operation) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(operation.turn(axis, support.axis)) > 1.0 - 1e-9) return axis;
    }
    throw Contradiction{"supports: the symmetry turns a level that keeps " +
                        std::string(1, "xyz"[support.axis]) + " into none; state a plane"};
  }

  /// Adds the points to those of a support that is the same thing.
  void join(const PointSupport& support) {
    for (PointSupport& known : all_.supports) {
      if (known.points != support.points || !is_same_thing(known, support)) continue;
      if (known.kind == PointSupport::Kind::kPolyline) return;  // the same points, all of them
      known.vertices.insert(known.vertices.end(), support.vertices.begin(), support.vertices.end());
      std::sort(known.vertices.begin(), known.vertices.end());
      known.vertices.erase(std::unique(known.vertices.begin(), known.vertices.end()),
                           known.vertices.end());
      return;
    }
    all_.supports.push_back(support);
  }

  /// Whether every point of the one has one of the other at its place; of models that images of one
  /// another are that says enough.
  [[nodiscard]] bool is_same_model(const ContextMesh& a, const ContextMesh& b) const {
    const Eigen::Vector3d along(0.36, 0.48, 0.8);  // across no grid
    using Point = std::array<double, 3>;
    const auto place = [&](const Point& p) { return along.dot(Eigen::Vector3d(p.data())); };
    std::vector<std::pair<double, const Point*>> known;
    for (const Point& point : a.points) known.emplace_back(place(point), &point);
    std::sort(known.begin(), known.end());
    return a.points.size() == b.points.size() &&
           std::all_of(b.points.begin(), b.points.end(), [&](const Point& point) {
             auto one = std::lower_bound(
                 known.begin(), known.end(), place(point) - same_,
                 [](const auto& entry, double value) { return entry.first < value; });
             for (; one != known.end() && one->first <= place(point) + same_; ++one) {
               const Eigen::Vector3d way =
                   Eigen::Vector3d(one->second->data()) - Eigen::Vector3d(point.data());
               if (way.norm() <= same_) return true;
             }
             return false;
           });
  }

  [[nodiscard]] bool is_same_thing(const PointSupport& a, const PointSupport& b) const {
    constexpr double kParallel = 1e-9;
    if (a.kind != b.kind) return false;
    if (a.kind == PointSupport::Kind::kOutline) return true;
    if (a.kind == PointSupport::Kind::kPolyline) {
      return points_of(a, base_) == points_of(b, base_);
    }
    if (a.kind == PointSupport::Kind::kSurface) return is_same_model(a.surface, b.surface);
    if (a.kind == PointSupport::Kind::kLevel) return a.axis == b.axis;
    if (is_spring(a)) return a.numbers == b.numbers;
    const bool plane = a.kind == PointSupport::Kind::kPlane;
    const Eigen::Vector3d first(a.numbers.data() + (plane ? 0 : 3));
    const Eigen::Vector3d other(b.numbers.data() + (plane ? 0 : 3));
    if (first.cross(other).norm() > kParallel * first.norm() * other.norm()) return false;
    if (plane) {
      const Eigen::Vector3d foot = other * (b.numbers[3] / other.squaredNorm());
      return std::abs(first.dot(foot) - a.numbers[3]) <= same_ * first.norm();
    }
    const Eigen::Vector3d way =
        Eigen::Vector3d(b.numbers.data()) - Eigen::Vector3d(a.numbers.data());
    return first.cross(way).norm() <= same_ * first.norm();
  }

  const EditTargets& given_;
  const Mesh& base_;
  const MeshSymmetry& symmetry_;
  double same_ = 0.0;                       ///< model units
  std::map<int, Eigen::Vector3d> targets_;  ///< as given
  std::map<int, Eigen::Vector3d> placed_;   ///< given and images
  std::vector<Handle> images_;
  EditTargets all_;
};

}  // namespace

Eigen::Vector3d place_on_fixed_points(const MeshSymmetry& symmetry, int vertex,
                                      const Eigen::Vector3d& place) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (std::size_t k = 0; k < symmetry.operations.size(); ++k) {
    if (symmetry.operations[k].image[at(vertex)] != vertex) continue;
    sum += symmetry.moved(k, place) - place;
    ++count;
  }
  Eigen::Vector3d nearest = place + sum / count;
  for (const SymmetryOperation& operation : symmetry.operations) {
    if (operation.image[at(vertex)] != vertex) continue;
    for (int c = 0; c < 3; ++c) {
      if (operation.turn(c, c) == -1.0) nearest[c] = symmetry.centre[c];
    }
  }
  return nearest;
}

std::variant<EditTargets, std::string> with_images(const EditTargets& targets, const Mesh& base,
                                                   const MeshSymmetry& symmetry) {
  if (auto problem = find_problem(targets, base)) return std::move(*problem);
  try {
    EditTargets all = ImageCollector(targets, base, symmetry).collect();
    if (auto problem = find_problem(all, base)) return "symmetry: with all images, " + *problem;
    return all;
  } catch (const Contradiction& found) {
    return found.sentence;
  }
}

SymmetricBase make_symmetric(Mesh& flat, const MeshSymmetry& symmetry, double tolerance,
                             const Progress& progress) {
  constexpr int kMostRounds = 5;
  SymmetricBase result;
  const double off = asymmetry(symmetry, flat, flat.positions);
  if (off <= kSymmetric) return result;
  result.symmetric = false;
  if (off > kMostEvened) return result;
  const Positions given = flat.positions;
  for (int round = 0; round < kMostRounds && !result.symmetric; ++round) {
    even_out(symmetry, flat.face_vertices, flat.positions);
    // What the means are out of flat is of the second order in what was evened out.
    result.symmetric = planarity_summary(flat).max_excess <= tolerance;
    if (result.symmetric) break;
    const ProjectionResult again = planarise(flat, kNearestFlat, progress);
    if (!again.report.usable()) break;
    flat.positions(Eigen::all, again.moved) = again.moved_positions;
  }
  result.max_move = (flat.positions - given).colwise().norm().maxCoeff();
  result.moved = moved_vertex_count(given, flat.positions);
  return result;
}

}  // namespace planish
