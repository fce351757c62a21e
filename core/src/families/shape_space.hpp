// SPDX-License-Identifier: MIT
/// How far one shape is from another: outlines up to rigid motions, cycles up to their start.
#pragma once

#include <limits>

#include "planish/families/families.hpp"

namespace planish {

/// Differences of this size, in mean sides or whole numbers of a cycle, decide nothing: they are
/// the rounding of other corners and files.
inline constexpr double kShapeRounding = 1e-9;

/// A shape, ready to be compared with others of as many columns.
struct MeasuredShape {
  FamilyShape points;     ///< an outline's about their mean
  Eigen::VectorXd marks;  ///< per column; two shapes laid on each other differ by no less
  FamilyShape mirrored;   ///< as points, of the mirror image; empty where none is allowed
  Eigen::VectorXd mirrored_marks;
  Eigen::VectorXd key;  ///< of any start; distances are no less than differences of it
  double hand = 0.0;    ///< of any start; another sign for the mirror image
};

/// How a shape, or its mirror image, lies on another.
struct ShapePlacement {
  double distance = std::numeric_limits<double>::infinity();
  int turn = 0;  ///< column k of the shape lies on column k + turn
  bool mirrored = false;
  double cosine = 1.0, sine = 0.0;  ///< of the rotation that takes the other to the shape
};

/// The shapes of one measure.
class ShapeSpace {
 public:
  /// @param same distances that differ by less decide nothing
  ShapeSpace(ShapeMeasure measure, bool mirrored, double same)
      : measure_(measure), mirrored_(mirrored), same_(same) {}

  [[nodiscard]] MeasuredShape measured(const FamilyShape& shape) const;

  /// The nearest placement of `shape` on `other` within a distance, the first of those that are as
  /// near up to rounding; infinitely far if there is none. [FAM-1]
  [[nodiscard]] ShapePlacement place(const MeasuredShape& shape, const MeasuredShape& other,
                                     double within);

  /// The shape's points where they lie on the other, column by column of the other.
  [[nodiscard]] FamilyShape laid(const MeasuredShape& shape, const ShapePlacement& placement) const;

  /// From columns laid on one another (2k × shapes), what is nearest to the farthest. [FAM-2]
  [[nodiscard]] FamilyShape centre(const Eigen::MatrixXd& laid) const;

  [[nodiscard]] long long alignments() const { return alignments_; }

 private:
  void try_turns(const FamilyShape& points, const Eigen::VectorXd& marks,
                 const MeasuredShape& other, double within, bool mirrored, ShapePlacement& best);
  void align(const FamilyShape& points, const FamilyShape& other, int turn,
             ShapePlacement& placement) const;

  ShapeMeasure measure_;
  bool mirrored_;
  double same_;
  long long alignments_ = 0;
};

/// The image of an outline in the x axis, or of a cycle run the other way; it begins with the same
/// corner or edge.
[[nodiscard]] FamilyShape mirror_image(const FamilyShape& shape, ShapeMeasure measure);

}  // namespace planish
