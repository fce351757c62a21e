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
  print_messages(edit_messages(run, json));
  save_report(arguments, json);
  return exit_code(run);
}

}  // namespace

Command edit_command() {
  std::vector<OptionRow> rows = edit_command_rows();
  rows.insert(rows.end(), {output_row(), kReportRow, kDesignRow});
  return {"edit", "MESH --handle V=x,y,z [options] [-o OUT] [--report R.json] [--design D.json]",
          "move a few vertices; panels stay flat, the rest stays put", rows, run_edit};
}

}  // namespace planish::cli
