// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <utility>

#include "base_sentences.hpp"
#include "edit_sentences.hpp"
#include "interruption.hpp"
#include "planish/design/design_text.hpp"

namespace planish::cli {

void print_message(const std::string& message) {
  std::string line = "planish: " + message;
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  std::cerr << line << '\n';
}

void print_messages(const std::vector<std::string>& messages) {
  for (const std::string& message : messages) print_message(message);
}

void print_sentence(const std::optional<std::string>& sentence) {
  if (sentence) print_message(*sentence);
}

namespace {

void print_warnings(const std::string& path, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    print_message(shown_name(path) + ": warning: " + warning);
  }
}

}  // namespace

MeshFile load_mesh(const std::string& path) {
  MeshFile file = open_mesh(path);
  print_warnings(path, file.warnings);
  return file;
}

LoadedSource load_source(const std::string& path) {
  LoadedSource source = open_source(path);
  print_warnings(path, source.warnings);
  return source;
}

namespace {

/// Lines that let handles go further are said as they are found; Ctrl-C keeps what was found.
EditRun run_split_edit(EditRequest asked, LoadedSource source, const std::string& name) {
  const Interruption interruption;
  const Progress line = progress_line();
  if (line) {
    asked.splits->found = [](const SplitStanding& standing) {
      clear_progress_line();
      print_message(standing_sentence(standing));
    };
  }
  const Progress watched = [&](const IterationRecord& record) {
    const Flow flow = line ? line(record) : Flow::kContinue;
    return Interruption::is_asked_for() ? Flow::kStop : flow;
  };
  EditRun run = run_edit(std::move(asked), std::move(source), name, watched);
  if (run.report.status == SolveStatus::kCancelled) {
    throw UsageError("stopped before an edit was found");
  }
  return run;
}

/// Runs an edit, and shows on a terminal how far it is.
EditRun run_watched(EditRequest asked, LoadedSource source, const std::string& name) {
  if (asked.splits) return run_split_edit(std::move(asked), std::move(source), name);
  return run_edit(std::move(asked), std::move(source), name, progress_line());
}

}  // namespace

EditRun run_edit_solver(const Arguments& arguments, EditRequest asked) {
  const std::string name = arguments.only_positional("MESH");
  LoadedSource source = load_source(name);
  EditRun run = run_watched(std::move(asked), std::move(source), name);
  clear_progress_line();
  for (const std::string& message : base_messages(run)) print_message(name + ": " + message);
  return run;
}

void save_mesh(const std::string& path, const Mesh& mesh) {
  save_bytes(path, mesh_bytes(path, mesh));
}

void save_design(const Arguments& arguments, const Design& design) {
  if (const auto path = arguments.value("--design")) save_bytes(*path, write_design(design) + "\n");
}

void save_report(const Arguments& arguments, const Json& json) {
  const auto path = arguments.value("--report");
  const bool wanted = path || !(arguments.value("-o") || arguments.value("--design"));
  if (wanted) save_bytes(path.value_or("-"), json.dump(2) + "\n");
}

ExitCode exit_code(const SolveReport& report) { return report.usable() ? kDone : kToleranceNotMet; }

ExitCode exit_code(const EditRun& run) {
  return misses_hard_handle(run) || misses_most_panels(run) ? kToleranceNotMet
                                                            : exit_code(run.report);
}

Progress progress_line() {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [step = 0](const IterationRecord& record) mutable {
    std::fprintf(stderr, "\rstep %d  objective %.6g  residual %.2g\033[K", ++step, record.objective,
                 record.primal_residual);
    return Flow::kContinue;
  };
}

void clear_progress_line() {
  if (isatty(STDERR_FILENO) != 0) std::fputs("\r\033[K", stderr);
}

}  // namespace planish::cli
