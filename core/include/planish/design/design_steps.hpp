// SPDX-License-Identifier: MIT
/// The steps by which a design is made on its flat base, each with its rules, for every caller:
/// page, command, packages and replay.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/edit/kept_by_variations.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/projection/projection.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "planish/text/refusal.hpp"
#include "planish/variations/subspace.hpp"

namespace planish {

/// Where a shape differs from its base.
struct SparseShape {
  std::vector<int> moved;  ///< ascending
  Positions positions;     ///< 3 × |moved|, model units
};

/// @param shape 3 × n
[[nodiscard]] SparseShape difference(const Mesh& base, const Positions& shape);

/// Variations around a shape of a design.
struct VariationFamily {
  Subspace subspace;
  Positions centre;        ///< 3 × n: the shape
  std::vector<int> moved;  ///< ascending: where the shape, or a variation of it, is not the base

  /// A value for each slider that was found: those beyond do nothing, those that `given` lacks are
  /// 0.
  [[nodiscard]] Eigen::VectorXd sliders(const Eigen::Ref<const Eigen::VectorXd>& given) const;
  /// The variation that sliders show. Costs what it moves.
  [[nodiscard]] SparseShape slide(const Eigen::Ref<const Eigen::VectorXd>& given) const;
  /// slide() as 3 × n.
  [[nodiscard]] Positions shape_at(const Eigen::Ref<const Eigen::VectorXd>& given) const;
};

/// Why a shape has no variations around it.
enum class NoVariations {
  kBentPanels,  ///< the edit keeps them bent, see find_variation_problem()
  kNoEdit,      ///< it is the base
};

/// One edit of a base, and what is found around it. Base and options outlive it.
class DesignSteps {
 public:
  /// @param targets as they were stated, with supports that have the points that cuts added
  /// @param symmetry of the base, which gives the targets images; null: none
  DesignSteps(const Mesh& base, const HandleEditOptions& options, const EditTargets& targets,
              std::shared_ptr<const MeshSymmetry> symmetry);

  /// The targets with their images; as stated where they have none.
  [[nodiscard]] const EditTargets& images() const { return images_; }
  /// Why the symmetry gives them none.
  [[nodiscard]] const Refusal& image_problem() const { return image_problem_; }
  [[nodiscard]] const MeshSymmetry* symmetry() const { return symmetry_.get(); }

  /// Solves from the base, all images at once.
  [[nodiscard]] HandleEditResult edit(const Progress& progress) const;
  /// @param solver of this base with these options, kept from an edit before
  [[nodiscard]] HandleEditResult edit(HandleEditSolver& solver, const Progress& progress) const;

  [[nodiscard]] std::optional<NoVariations> find_no_variations(const Positions& shape) const;
  /// Variations around `shape`, by fairness and engine of the edit.
  /// @param close Ψ: empty, the handles as they were stated
  [[nodiscard]] VariationFamily explore(Positions shape, SubspaceOptions options,
                                        const std::vector<int>& close,
                                        const Progress& progress) const;

  /// See planish::make_exact().
  /// @param family whose centre is p⁺; null: the base is
  [[nodiscard]] ProjectionResult make_exact(const VariationFamily* family, const Positions& shown,
                                            double fairness_weight, const Progress& progress) const;

 private:
  [[nodiscard]] KeptByVariations kept() const;

  const Mesh& base_;
  const HandleEditOptions& options_;
  std::shared_ptr<const MeshSymmetry> symmetry_;
  std::vector<int> handles_;  ///< as stated
  EditTargets images_;
  Refusal image_problem_;
};

}  // namespace planish
