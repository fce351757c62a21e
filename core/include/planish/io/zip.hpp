// SPDX-License-Identifier: MIT
/// Zip archives, written: one entry after the other, compressed where that helps.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace planish {

/// Builds one archive in memory. The same entries give the same bytes everywhere: entries carry no
/// time but 1 January 1980.
class ZipWriter {
 public:
  /// What the format holds without its 64-bit extension.
  static constexpr int kMostEntries = 65535;

  /// @param name ASCII, folders with '/'; not twice; @param bytes less than 2 GiB
  void add(std::string_view name, std::string_view bytes);

  /// The archive, below 4 GiB; the writer is empty afterwards.
  [[nodiscard]] std::string take();

 private:
  std::string entries_, directory_;
  std::uint32_t count_ = 0;
};

/// `bytes` as a raw DEFLATE stream (RFC 1951).
[[nodiscard]] std::string deflate_raw(std::string_view bytes);

}  // namespace planish
