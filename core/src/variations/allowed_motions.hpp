// SPDX-License-Identifier: MIT
/// Which vectors a subspace around an edit may have: along what points stand on, the same for all
/// images of a symmetry. [SUP-6] [SYM-3]
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "planish/edit/kept_by_variations.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/numeric/index.hpp"
#include "planish/problem/problem.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "problem/shape_slides.hpp"

namespace planish {

/// Vectors t are 3 × free of the patch that is given with them, solver units.
class AllowedMotions {
 public:
  /// @param base what supports are about
  /// @param edited 3 × n, model units: where the vectors begin
  /// @param unit model units per solver unit
  AllowedMotions(const Mesh& base, const Positions& edited, const KeptByVariations& keeps,
                 double unit);

  /// The supports, as they are where the edit has their points, in a problem that this must
  /// outlive. Without supports nothing.
  void hold(EditProblem& problem) const;

  /// Takes out what is held, what rests where it stands, and what then has not all its images in
  /// `vertices` any more. @param vertices sorted
  void leave_out_held(const std::vector<int>& held, std::vector<int>& vertices) const;

  /// Calls visit(w) for the images of `v` but itself; without a symmetry never.
  template <class Visit>
  void for_each_image(int v, const Visit& visit) const {
    if (symmetry_ == nullptr) return;
    for (const SymmetryOperation& one : symmetry_->operations) visit(one.image[at(v)]);
  }

  /// Makes `t` symmetric: each image gets the mean over all motions. Does nothing without a
  /// symmetry.
  void even_out(const Patch& patch, Eigen::Matrix3Xd& t) const;

  /// Takes out what rounding left uneven, and norms again. False where that was more: the vector's
  /// certificate is not that of what is left.
  [[nodiscard]] bool even_out_found(const Patch& patch, Eigen::Matrix3Xd& t) const;

  /// Of a footprint, what is nearest to the image of the edit that moves most: evened out, each of
  /// its motions is one of all images, while those of the whole would mostly cancel. Without a
  /// symmetry all of it.
  /// @param points 3 × n, undisplaced @param edit 3 × free @param footprint a weight for each free
  /// vertex
  [[nodiscard]] Eigen::RowVectorXd first_image(const Patch& patch, const Positions& points,
                                               const Eigen::Matrix3Xd& edit,
                                               Eigen::RowVectorXd footprint) const;

  [[nodiscard]] bool are_symmetric() const { return symmetry_ != nullptr; }

 private:
  std::optional<ShapeSlides> slides_;             ///< none: no supports
  std::shared_ptr<const MeshSymmetry> symmetry_;  ///< null: none
};

/// Leaves of `t` only what goes along the tracks of its vertices; vectors have no offsets.
void put_along_tracks(const Patch& patch, Eigen::Matrix3Xd& t);

}  // namespace planish
