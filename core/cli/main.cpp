// SPDX-License-Identifier: MIT
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.hpp"
#include "commands.hpp"
#include "planish/io/mesh_format.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

std::vector<Command> all_commands() {
  return {info_command(),     edit_command(),    explore_command(), project_command(),
          replay_command(),   panels_command(),  types_command(),   drawings_command(),
          offset_command(),   convert_command(), cut_command(),     sample_command(),
          mobility_command(), sweep_command(),   gather_command(),  compare_command()};
}

void print_overview() {
  std::cout << "planish: edit meshes whose panels must stay flat\n\n";
  for (const Command& command : all_commands()) {
    std::cout << "  planish " << command.name << ' ' << command.usage << "\n      "
              << command.summary << '\n';
  }
  std::cout << "\nMeshes: " << all_extensions(".", " ", " ")
            << " by extension; - is standard input or output (OBJ);\n"
               "sample:NAME:SIZE is a sample.\n"
               "Vertices count from 0. Exit: 0 done, 2 wrong usage, 3 unreadable or invalid mesh,\n"
               "4 finished without meeting the tolerance. Options: planish COMMAND --help. "
               "Version: planish --version\n";
}

void print_help(const Command& command) {
  std::cout << "planish " << command.name << ' ' << command.usage << '\n'
            << command.summary << "\n\n";
  for (const OptionRow& row : command.options) {
    std::string option = "  " + std::string(row.name) + ' ' + std::string(row.value);
    option.resize(std::max<std::size_t>(option.size() + 2, 28), ' ');
    std::cout << option << row.help << '\n';
  }
}

ExitCode run_command(const Command& command, std::span<const std::string_view> words) {
  if (std::find(words.begin(), words.end(), "--help") != words.end()) {
    print_help(command);
    return kDone;
  }
  const Arguments arguments(words, command.options);
  if (arguments.value("-o") == "-" && arguments.value("--report") == "-") {
    throw UsageError("-o and --report cannot both go to standard output");
  }
  return command.run(arguments);
}

ExitCode run(std::span<const std::string_view> words) {
  if (words.empty()) throw UsageError("a command is missing; see planish --help");
  if (words[0] == "--help" || words[0] == "help" || words[0] == "-h") {
    print_overview();
    return kDone;
  }
  if (words[0] == "--version") {
    std::cout << "planish " PLANISH_VERSION "\n";
    return kDone;
  }
  for (const Command& command : all_commands()) {
    if (command.name == words[0]) return run_command(command, words.subspan(1));
  }
  throw UsageError("there is no command \"" + std::string(words[0]) + "\"; see planish --help");
}

}  // namespace

OptionRow output_row() {
  static const std::string help = "where the mesh goes (" + all_extensions(".", " ", " ") + ", -)";
  return {"-o", "OUT", help};
}

}  // namespace planish::cli

int main(int argument_count, char** arguments) {
  const std::vector<std::string_view> words(arguments + std::min(argument_count, 1),
                                            arguments + argument_count);
  try {
    return planish::cli::run(words);
  } catch (const planish::workflow::UsageError& error) {
    planish::cli::print_message(error.what());
    return planish::cli::kWrongUsage;
  } catch (const planish::workflow::MeshError& error) {
    planish::cli::print_message(error.what());
    return planish::cli::kInvalidMesh;
  } catch (const std::bad_alloc&) {
    planish::cli::print_message("out of memory");
    return planish::cli::kInvalidMesh;
  }
}
