// SPDX-License-Identifier: MIT
/// What is asked for: values by the names of options, and what is wrong with them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planish::workflow {

/// Keeps the order in which keys are added.
using Json = nlohmann::ordered_json;

/// Why there is no result, in one sentence that names the field; an option as "--size".
struct RequestError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An option, a handle or a name is wrong, whatever the mesh is.
struct UsageError : RequestError {
  using RequestError::RequestError;
};

/// A mesh, a design or a file cannot be used.
struct MeshError : RequestError {
  using RequestError::RequestError;
};

/// An option as --help shows it. `value` is empty for a switch.
struct OptionRow {
  std::string_view name;   ///< "--size" or "-o"
  std::string_view value;  ///< what follows it, for example "N"; "[N]" for a number or nothing
  std::string_view help;
};

/// The values of options, in the order given: texts from the command line; from a program numbers,
/// flags, texts, lists of them, and objects where an option has parts.
class Request {
 public:
  /// What a program asks for. Throws UsageError for a name that is not in `table`.
  /// @param json an object of values by name, "keep-boundary" for example; "pins" for all of --pin.
  /// null is not asked for, a switch is true or false
  Request(std::string_view json, std::span<const OptionRow> table);

  [[nodiscard]] bool has(std::string_view option) const { return last(option) != nullptr; }

  /// The last value given for `option`, as text; nullopt if there is none.
  [[nodiscard]] std::optional<std::string> value(std::string_view option) const;

  /// The last value given for `option`, as it was given; null if there is none.
  [[nodiscard]] const Json* last(std::string_view option) const;

  /// All values given for `option`, in order.
  [[nodiscard]] std::vector<Json> values(std::string_view option) const;

  /// All values given for `option` as texts, in order.
  [[nodiscard]] std::vector<std::string> texts(std::string_view option) const;

  /// Sets `number` where `option` is given. Throws UsageError.
  void read(std::string_view option, double& number) const;
  void read(std::string_view option, int& number) const;

  /// All options in the order given, each with its value.
  [[nodiscard]] const std::vector<std::pair<std::string, Json>>& options() const {
    return options_;
  }

 protected:
  Request() = default;
  void add(std::string_view option, Json value) { options_.emplace_back(option, std::move(value)); }

 private:
  void add_all(std::string_view option, const Json& value);

  std::vector<std::pair<std::string, Json>> options_;
};

/// A value as the command line has it: "1,2,3" for a list.
[[nodiscard]] std::string text_of(const Json& value);

/// The entries of a list, which may be a text with commas.
[[nodiscard]] std::vector<Json> entries_of(const Json& value);

/// A finite decimal number, which may be a text; throws UsageError naming `what` otherwise.
[[nodiscard]] double parse_finite(const Json& value, std::string_view what);

/// A whole number that fits an int; throws UsageError naming `what` otherwise.
[[nodiscard]] int parse_whole(const Json& value, std::string_view what);

/// Numbers begin … end - 1 of a list.
struct PartRange {
  std::size_t begin = 0, end = 0;
};

/// "K/N", K from 1: the K-th of N parts of `count` entries, equal to within one. Throws UsageError.
[[nodiscard]] PartRange parse_part(const std::string& text, std::size_t count);

}  // namespace planish::workflow
