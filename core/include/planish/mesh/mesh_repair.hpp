// SPDX-License-Identifier: MIT
/// Harmless faults of a file, mended where it is read and said, instead of refusing all of it.
#pragma once

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// check_mesh() of a mesh as a file has it, after a harmless fault, with a warning that counts and
/// names the first place: a face names a vertex twice in a row, or goes there and back along an
/// edge (1 2 2 3, 1 2 3 2). The corner is named once; a face with 1 or 2 corners, then or from the
/// beginning, is left out. A vertex named twice in another way stays, to be refused.
///
/// A file without that keeps all its faces, also those without area (check_mesh() warns of them):
/// the designs that stand on it name its panels by number, which a face left out before them
/// lowers, as its warning says. O(corners), and as check_mesh().
[[nodiscard]] ReadResult repair_and_check(Mesh mesh, SourceLines lines = {});

}  // namespace planish
