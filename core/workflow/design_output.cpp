// SPDX-License-Identifier: MIT
#include "design_output.hpp"

#include <utility>
#include <variant>

#include "mesh_files.hpp"
#include "planish/design/design_text.hpp"

namespace planish::workflow {

Design make_design(const EditRun& run, std::vector<DesignVariation> variations,
                   const Positions& shape) {
  Design design;
  design.source = run.source;
  const bool as_opened = !run.base.planarised && !run.symmetry;
  auto* file = std::get_if<FileSource>(&design.source);
  if (file != nullptr && as_opened) {
    file->hash = run.uncut_hash ? *run.uncut_hash : mesh_hash(run.base.mesh);
  }
  if (run.base.planarised) design.planarised = run.base.how;
  design.unit = run.asked.unit;
  design.cuts = run.asked.cuts;
  design.targets = run.targets;
  if (run.symmetry) design.symmetry = run.symmetry->elements;
  design.options = run.asked.options;
  design.variations = std::move(variations);
  design.result = mark_of(run.base.mesh, shape);
  return design;
}

std::string design_for_glb(Design design) {
  auto* file = std::get_if<FileSource>(&design.source);
  if (file != nullptr && design.cuts.empty()) {
    file->bytes.clear();
    file->format.clear();
  }
  return write_design(design);
}

std::string edit_bytes(const std::string& name, const EditRun& run, const Positions& shape,
                       const Design& design, std::optional<GlbVariations> variations) {
  GlbContent content;
  content.design = design_for_glb(design);
  content.variations = std::move(variations);
  return moved_mesh_bytes(name, run.base.mesh, shape, std::move(content));
}

}  // namespace planish::workflow
