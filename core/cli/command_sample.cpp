// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "planish/shapes/shapes.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

ExitCode run_sample(const Arguments& arguments) {
  const std::string name = arguments.only_positional("NAME");
  const auto output = arguments.value("-o");
  if (!output) throw UsageError("-o OUT is missing");
  check_output_name(*output);
  const int size = parse_whole(arguments.value("--size").value_or("32"), "--size");
  if (const auto mesh = make_sample(name, size)) {
    save_mesh(*output, *mesh);
    return kDone;
  }
  if (make_sample(name, 3)) {
    throw UsageError("--size: " + std::to_string(size) + " is not in 3 … 2000");
  }
  std::string known;
  for (const std::string_view sample : sample_names()) (known += ' ') += sample;
  throw UsageError("there is no sample \"" + name + "\"; there are:" + known);
}

}  // namespace

Command sample_command() {
  return {"sample",
          "NAME [--size N] -o OUT",
          "a mesh to try: roof vault dome freeform hex trihex",
          {{"--size", "N", "about N × N vertices, 3 … 2000, default 32"}, output_row()},
          run_sample};
}

}  // namespace planish::cli
