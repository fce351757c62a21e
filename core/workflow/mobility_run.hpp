// SPDX-License-Identifier: MIT
/// What `mobility` takes, does and tells.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit_run.hpp"
#include "planish/mobility/mobility_meter.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> mobility_option_rows();

/// Throws RequestError.
[[nodiscard]] MobilityOptions mobility_options(const Request& request);

/// The vertices that --vertices and --part ask for, ascending; all without either.
[[nodiscard]] std::vector<int> mobility_vertices(const Request& request, const Mesh& mesh);

/// A flat mesh with one meter for each thread.
class MobilityRun {
 public:
  /// Planarises a mesh that is not flat. Throws RequestError.
  /// @param name of the mesh, for messages
  MobilityRun(const Mesh& mesh, const Request& request, const std::string& name,
              const Progress& progress);

  /// kMobilityRows for each vertex, in their order: the same bits with any number of threads.
  [[nodiscard]] std::vector<MobilityRow> measure(const std::vector<int>& vertices);

  [[nodiscard]] const FlatBase& base() const { return *base_; }
  [[nodiscard]] std::size_t thread_count() const { return thread_count_; }

 private:
  std::unique_ptr<FlatBase> base_;  ///< where the meters look at it
  MobilityOptions options_;
  std::size_t thread_count_ = 1;
  std::vector<MobilityMeter> meters_;  ///< made when they are first needed
};

/// JSON, CSV or a coloured GLB by the extension of `name`. Throws RequestError for another one.
/// @param mesh that was measured
[[nodiscard]] std::string mobility_bytes(const std::string& name, const Mesh& mesh,
                                         const std::vector<MobilityRow>& rows);
/// What mobility_bytes() throws.
void check_mobility_name(const std::string& name);

/// "shape", "search" and so on with how many rows they end.
[[nodiscard]] std::string mobility_sentence(const std::vector<MobilityRow>& rows);

}  // namespace planish::workflow
