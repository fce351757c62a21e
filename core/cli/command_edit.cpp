// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "edit_options.hpp"
#include "edit_sentences.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

ExitCode run_edit(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  const EditRun run = run_edit_solver(arguments, edit_request(arguments));
  const Design design = make_design(run, {}, run.edited);
  save_design(arguments, design);
  if (output) save_bytes(*output, edit_bytes(*output, run, run.edited, design));
  const Json json = edit_json(run, run.edited);
  print_sentence(damage_sentence(json["spoilt_faces"]));
  print_sentence(fold_sentence(json["sharpest_fold"]));
  print_sentence(outcome_sentence(run.report));
  print_sentence(motion_sentence(run, json));
  print_sentence(broken_limits_sentence(run));
  print_sentence(sliding_target_sentence(run));
  print_sentence(fewest_sentence(run, json));
  if (run.splits) print_sentence(splits_sentence(*run.splits, run.report));
  print_sentence(shortfall_sentence(run));
  if (json.contains("types")) print_sentence(type_change_sentence(json["types"]));
  save_report(arguments, json);
  return exit_code(run);
}

}  // namespace

Command edit_command() {
  std::vector<OptionRow> rows = edit_command_rows();
  rows.insert(rows.end(), {kOutputRow, kReportRow, kDesignRow});
  return {"edit", "MESH --handle V=x,y,z [options] [-o OUT] [--report R.json] [--design D.json]",
          "move a few vertices; panels stay flat, the rest stays put", rows, run_edit};
}

}  // namespace planish::cli
