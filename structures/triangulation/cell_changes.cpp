// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/cell_changes.h"

#include <algorithm>
#include <iterator>

namespace kinex {
namespace {

template <std::size_t Width>
std::vector<std::array<ObjectId, Width>> cells_of(const std::vector<ObjectId>& ids) {
  std::vector<std::array<ObjectId, Width>> cells(ids.size() / Width);
  for (std::size_t i = 0; i < ids.size(); ++i) cells[i / Width][i % Width] = ids[i];
  return cells;
}

}  // namespace

template <std::size_t Width>
void CellChanges<Width>::add(Cell cell, bool came) {
  std::sort(cell.begin(), cell.end());
  changes_.push_back({cell, came});
}

template <std::size_t Width>
AttributeDifference CellChanges<Width>::net() const {
  std::vector<Change> sorted = changes_;
  std::sort(sorted.begin(), sorted.end(),
            [](const Change& a, const Change& b) { return a.cell < b.cell; });
  AttributeDifference result;
  for (std::size_t i = 0; i < sorted.size();) {
    const Cell cell = sorted[i].cell;
    int more = 0;
    for (; i < sorted.size() && sorted[i].cell == cell; ++i) more += sorted[i].came ? 1 : -1;
    std::vector<ObjectId>& ids = more > 0 ? result.came : result.gone;
    for (; more != 0; more -= more > 0 ? 1 : -1) ids.insert(ids.end(), cell.begin(), cell.end());
  }
  return result;
}

template <std::size_t Width>
Attribute CellChanges<Width>::undone(Attribute after) const {
  if (changes_.empty()) return after;
  const AttributeDifference change = net();
  const std::vector<Cell> now = cells_of<Width>(after.ids), gone = cells_of<Width>(change.gone);
  const std::vector<Cell> came = cells_of<Width>(change.came);
  std::vector<Cell> kept, before;
  std::set_difference(now.begin(), now.end(), came.begin(), came.end(), std::back_inserter(kept));
  std::merge(kept.begin(), kept.end(), gone.begin(), gone.end(), std::back_inserter(before));
  after.ids.clear();
  for (const Cell& cell : before) after.ids.insert(after.ids.end(), cell.begin(), cell.end());
  return after;
}

template class CellChanges<3>;
template class CellChanges<4>;

}  // namespace kinex
