// SPDX-License-Identifier: MIT
/// Edits of a session whose base has a symmetry: of every image as well.
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "planish/edit/symmetric_edit.hpp"
#include "session.hpp"

namespace planish {
namespace {

/// "symmetry: the mesh does not have x: …" as a sentence of the page.
std::string sentence_about(std::string clause) {
  constexpr std::string_view kField = "symmetry: ";
  if (clause.compare(0, kField.size(), kField) == 0) clause.erase(0, kField.size());
  if (clause[0] >= 'a' && clause[0] <= 'z') clause[0] += 'A' - 'a';
  return clause + ".";
}

}  // namespace

Refusal Session::set_symmetry(const std::string& text, double tolerance) {
  const auto stated = parse_symmetry(text);
  if (!stated) return "A symmetry must be one of " + std::string(known_symmetries()) + ".";
  if (const Refusal refusal = require_flat_base()) return refusal;
  if (cut_) return "A symmetry is chosen before the cuts.";
  const Mesh opened = as_opened();
  auto found = find_symmetry(opened, *stated);
  if (auto* problem = std::get_if<std::string>(&found)) return sentence_about(std::move(*problem));
  auto& symmetry = std::get<MeshSymmetry>(found);
  if (symmetry.operations.size() == 1) {
    return "This mesh has no mirror plane across x, y or z, and no turns about them.";
  }
  Mesh even = base_;
  const SymmetricBase evened = make_symmetric(even, symmetry, tolerance, progress_);
  if (!evened.symmetric) return "This mesh cannot be made flat and symmetric.";
  if (evened.max_move > 0.0) {
    if (const Refusal refusal = adopt_planarised(std::move(even.positions))) return refusal;
  }
  symmetry_ = std::make_shared<const MeshSymmetry>(std::move(symmetry));
  return std::nullopt;
}

Refusal Session::add_images(EditTargets& targets) const {
  if (!symmetry_) return std::nullopt;
  auto all = with_images(targets, base_, *symmetry_);
  if (auto* problem = std::get_if<std::string>(&all)) return sentence_about(std::move(*problem));
  targets = std::get<EditTargets>(std::move(all));
  return std::nullopt;
}

/// A release is what the targets alone give: of a path that a drag took there are no images.
Refusal Session::solve_symmetric(EditMode mode, const EditTargets& targets, double budget_seconds,
                                 HandleEditResult& result) {
  EditTargets images = targets;
  if (const Refusal refusal = add_images(images)) return refusal;
  result = mode == EditMode::kDrag ? solver_->drag(images, budget_seconds)
                                   : solver_->solve_symmetric(images, *symmetry_, progress_);
  return std::nullopt;
}

/// What variations of the edit shown keep.
KeptByVariations Session::kept() const {
  EditTargets images = targets_;
  (void)add_images(images);  // what cannot have them has none
  return kept_by_variations(base_, images, options_, symmetry_);
}

}  // namespace planish
