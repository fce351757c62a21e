// SPDX-License-Identifier: MIT
#include "planish/io/face_groups.hpp"

#include <algorithm>

#include "planish/text/number.hpp"

namespace planish {
namespace {

/// Stands before a name that has blanks of its own.
constexpr char kOneName = '\t';

}  // namespace

std::string face_groups_text(const std::vector<FaceGroup>& groups) {
  std::string text;
  for (const FaceGroup& group : groups) {
    text += std::to_string(group.first_face);
    text += ' ';
    if (group.one_name) text += kOneName;
    std::string name = group.name;
    std::replace(name.begin(), name.end(), '\n', ' ');
    text += name;
    text += '\n';
  }
  return text;
}

std::optional<std::vector<FaceGroup>> parse_face_groups(std::string_view text, int face_count) {
  std::vector<FaceGroup> groups;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const std::size_t blank = std::min(line.find(' '), line.size());
    const std::optional<long long> first = parse_integer(line.substr(0, blank));
    const int after = groups.empty() ? -1 : groups.back().first_face;
    if (!first || *first <= after || *first >= face_count) return std::nullopt;
    std::string_view name = line.substr(std::min(blank + 1, line.size()));
    const bool one_name = !name.empty() && name.front() == kOneName;
    if (one_name) name.remove_prefix(1);
    groups.push_back({std::string(name), static_cast<int>(*first), one_name});
  }
  return groups;
}

}  // namespace planish
