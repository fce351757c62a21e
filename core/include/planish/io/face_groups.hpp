// SPDX-License-Identifier: MIT
/// The named runs of faces of a mesh, as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Groups as text, one a line: first face, blank, name, which a tab precedes where it is one name
/// with blanks. Names may hold any other bytes; line ends become blanks.
[[nodiscard]] std::string face_groups_text(const std::vector<FaceGroup>& groups);

/// What face_groups_text() writes; nullopt where a line has no face of the mesh, or none behind the
/// one before.
[[nodiscard]] std::optional<std::vector<FaceGroup>> parse_face_groups(std::string_view text,
                                                                      int face_count);

}  // namespace planish
