// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "commands.hpp"
#include "conversion_run.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

ExitCode run_convert(const Arguments& arguments) {
  const std::string input = arguments.only_positional("IN");
  const auto output = arguments.value("-o");
  if (!output) throw UsageError("-o OUT is missing");
  check_output_name(*output);
  const Converted converted = run_conversion(load_mesh(input).mesh, arguments);
  print_messages(converted.messages);
  save_mesh(*output, converted.mesh);
  return kDone;
}

}  // namespace

Command convert_command() {
  std::vector<OptionRow> rows = conversion_option_rows();
  rows.insert(rows.begin(), output_row());
  return {"convert", "IN -o OUT", "another format, the same bits", rows, run_convert};
}

}  // namespace planish::cli
