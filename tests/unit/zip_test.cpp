// SPDX-License-Identifier: MIT
#include "planish/io/zip.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/src/numeric/crc32.hpp"

#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

namespace planish {
namespace {

/// By a decoder that has nothing to do with ours.
std::string inflated(std::string raw) {
  raw.append(4, '\0');  // where it expects a checksum: it reads ahead
  int length = 0;
  char* bytes = stbi_zlib_decode_noheader_malloc(raw.data(), static_cast<int>(raw.size()), &length);
  EXPECT_NE(bytes, nullptr);
  const std::string text =
      bytes != nullptr ? std::string(bytes, static_cast<std::size_t>(length)) : "";
  std::free(bytes);
  return text;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int k = size - 1; k >= 0; --k) {
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(k)));
  }
  return value;
}

std::string noise(std::size_t size) {
  std::mt19937 random(3);
  std::string bytes;
  while (bytes.size() < size) bytes += static_cast<char>(random() & 255U);
  return bytes;
}

TEST(DeflateRaw, GivesTheSameBytesBack) {
  std::string rows;
  for (int k = 0; k < 5000; ++k) rows += std::to_string(k * 7919 % 1000) + ",0.25,P-0001\r\n";
  for (const std::string& text : {std::string(), std::string("a"), std::string("abcabcabcabc"),
                                  noise(70000), rows, std::string(100000, 'x')}) {
    EXPECT_TRUE(inflated(deflate_raw(text)) == text) << text.size();
  }
  EXPECT_LT(deflate_raw(rows).size(), rows.size() / 2);
}

TEST(ZipWriter, WritesADirectoryOfItsEntries) {
  std::string bytes;
  ZipWriter zip([&](std::string_view piece) { bytes += piece; });
  const std::string text(1000, 'z');
  const std::string random = noise(50);
  zip.add("a.txt", text);
  zip.add("folder/b.bin", random);
  zip.finish();
  const std::size_t end = bytes.size() - 22;
  ASSERT_EQ(number_at(bytes, end, 4), 0x06054b50U);
  EXPECT_EQ(number_at(bytes, end + 10, 2), 2U);
  std::size_t entry = number_at(bytes, end + 16, 4);
  EXPECT_EQ(entry + number_at(bytes, end + 12, 4), end);
  for (const auto& [name, content] :
       {std::pair{std::string("a.txt"), text}, std::pair{std::string("folder/b.bin"), random}}) {
    ASSERT_EQ(number_at(bytes, entry, 4), 0x02014b50U);
    EXPECT_EQ(bytes.substr(entry + 46, name.size()), name);
    const std::size_t local = number_at(bytes, entry + 42, 4);
    const std::size_t size = number_at(bytes, entry + 20, 4);
    ASSERT_EQ(number_at(bytes, local, 4), 0x04034b50U);
    EXPECT_EQ(bytes.substr(local + 4, 26), bytes.substr(entry + 6, 26));  // the same fields
    const std::string stored = bytes.substr(local + 30 + name.size(), size);
    const bool packed = number_at(bytes, entry + 10, 2) == 8;
    EXPECT_EQ(packed, content.size() == 1000);  // noise is stored
    EXPECT_TRUE((packed ? inflated(stored) : stored) == content);
    EXPECT_EQ(number_at(bytes, entry + 16, 4), crc32(content));
    entry += 46 + name.size();
  }
}

TEST(ZipWriter, HandsOnPiecesInOrder) {
  std::vector<std::size_t> sizes;
  std::string bytes;
  ZipWriter zip([&](std::string_view piece) {
    sizes.push_back(piece.size());
    bytes += piece;
  });
  const std::string half = noise(ZipWriter::kPiece / 2);
  for (const char* name : {"a", "b", "c"}) zip.add(name, half);
  ASSERT_EQ(sizes.size(), 1U);  // two halves and their headers
  EXPECT_LT(sizes[0], ZipWriter::kPiece + half.size());
  zip.finish();
  EXPECT_EQ(sizes.size(), 3U);  // the last half, the directory
  const std::size_t directory = number_at(bytes, bytes.size() - 6, 4);
  EXPECT_EQ(directory, sizes[0] + sizes[1]);
  EXPECT_EQ(number_at(bytes, directory + 2 * 47 + 42, 4), sizes[0]);  // where c stands
}

}  // namespace
}  // namespace planish
