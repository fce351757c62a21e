// SPDX-License-Identifier: MIT
/// What a replay leaves behind.
#pragma once

#include <optional>
#include <string>

#include "planish/design/design.hpp"
#include "report.hpp"

namespace planish::workflow {

[[nodiscard]] Json replay_json(const Design& design, const Replay& replayed);

/// The replayed shape in the format of `name`'s extension; a GLB also holds base, variations and
/// `design`.
[[nodiscard]] std::string shape_bytes(const std::string& name, Design design,
                                      const Replay& replayed);

/// The sentence how much the result differs from the recorded one; nullopt where every bit is the
/// same or nothing was recorded.
[[nodiscard]] std::optional<std::string> deviation_sentence(const Design& design,
                                                            const Replay& replayed);

}  // namespace planish::workflow
