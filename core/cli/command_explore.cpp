// SPDX-License-Identifier: MIT
#include <string>
#include <utility>

#include "commands.hpp"
#include "edit_options.hpp"
#include "exploration.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

ExitCode run_explore(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  EditRequest edit = edit_request(arguments);
  FamilyRequest asked = family_request(arguments, edit.options);
  const Eigen::VectorXd values = coefficients(arguments, asked.options.dimension);
  const EditRun run = run_edit_solver(arguments, std::move(edit));
  const auto family = find_family(run, std::move(asked), progress_line());
  Variation variation{values, family.found.shape_at(values), {}};
  if (arguments.has("--exact")) {
    variation = make_exact(run, family, std::move(variation), progress_line());
  }
  clear_progress_line();
  ExitCode code = exit_code(run);
  if (code == kDone && variation.exact) code = exit_code(variation.exact->report);
  const Design design = variation_design(run, family, variation);
  save_design(arguments, design);
  if (output) {
    save_bytes(*output, edit_bytes(*output, run, variation.positions, design,
                                   variations_of(family.found.subspace)));
  }
  const Json json = exploration_json(run, family, variation);
  print_messages(exploration_messages(run, variation, json));
  save_report(arguments, json);
  return code;
}

}  // namespace

Command explore_command() {
  std::vector<OptionRow> rows = edit_command_rows();
  for (const OptionRow& row : family_option_rows()) rows.push_back(row);
  rows.insert(rows.end(), {output_row(), kReportRow, kDesignRow});
  return {"explore",
          "MESH <edit options> --dimension S [options] [-o OUT] [--report R.json]\n"
          "      [--design D.json]",
          "an edit with a family of local variations around it", rows, run_explore};
}

}  // namespace planish::cli
