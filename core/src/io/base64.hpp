// SPDX-License-Identifier: MIT
/// Bytes as text (RFC 4648, with padding).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace planish {

[[nodiscard]] std::string encode_base64(std::string_view bytes);

/// nullopt unless `text` is well formed.
[[nodiscard]] std::optional<std::string> decode_base64(std::string_view text);

}  // namespace planish
