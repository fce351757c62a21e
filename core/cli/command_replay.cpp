// SPDX-License-Identifier: MIT
#include <optional>
#include <utility>
#include <variant>

#include "commands.hpp"
#include "design_input.hpp"
#include "design_output.hpp"
#include "replay_run.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

OpenedDesign design_and_base(const Arguments& arguments) {
  OpenedDesign opened = open_design(arguments.only_positional("DESIGN"));
  if (const auto base = arguments.value("--base")) opened.base = load_mesh(*base).mesh;
  return opened;
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
  if (output) save_bytes(*output, shape_bytes(*output, again, replayed));
  save_report(arguments, replay_json(opened.design, replayed));
  print_sentence(outcome_sentence(replayed.report));
  print_sentence(deviation_sentence(opened.design, replayed));
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
           output_row(),
           kReportRow,
           kDesignRow},
          run_replay};
}

}  // namespace planish::cli
