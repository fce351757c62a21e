// SPDX-License-Identifier: MIT
#include "planish/fabrication/sheet_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace planish {
namespace {

struct SheetRow {
  int sheet = 0;
  double y = 0.0, height = 0.0;
  double used = 0.0;  ///< along x, spacing included
};

/// An item the way round that it fits: lying if it can.
struct FittedItem {
  std::size_t item = 0;
  double width = 0.0, height = 0.0;
  bool turned = false;
};

class SheetFiller {
 public:
  explicit SheetFiller(const SheetSize& size) : size_(size) {}

  [[nodiscard]] bool fits(double width, double height) const {
    return width + 2.0 * size_.spacing <= size_.width &&
           height + 2.0 * size_.spacing <= size_.height;
  }

  SheetPlace put(const FittedItem& item) {
    SheetRow& row = row_for(item);
    const SheetPlace place{row.sheet, row.used, row.y, item.turned};
    row.used += item.width + size_.spacing;
    return place;
  }

 private:
  SheetRow& row_for(const FittedItem& item) {
    for (SheetRow& row : rows_) {
      const bool room = row.used + item.width + size_.spacing <= size_.width;
      if (room && item.height <= row.height) return row;
    }
    std::size_t sheet = 0;
    while (sheet < used_.size() && used_[sheet] + item.height + size_.spacing > size_.height)
      ++sheet;
    if (sheet == used_.size()) used_.push_back(size_.spacing);
    rows_.push_back({static_cast<int>(sheet), used_[sheet], item.height, size_.spacing});
    used_[sheet] += item.height + size_.spacing;
    return rows_.back();
  }

  SheetSize size_;
  std::vector<SheetRow> rows_;
  std::vector<double> used_;  ///< of each sheet, along y
};

}  // namespace

std::vector<SheetPlace> arrange_on_sheets(const std::vector<SheetItem>& items,
                                          const SheetSize& sheet) {
  SheetFiller filler(sheet);
  std::vector<SheetPlace> places(items.size());
  std::vector<FittedItem> fitted;
  for (std::size_t k = 0; k < items.size(); ++k) {
    const SheetItem& item = items[k];
    if (filler.fits(item.width, item.height)) {
      fitted.push_back({k, item.width, item.height, false});
    } else if (filler.fits(item.height, item.width)) {
      fitted.push_back({k, item.height, item.width, true});
    }
  }
  std::stable_sort(fitted.begin(), fitted.end(), [](const FittedItem& a, const FittedItem& b) {
    return a.height != b.height ? a.height > b.height : a.width > b.width;
  });
  for (const FittedItem& item : fitted) places[item.item] = filler.put(item);
  return places;
}

}  // namespace planish
