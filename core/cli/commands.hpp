// SPDX-License-Identifier: MIT
/// The commands: one table row and one function each.
#pragma once

#include <string_view>
#include <vector>

#include "arguments.hpp"

namespace planish::cli {

struct Command {
  std::string_view name;
  std::string_view usage;    ///< the words that follow the name
  std::string_view summary;  ///< one line for the list of commands
  std::vector<OptionRow> options;
  ExitCode (*run)(const Arguments& arguments);  ///< throws RequestError
};

[[nodiscard]] Command info_command();
[[nodiscard]] Command edit_command();
[[nodiscard]] Command explore_command();
[[nodiscard]] Command project_command();
[[nodiscard]] Command replay_command();
[[nodiscard]] Command convert_command();
[[nodiscard]] Command cut_command();
[[nodiscard]] Command panels_command();
[[nodiscard]] Command types_command();
[[nodiscard]] Command drawings_command();
[[nodiscard]] Command offset_command();
[[nodiscard]] Command sample_command();
[[nodiscard]] Command mobility_command();
[[nodiscard]] Command compare_command();
[[nodiscard]] Command sweep_command();
[[nodiscard]] Command gather_command();

/// Rows that several commands share.
[[nodiscard]] OptionRow output_row();
inline constexpr OptionRow kReportRow = {"--report", "R.json", "where the JSON report goes (or -)"};

inline constexpr OptionRow kDesignRow = {"--design", "D.json",
                                         "where the design goes: base, recipe, mark of the result"};

}  // namespace planish::cli
