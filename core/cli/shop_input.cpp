// SPDX-License-Identifier: MIT
#include "shop_input.hpp"

#include <utility>
#include <variant>

#include "design_input.hpp"
#include "lengths.hpp"
#include "planish/io/gltf.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

Mesh with_positions(Mesh mesh, const Positions& positions) {
  mesh.positions = positions;
  return mesh;
}

ShopInput replay_input(const std::string& path) {
  const OpenedDesign opened = open_design(path);
  auto result = replay(opened.design, opened.base ? &*opened.base : nullptr, progress_line());
  clear_progress_line();
  if (auto* sentence = std::get_if<std::string>(&result)) refuse_file(path, *sentence);
  auto& replayed = std::get<Replay>(result);
  Mesh mesh = with_positions(replayed.base, replayed.shape);
  ShopInput input{std::move(mesh), std::move(replayed.base), opened.design.unit,
                  opened.design.options.tolerance};
  if (replayed.cut) input.names = PanelNames(replayed.cut->parents);
  return input;
}

PanelNames names_after_cuts(const std::string& path, const Design& design, const Positions& base) {
  if (design.cuts.empty()) return {};
  auto cut = cuts_that_left(base, design);
  if (auto* sentence = std::get_if<std::string>(&cut)) refuse_file(path, *sentence);
  return PanelNames(std::get<CutMesh>(std::move(cut)).parents);
}

/// A GLB with a base holds the finished design: nothing is solved.
ShopInput read_glb_input(const std::string& path, const std::string& unit) {
  auto read = read_glb_design(load_bytes(path));
  if (auto* error = std::get_if<ReadError>(&read)) refuse_file(path, error->message);
  auto& glb = std::get<GlbFile>(read);
  ShopInput input{glb.file.mesh, std::nullopt, unit};
  if (glb.base) input.base = with_positions(std::move(glb.file.mesh), *glb.base);
  if (glb.design.empty()) return input;
  const OpenedDesign opened = open_design(path);
  input.model_unit = opened.design.unit;
  input.tolerance = opened.design.options.tolerance;
  if (input.base) input.names = names_after_cuts(path, opened.design, input.base->positions);
  return input;
}

/// The name of the file at `path`, without its extension.
std::string stem_of(const std::string& path) {
  const std::string name = file_name_of(path);
  return name.substr(0, name.find_last_of('.'));
}

}  // namespace

void check_zip_name(const std::string& path, const std::string& what) {
  const std::string extension = extension_of(path);
  for (const char* other : {"png", "jpg", "jpeg", "pdf", "svg", "dxf", "dwg", "html", "csv", "json",
                            "ifc", "step", "stl", "obj", "off", "ply", "glb", "gltf", "3dm"}) {
    if (extension == other) {
      throw UsageError(path + ": " + what + " is a zip file and cannot be written as " + extension);
    }
  }
}

ShopInput load_shop_input(const Arguments& arguments) {
  const std::string path = arguments.only_positional("MESH or DESIGN");
  const std::string unit = model_unit(arguments);
  ShopInput input;
  if (path.ends_with(".json")) {
    input = replay_input(path);
  } else if (path.ends_with(".glb")) {
    input = read_glb_input(path, unit);
  } else {
    input = {load_mesh(path).mesh, std::nullopt, unit};
  }
  input.name = stem_of(path);
  read_shop_options(arguments, input);
  if (const auto against = arguments.value("--against")) input.base = load_mesh(*against).mesh;
  return input;
}

}  // namespace planish::cli
