// SPDX-License-Identifier: MIT
/// Reports as plain JavaScript objects, which a worker can post; planish_reports.d.ts lists their
/// fields.
#pragma once

#include <emscripten/val.h>

#include "session_report.hpp"

namespace planish {

// Numbers that are not finite become null, as they do in a file.
[[nodiscard]] emscripten::val to_value(const MeshReport& report);
[[nodiscard]] emscripten::val to_value(const ShapeReport& report);
[[nodiscard]] emscripten::val to_value(const VariationsReport& report);

}  // namespace planish
