// SPDX-License-Identifier: MIT
/// Edits of a session whose base has a symmetry: of every image as well.
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "planish/edit/symmetric_edit.hpp"
#include "refused_outcome.hpp"
#include "session.hpp"

namespace planish {
namespace {

/// "symmetry: the mesh does not have x: …" as a sentence of the page.
std::string sentence_about(std::string clause) {
  constexpr std::string_view kField = "symmetry: ";
  if (clause.compare(0, kField.size(), kField) == 0) clause.erase(0, kField.size());
  return as_sentence(std::move(clause));
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

Refusal Session::find_image_problem(const DesignSteps& steps) {
  return steps.image_problem() ? Refusal(sentence_about(*steps.image_problem())) : std::nullopt;
}

}  // namespace planish
