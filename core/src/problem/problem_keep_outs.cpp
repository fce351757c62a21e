// SPDX-License-Identifier: MIT
/// The keep-outs' rows of a patch: the part of PatchCutter that is about them. [KEE-1]
#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

void PatchCutter::add_keep_outs(const MeshKeepOuts& keep_outs, int face, Patch& patch) {
  for (KeepOutRow row : keep_outs.of(face)) {
    row.vertex = local(row.vertex, patch);
    if (row.vertex < patch.free_count) patch.keep_outs.push_back(row);
  }
}

}  // namespace planish
