// SPDX-License-Identifier: MIT
/// Shapes sorted into as few families as are found, each within a distance of one template.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace planish {

/// k columns in order: the corners of an outline, or pairs of numbers around something.
using FamilyShape = Eigen::Matrix2Xd;

enum class ShapeMeasure {
  /// The largest distance of corresponding corners after the rigid motion that is best in the sense
  /// of least squares, over every first corner. [FAM-1]
  kOutline,
  /// The largest difference of corresponding numbers, over every first pair. The first number of a
  /// pair stands between it and the next, as an angle between two edges.
  kCycle,
};

struct FamilyOptions {
  ShapeMeasure measure = ShapeMeasure::kOutline;
  double within = 0.0;    ///< > 0: how far a member may be from its template
  bool mirrored = false;  ///< mirror images belong to one family
};

/// One shape on the template of its family.
struct FamilyMember {
  int family = -1;
  int first = 0;          ///< column of the template at the shape's column 0
  bool mirrored = false;  ///< the columns of the template run the other way
  double distance = 0.0;
  /// Of an outline: what takes the template's corners to the shape's; determinant −1 if mirrored.
  Eigen::Matrix2d rotation = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  /// The column of a template with k columns at the shape's column `column`.
  [[nodiscard]] int template_column(int column, int k) const {
    return (first + (mirrored ? k - column : column)) % k;
  }
};

struct Family {
  FamilyShape shape;         ///< the template
  std::vector<int> members;  ///< shapes, ascending
  double worst = 0.0;        ///< the largest distance of a member
};

struct Families {
  std::vector<Family> families;  ///< the one with most members first; of equals, the lowest member
  std::vector<FamilyMember> members;  ///< one a shape
  long long alignments = 0;           ///< how often a shape was laid on a template

  /// Members of each family.
  [[nodiscard]] std::vector<int> sizes() const;
};

/// Every shape belongs to one family, and is within options.within of its template; shapes with
/// another number of columns never share one. Which ones do depends on the shapes alone, up to
/// rounding: not on their order, nor on where each begins. 10,000 panels take seconds.
/// @param shapes one column each at least; outlines anticlockwise
[[nodiscard]] Families find_families(const std::vector<FamilyShape>& shapes,
                                     const FamilyOptions& options);

}  // namespace planish
