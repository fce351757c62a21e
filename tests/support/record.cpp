// SPDX-License-Identifier: MIT
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace planish::testing {

void record(const std::string& key, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  ::testing::Test::RecordProperty(key, text.data());
}

}  // namespace planish::testing
