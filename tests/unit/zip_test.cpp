// SPDX-License-Identifier: MIT
#include "planish/io/zip.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

#include "../../core/src/crc32.hpp"

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
  ZipWriter zip;
  const std::string text(1000, 'z');
  const std::string random = noise(50);
  zip.add("a.txt", text);
  zip.add("folder/b.bin", random);
  const std::string bytes = zip.take();
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

}  // namespace
}  // namespace planish
