// SPDX-License-Identifier: MIT
/// Figures that a test measured, for its record: docs/paper.md is made from them.
#pragma once

#include <string>

namespace planish::testing {

/// Nine digits, under `key`, in the record of the test that runs.
void record(const std::string& key, double value);

}  // namespace planish::testing
