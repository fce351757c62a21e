// SPDX-License-Identifier: MIT
/// The `planish` command, run as scripts run it; where there are processes.
#pragma once

#ifndef __EMSCRIPTEN__

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "planish/io/mesh_format.hpp"
#include "support/mesh_builders.hpp"

namespace planish::testing {

namespace fs = std::filesystem;

inline std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs the command in a directory of its own, beside the test program in the build tree.
class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    program_ = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "planish";
    if (!fs::exists(program_)) GTEST_SKIP() << "skipped: the planish command is not built";
    directory_ = fs::temp_directory_path() / ("planish-cli-" + std::to_string(getpid()));
    fs::create_directories(directory_);
  }
  void TearDown() override {
    if (!directory_.empty()) fs::remove_all(directory_);
  }

  /// The exit code; output and messages stay in out() and err().
  int run(const std::string& words) {
    const std::string line = "cd '" + directory_.string() + "' && '" + program_.string() + "' " +
                             words + " >out 2>err </dev/null";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string out() const { return contents(directory_ / "out"); }
  [[nodiscard]] std::string err() const { return contents(directory_ / "err"); }

  Mesh load(const std::string& name) {
    const auto result = read_mesh(contents(directory_ / name), *format_from_name(name));
    EXPECT_EQ(error_text(result), "") << name;
    const auto* file = std::get_if<MeshFile>(&result);
    return file ? file->mesh : Mesh();
  }
  void save(const std::string& name, const std::string& bytes) {
    std::ofstream(directory_ / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }

  fs::path program_, directory_;
};

}  // namespace planish::testing

#endif
