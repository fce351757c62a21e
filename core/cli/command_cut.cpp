// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "commands.hpp"
#include "cut_run.hpp"
#include "design_input.hpp"
#include "design_output.hpp"
#include "edit_options.hpp"
#include "fewer_run.hpp"
#include "lengths.hpp"
#include "planish/io/gltf.hpp"
#include "planish/mesh/mesh_hash.hpp"
#include "shop_input.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

/// What is cut, and what a design of it begins with.
struct CutInput {
  Mesh mesh;
  Design design;
  bool is_edited = false;  ///< the mesh is what an edit made: no design has cuts behind one
};

/// Whether `path` is a design, alone or in a GLB.
bool is_design(const std::string& path) {
  if (!path.ends_with(".glb")) return path.ends_with(".json");
  const auto read = read_glb_design(load_bytes(path));
  const auto* glb = std::get_if<GlbFile>(&read);
  return glb != nullptr && !glb->design.empty();
}

CutInput load_input(const Arguments& arguments) {
  const std::string path = arguments.only_positional("MESH or DESIGN");
  if (is_design(path)) {
    Design design = open_design(path).design;
    const bool is_edited = !design.targets.handles.empty() || !design.variations.empty();
    return {load_shop_input(arguments).mesh, std::move(design), is_edited};
  }
  LoadedSource loaded = load_source(path);
  CutInput input{std::move(loaded.mesh), {}, false};
  input.design.source = std::move(loaded.source);
  input.design.unit = model_unit(arguments);
  auto* file = std::get_if<FileSource>(&input.design.source);
  if (file != nullptr) file->hash = mesh_hash(input.mesh);
  return input;
}

/// A recipe of cuts alone, for whoever goes on from there.
void save_cut_design(const Arguments& arguments, Design design, const std::vector<Cut>& cuts,
                     const Mesh& result) {
  design.cuts.insert(design.cuts.end(), cuts.begin(), cuts.end());
  design.result = mark_of(result, result.positions);
  save_design(arguments, design);
}

void check_design(const Arguments& arguments, const CutInput& input) {
  if (!arguments.has("--design")) return;
  if (input.is_edited) {
    throw UsageError(
        "--design: a design has its cuts before its edit, and this one is edited "
        "already; -o writes the mesh that is cut");
  }
  if (!input.design.symmetry.empty()) {
    throw UsageError("--design: this design has a symmetry, and these are cuts without images");
  }
}

/// Merges panels or takes strips away: points move, so that no design has it.
ExitCode run_fewer_panels(const Arguments& arguments, const std::optional<std::string>& output) {
  const CutInput input = load_input(arguments);
  const FewerRun run = run_fewer(arguments, input.mesh, progress_line());
  clear_progress_line();
  if (output) save_mesh(*output, run.mesh);
  print_sentence(loose_points_sentence(input.mesh, run.mesh));
  save_report(arguments, run.report);
  return kDone;
}

ExitCode run_cut(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  if (asks_for_fewer(arguments)) return run_fewer_panels(arguments, output);
  if (arguments.has("--reach")) {
    throw UsageError("--reach is for --merge and --collapse: there is neither");
  }
  const std::vector<Cut> cuts = asked_cuts(arguments);
  CutInput input = load_input(arguments);
  check_design(arguments, input);
  auto made = cut_mesh(input.mesh, cuts);
  if (const auto* why = std::get_if<std::string>(&made)) throw UsageError(*why);
  const auto& result = std::get<CutMesh>(made);
  if (output) save_mesh(*output, result.mesh);
  save_cut_design(arguments, std::move(input.design), cuts, result.mesh);
  print_sentence(loose_points_sentence(input.mesh, result.mesh));
  Json json = {{"status", "done"}, {"mesh", mesh_json(result.mesh)}};
  add_cuts(json, result);
  save_report(arguments, json);
  return kDone;
}

}  // namespace

Command cut_command() {
  std::vector<OptionRow> rows = cut_option_rows();
  const std::vector<OptionRow> fewer = fewer_option_rows();
  rows.insert(rows.end(), fewer.begin(), fewer.end());
  rows.insert(rows.end(),
              {{"--model-unit", "UNIT", "of the coordinates; default the design's, or m"},
               output_row(),
               kReportRow,
               kDesignRow});
  return {"cut",
          "MESH|DESIGN --split F:A,B ... [-o OUT] [--report R.json]\n"
          "      [--design D.json]",
          "part panels, in the order given; no point moves", rows, run_cut};
}

}  // namespace planish::cli
