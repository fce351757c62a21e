// SPDX-License-Identifier: MIT
/// The words on the command line, sorted by a table of what a command takes.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planish::cli {

/// What the process returns; scripts rely on the numbers.
enum ExitCode { kDone = 0, kWrongUsage = 2, kInvalidMesh = 3, kToleranceNotMet = 4 };

/// Ends a command with one line on standard error.
struct CommandError : std::runtime_error {
  CommandError(ExitCode exit_code, const std::string& message)
      : std::runtime_error(message), code(exit_code) {}
  ExitCode code;
};

/// An option as --help shows it. `value` is empty for a switch.
struct OptionRow {
  std::string_view name;   ///< "--size" or "-o"
  std::string_view value;  ///< what follows it, for example "N"; "[N]" for a number or nothing
  std::string_view help;
};

/// The sorted words.
class Arguments {
 public:
  /// Throws CommandError for an unknown option, a missing value, or a switch with one.
  Arguments(std::span<const std::string_view> words, std::span<const OptionRow> table);

  [[nodiscard]] const std::vector<std::string>& positional() const { return positional_; }
  [[nodiscard]] bool has(std::string_view option) const;

  /// The last value given for `option`; nullopt if there is none.
  [[nodiscard]] std::optional<std::string> value(std::string_view option) const;

  /// All values given for `option`, in order.
  [[nodiscard]] std::vector<std::string> values(std::string_view option) const;

  /// All options in the order given, each with its value.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& options() const {
    return options_;
  }

  /// The only positional word, called `what` in the message if it is missing or not alone.
  [[nodiscard]] std::string only_positional(std::string_view what) const;

 private:
  std::vector<std::string> positional_;
  std::vector<std::pair<std::string, std::string>> options_;
};

/// A finite decimal number; throws CommandError naming `what` otherwise.
[[nodiscard]] double parse_finite(std::string_view text, std::string_view what);

/// A whole number that fits an int; throws CommandError naming `what` otherwise.
[[nodiscard]] int parse_whole(std::string_view text, std::string_view what);

/// Numbers begin … end - 1 of a list.
struct PartRange {
  std::size_t begin = 0, end = 0;
};

/// "K/N", K from 1: the K-th of N parts of `count` entries, equal to within one. Throws
/// CommandError.
[[nodiscard]] PartRange parse_part(const std::string& text, std::size_t count);

/// `text` at its commas.
[[nodiscard]] std::vector<std::string_view> split_at_commas(std::string_view text);

}  // namespace planish::cli
