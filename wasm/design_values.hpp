// SPDX-License-Identifier: MIT
/// Designs and their options as plain JavaScript objects, one shape for every module of the page;
/// planish_designs.d.ts lists their fields.
#pragma once

#include <emscripten/val.h>

#include <cstdint>
#include <optional>

#include "planish/design/design.hpp"

namespace planish {

/// The options of an edit, by their keys in the table.
[[nodiscard]] emscripten::val to_value(const HandleEditOptions& options);
[[nodiscard]] emscripten::val to_value(const DesignMark& mark);
[[nodiscard]] emscripten::val to_value(const Design& design);

// What the page made itself: of the right types, if not of the right values. find_problem() looks
// at those. A word that is none gives the default.
/// Of a base; null: not known.
[[nodiscard]] std::optional<std::uint32_t> to_hash(const emscripten::val& hash);
[[nodiscard]] HandleEditOptions to_options(const emscripten::val& settings);
[[nodiscard]] Planarising to_planarising(const emscripten::val& how);
/// How the family of a DesignVariation is found; fairness and engine are the edit's.
[[nodiscard]] SubspaceOptions to_subspace_options(const emscripten::val& family);
[[nodiscard]] Design to_design(const emscripten::val& design);
/// A design without its mesh, which a session has open.
[[nodiscard]] Design to_recipe(const emscripten::val& design);

/// Of every option: name, key, default, and words where it is one of a few; the two usual ways to
/// make a mesh flat; the tolerance of each kind that can be kept beside planarity; the weights of
/// variations.
[[nodiscard]] emscripten::val defaults_value();

}  // namespace planish
