// SPDX-License-Identifier: MIT
/// A model beside the mesh that is edited: what it must not go through, or stand on.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/text/refusal.hpp"

namespace planish {

/// Points and panels that stay where they are.
struct ContextMesh {
  std::vector<std::array<double, 3>> points;  ///< model units
  std::vector<std::vector<int>> panels;       ///< three points or more each

  friend bool operator==(const ContextMesh&, const ContextMesh&) = default;
};

/// Most panels of one, and of all keep-outs together.
inline constexpr std::size_t kMostContextPanels = 20'000;

/// "x,y,z;x,y,z;x,y,z/0,1,2": the points and, behind the stroke, the panels.
/// @returns nullopt where the text is no such list; the rules are find_problem()'s
[[nodiscard]] std::optional<ContextMesh> parse_context_mesh(std::string_view text);

/// Appends the text that parse_context_mesh() reads, with the same bits.
void append_context_mesh(const ContextMesh& mesh, std::string& text);

/// The first rule that `mesh` breaks, without the field that it is in; nullopt if none.
[[nodiscard]] Refusal find_problem(const ContextMesh& mesh);

}  // namespace planish
