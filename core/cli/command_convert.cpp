// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "files.hpp"

namespace planish::cli {
namespace {

ExitCode run_convert(const Arguments& arguments) {
  const std::string input = arguments.only_positional("IN");
  const auto output = arguments.value("-o");
  if (!output) throw CommandError(kWrongUsage, "-o OUT is missing");
  check_output_name(*output);
  save_mesh(*output, load_mesh(input).mesh);
  return kDone;
}

}  // namespace

Command convert_command() {
  return {"convert", "IN -o OUT", "another format, the same bits", {kOutputRow}, run_convert};
}

}  // namespace planish::cli
