// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_names.hpp"

#include <algorithm>
#include <utility>

#include "fabrication/numbered.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// "a" … "z", "aa", "ab" … for 0, 1 …
std::string letters_of(int part) {
  std::string letters(1, static_cast<char>('a' + part % 26));
  return part < 26 ? letters : letters_of(part / 26 - 1) + letters;
}

}  // namespace

std::string panel_name(int panel) { return numbered("P", panel); }

PanelNames::PanelNames(std::vector<int> parents)
    : parents_(std::move(parents)), letters_(parents_.size()) {
  if (parents_.empty()) return;
  std::vector<int> count(at(*std::max_element(parents_.begin(), parents_.end())) + 1, 0);
  for (const int parent : parents_) ++count[at(parent)];
  std::vector<int> next(count.size(), 0);
  for (std::size_t f = 0; f < parents_.size(); ++f) {
    const std::size_t parent = at(parents_[f]);
    if (count[parent] > 1) letters_[f] = letters_of(next[parent]++);
  }
}

std::string PanelNames::of(int panel) const {
  return have_parents() ? parent_of(panel) + letters_[at(panel)] : panel_name(panel);
}

std::vector<std::string> PanelNames::of(const std::vector<int>& panels) const {
  std::vector<std::string> names;
  names.reserve(panels.size());
  for (const int panel : panels) names.push_back(of(panel));
  return names;
}

std::string PanelNames::parent_of(int panel) const {
  return panel_name(have_parents() ? parents_[at(panel)] : panel);
}

bool PanelNames::is_own_parent(int panel) const {
  return !have_parents() || (parents_[at(panel)] == panel && letters_[at(panel)].empty());
}

}  // namespace planish
