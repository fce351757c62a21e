// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>
#include <optional>
#include <utility>
#include <variant>

#include "commands.hpp"
#include "design_input.hpp"
#include "design_output.hpp"
#include "files.hpp"
#include "report.hpp"

namespace planish::cli {
namespace {

OpenedDesign design_and_base(const Arguments& arguments) {
  OpenedDesign opened = open_design(arguments.only_positional("DESIGN"));
  if (const auto base = arguments.value("--base")) opened.base = load_mesh(*base).mesh;
  return opened;
}

Json replay_json(const Design& design, const Replay& replayed) {
  Json json = Json::object();
  add_solve(json, replayed.report, design.options.engine);
  json["verified"] = design.result ? Json(replayed.verified) : Json(nullptr);
  json["deviation"] = design.result ? Json(replayed.deviation) : Json(nullptr);
  json["mesh"] = mesh_json(replayed.base);
  json["planarity_mm_per_m"] =
      planarity_json(replayed.base, replayed.base.positions, replayed.shape);
  json["moved_vertices"] = replayed.mark.moved;
  json["sharpest_fold"] = fold_json(replayed.base, replayed.shape);
  json["remake"] = remake_json(replayed.base, replayed.shape);
  if (replayed.subspace) {
    json["subspace"] = subspace_json(replayed.subspace->report, replayed.subspace->dimension());
  }
  return json;
}

void save_shape(const std::string& path, Design design, const Replay& replayed) {
  Mesh mesh = replayed.base;
  mesh.positions = replayed.shape;
  GlbContent content;
  content.base = replayed.base.positions;
  if (replayed.subspace) content.variations = variations_of(*replayed.subspace);
  content.design = design_for_glb(std::move(design));
  save_mesh(path, mesh, content);
}

/// Nothing where every bit is the same.
void print_deviation(const Replay& replayed) {
  if (replayed.verified) return;
  std::array<char, 32> most{};
  std::snprintf(most.data(), most.size(), "%.2g", replayed.deviation);
  const std::string by =
      std::string(" from the recorded result by up to ") + most.data() + " (units of the mesh)";
  print_message(replayed.agrees ? "differs" + by + ": rounding" : "differs" + by);
}

ExitCode run_replay(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const OpenedDesign opened = design_and_base(arguments);
  auto result = replay(opened.design, opened.base ? &*opened.base : nullptr, progress_line());
  clear_progress_line();
  if (auto* sentence = std::get_if<std::string>(&result)) {
    refuse_file(arguments.only_positional("DESIGN"), *sentence);
  }
  const Replay& replayed = std::get<Replay>(result);
  Design again = opened.design;
  again.result = replayed.mark;
  save_design(arguments, again);
  if (output) save_shape(*output, again, replayed);
  save_report(arguments, replay_json(opened.design, replayed));
  if (opened.design.result) print_deviation(replayed);
  if (opened.design.result && !replayed.agrees) return kToleranceNotMet;
  return exit_code(replayed.report);
}

}  // namespace

Command replay_command() {
  return {"replay",
          "DESIGN.json|DESIGN.glb [--base MESH] [-o OUT] [--report R.json] [--design D.json]",
          "do a design again and compare with its recorded result; exit 4 if it differs by more "
          "than rounding",
          {{"--base", "MESH", "the base mesh, where the design does not hold it"},
           kOutputRow,
           kReportRow,
           kDesignRow},
          run_replay};
}

}  // namespace planish::cli
