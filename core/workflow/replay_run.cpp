// SPDX-License-Identifier: MIT
#include "replay_run.hpp"

#include <array>
#include <cstdio>
#include <utility>

#include "cut_run.hpp"
#include "design_output.hpp"
#include "mesh_files.hpp"

namespace planish::workflow {

Json replay_json(const Design& design, const Replay& replayed) {
  Json json = Json::object();
  add_solve(json, replayed.report, design.options.engine);
  json["verified"] = design.result ? Json(replayed.verified) : Json(nullptr);
  json["deviation"] = design.result ? Json(replayed.deviation) : Json(nullptr);
  json["mesh"] = mesh_json(replayed.base);
  json["planarity_mm_per_m"] =
      planarity_json(replayed.base, replayed.base.positions, replayed.shape);
  json["moved_vertices"] = replayed.mark.moved;
  json["spoilt_faces"] = damage_json(replayed.base, replayed.base.positions, replayed.shape);
  json["motion"] = motion_json(replayed.base, replayed.shape);
  json["sharpest_fold"] = fold_json(replayed.base, replayed.shape);
  json["remake"] = remake_json(replayed.base, replayed.shape);
  add_supports(json, replayed.supports, replayed.base, replayed.shape);
  if (replayed.cut) add_cuts(json, *replayed.cut);
  if (replayed.symmetry) {
    json["symmetry"] = symmetry_json(*replayed.symmetry, replayed.base, replayed.shape);
  }
  if (replayed.family) {
    const Subspace& subspace = replayed.family->subspace;
    json["subspace"] = subspace_json(subspace.report, subspace.dimension());
  }
  return json;
}

std::string shape_bytes(const std::string& name, Design design, const Replay& replayed) {
  GlbContent content;
  if (replayed.family) content.variations = variations_of(replayed.family->subspace);
  content.design = design_for_glb(std::move(design));
  return moved_mesh_bytes(name, replayed.base, replayed.shape, std::move(content));
}

std::optional<std::string> deviation_sentence(const Design& design, const Replay& replayed) {
  if (!design.result || replayed.verified) return std::nullopt;
  std::array<char, 32> most{};
  std::snprintf(most.data(), most.size(), "%.2g", replayed.deviation);
  const std::string by = std::string("differs from the recorded result by up to ") + most.data() +
                         " (units of the mesh)";
  return replayed.agrees ? by + ": rounding" : by;
}

}  // namespace planish::workflow
