// SPDX-License-Identifier: MIT
/// The words on the command line, sorted by a table of what a command takes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "request.hpp"

namespace planish::cli {

using namespace workflow;  // its names are the commands'

/// What the process returns; scripts rely on the numbers.
enum ExitCode { kDone = 0, kWrongUsage = 2, kInvalidMesh = 3, kToleranceNotMet = 4 };

/// A request, and the words that are no options.
class Arguments : public Request {
 public:
  /// Throws UsageError for an unknown option, a missing value, or a switch with one.
  Arguments(std::span<const std::string_view> words, std::span<const OptionRow> table);

  [[nodiscard]] const std::vector<std::string>& positional() const { return positional_; }

  /// The only positional word, called `what` in the message if it is missing or not alone.
  [[nodiscard]] std::string only_positional(std::string_view what) const;

 private:
  std::vector<std::string> positional_;
};

}  // namespace planish::cli
