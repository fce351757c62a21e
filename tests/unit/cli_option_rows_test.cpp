// SPDX-License-Identifier: MIT
/// Rows of --help are written by hand: here they are held to the one table of options, and to what
/// the commands read.
#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "planish/edit/edit_option_table.hpp"
#include "support/cli.hpp"

namespace planish::testing {
namespace {

using Names = std::set<std::string>;
using Reasons = std::map<std::string, std::string>;

/// Options of the table that have no row of their name: the row that says them, or why there is
/// none.
const Reasons kOtherRows = {
    {"--bounds", "--bound"},     {"--constraints", "--constraint"},
    {"--keep-bends", "--bound"}, {"--reach-length", "--reach"},
    {"--shape", "--bound"},      {"--max-iterations", ""}};  // a guard, not a wish

/// Rows that are no options of HandleEditOptions.
const Reasons kOtherOptions = {{"--handle", "a target"},
                               {"--pin", "a target"},
                               {"--support", "a target"},
                               {"--continuation", "of the targets"},
                               {"--model-unit", "how lengths are read"},
                               {"--threads", "where it runs"},
                               {"--cut", "made before the edit"},
                               {"--fewest", "an edit of edits"},
                               {"--within-handle", "of --fewest"},
                               {"--fair", "an edit of edits"},
                               {"--split-where-needed", "an edit of edits"},
                               {"--count-types", "of the report"},
                               {"--mirrored", "of the report"},
                               {"--symmetry", "of the targets"},
                               {"-o", "a file"},
                               {"--report", "a file"},
                               {"--design", "a file"}};

Names table_names() {
  Names names;
  for_each_edit_option([&](const auto& option) {
    std::string name = "--" + std::string(option.name);
    std::replace(name.begin(), name.end(), '_', '-');
    names.insert(name);
  });
  return names;
}

class CliOptionRows : public Cli {
 protected:
  /// The options that `command` --help lists, each with whether a value follows it.
  std::map<std::string, bool> rows_of(const std::string& command) {
    EXPECT_EQ(run(command + " --help"), 0);
    std::istringstream lines(out());
    std::map<std::string, bool> rows;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  -")) continue;
      const std::size_t end = line.find(' ', 2);
      rows[line.substr(2, end - 2)] = line.at(end + 1) != ' ' && line.at(end + 1) != '[';
    }
    return rows;
  }
};

TEST_F(CliOptionRows, EveryOptionOfTheTableHasARowAndEveryRowIsAnOption) {
  Names expected;
  for (const std::string& name : table_names()) {
    const auto other = kOtherRows.find(name);
    const std::string row = other == kOtherRows.end() ? name : other->second;
    if (!row.empty()) expected.insert(row);
  }
  for (const auto& [name, why] : kOtherOptions) {
    EXPECT_TRUE(expected.insert(name).second) << name << " is in the table, not " << why;
  }
  Names rows;
  for (const auto& [name, has_value] : rows_of("edit")) rows.insert(name);
  EXPECT_EQ(rows, expected);
  const Names table = table_names();
  for (const auto& [name, row] : kOtherRows) EXPECT_TRUE(table.contains(name)) << name;
}

/// What nobody reads would be a row that promises something: a wrong value of it went through.
TEST_F(CliOptionRows, EveryRowIsReadByItsCommand) {
  const Reasons commands = {
      {"edit", "sample:dome:6 --handle 10+=0,0,0.1 --keep-out below=0"},
      {"explore", "sample:dome:6 --handle 10+=0,0,0.1 --keep-out below=0 --dimension 2"},
      {"project", "sample:dome:6"},
      {"offset", "sample:dome:6 --distance 0.1"},
      {"mobility", "sample:dome:6 -o rows.json"},
      {"convert", "sample:dome:6 -o dome.obj"},
      {"types", "sample:dome:6"}};
  for (const auto& [command, words] : commands) {
    const auto rows = rows_of(command);
    EXPECT_FALSE(rows.empty()) << command;
    EXPECT_EQ(run(command + " " + words), 0) << command << ": no option is refused for these words";
    for (const auto& [name, has_value] : rows) {
      if (!has_value || name == "--report" || name == "--design") continue;  // any name will do
      EXPECT_EQ(run(command + " " + words + " " + name + " '?'"), 2) << command << ' ' << name;
    }
  }
}

}  // namespace
}  // namespace planish::testing

#endif
