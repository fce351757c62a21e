// SPDX-License-Identifier: MIT
#include "design_input.hpp"

#include <string_view>
#include <utility>
#include <variant>

#include "mesh_files.hpp"
#include "planish/design/design_text.hpp"
#include "planish/io/gltf.hpp"

namespace planish::workflow {

void refuse_file(const std::string& path, const std::string& sentence) {
  throw MeshError(path + ": " + sentence);
}

namespace {

Design parse(const std::string& path, std::string_view text) {
  auto design = read_design(text);
  if (const auto* sentence = std::get_if<std::string>(&design)) refuse_file(path, *sentence);
  return std::get<Design>(std::move(design));
}

OpenedDesign open_glb(const std::string& path) {
  auto read = read_glb_design(load_bytes(path));
  if (auto* error = std::get_if<ReadError>(&read)) refuse_file(path, error->message);
  auto& glb = std::get<GlbFile>(read);
  if (glb.design.empty() || !glb.base) refuse_file(path, "there is no design in this GLB");
  OpenedDesign opened{parse(path, glb.design), std::move(glb.file.mesh)};
  opened.base->positions = std::move(*glb.base);
  // The base of a GLB is what the cuts left: they are made on the file that the design names or
  // holds.
  if (!opened.design.cuts.empty()) opened.base.reset();
  return opened;
}

}  // namespace

OpenedDesign open_design(const std::string& path) {
  if (path.ends_with(".glb")) return open_glb(path);
  return {parse(path, load_bytes(path)), std::nullopt};
}

}  // namespace planish::workflow
