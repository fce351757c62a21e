// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "commands.hpp"
#include "shop_input.hpp"
#include "terminal.hpp"
#include "types_run.hpp"

namespace planish::cli {
namespace {

ExitCode run_types_command(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (output) check_types_name(*output);
  const ShopInput input = load_shop_input(arguments);
  const CuttingPlan plan = plan_types(arguments, input);
  if (output) {
    save_bytes(*output, types_bytes(*output, plan));
    print_messages({type_count_sentence(plan)});
  }
  const std::vector<std::string> sentences = types_sentences(plan, input.tolerance);
  print_messages(sentences);
  save_report(arguments, types_json(plan));
  return sentences.empty() ? kDone : kToleranceNotMet;
}

}  // namespace

Command types_command() {
  std::vector<OptionRow> rows = types_option_rows();
  rows.insert(rows.end(), {{"-o", "TYPES.csv", "which panel is of which type (or -)"}, kReportRow});
  return {"types", "MESH|DESIGN [--joint MIN:MAX | --within D|P%] [-o TYPES.csv] [--report R.json]",
          "which panels, nodes and bars are alike, and one template a type of panel", rows,
          run_types_command};
}

}  // namespace planish::cli
