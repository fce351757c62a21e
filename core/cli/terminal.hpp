// SPDX-License-Identifier: MIT
/// What commands say on standard error, and where what they made goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "design_output.hpp"
#include "edit_run.hpp"
#include "mesh_files.hpp"

namespace planish::cli {

/// Prints one line on standard error, whatever `message` holds.
void print_message(const std::string& message);

/// Each of them.
void print_messages(const std::vector<std::string>& messages);

/// Says `sentence`, if there is one.
void print_sentence(const std::optional<std::string>& sentence);

/// As open_mesh(), with warnings to standard error.
[[nodiscard]] MeshFile load_mesh(const std::string& path);

/// As open_source(), with warnings to standard error.
[[nodiscard]] LoadedSource load_source(const std::string& path);

/// The edit of the only positional word, and what happened to its base to standard error.
[[nodiscard]] EditRun run_edit_solver(const Arguments& arguments, EditRequest asked);

void save_mesh(const std::string& path, const Mesh& mesh);

/// Writes `design` to the place that --design names; nothing without that option.
void save_design(const Arguments& arguments, const Design& design);

/// Writes `json` to the place that --report names. Without that option, to standard output if
/// nothing else was asked for (-o, --design): no solve is done for nothing.
void save_report(const Arguments& arguments, const Json& json);

/// kDone if the result is exact to the tolerance, kToleranceNotMet otherwise.
[[nodiscard]] ExitCode exit_code(const SolveReport& report);
/// kToleranceNotMet also where a handle is not at its target in spite of --hard, or more panels are
/// to be made again than --fewest N allows.
[[nodiscard]] ExitCode exit_code(const EditRun& run);

/// Shows steps on one line of a terminal; empty where standard error is none.
[[nodiscard]] Progress progress_line();

void clear_progress_line();

}  // namespace planish::cli
