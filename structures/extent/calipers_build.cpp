// SPDX-License-Identifier: GPL-3.0-or-later
// Calipers: the list of directions, built from signs and compared with the one that is there.
#include <algorithm>

#include "structures/extent/calipers.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

// The arc of an edge, from its quadrant as seen from the first one.
std::vector<Calipers::Placed> Calipers::placed(const std::vector<ObjectId>& cycle) const {
  const ObjectId first = cycle[0], first_to = ring_.next(first);
  std::vector<Placed> result;
  for (std::uint32_t i = 0; i < cycle.size(); ++i) {
    const ObjectId e = cycle[i], to = ring_.next(e);
    int arc = 0;
    if (i > 0) {
      const Sign cross = kernel_->sign_after(slope_, {first, first_to, e, to});
      const bool left = cross == Sign::kPositive;
      if (folds_ == 2) {
        arc = left ? 0 : 1;
      } else {
        const Sign dot = kernel_->sign_after(dot_, {first, first_to, e, to});
        if (left) {
          arc = dot == Sign::kPositive ? 0 : 1;
        } else {
          arc = dot == Sign::kNegative ? 2 : 3;
        }
      }
    }
    result.push_back({e, static_cast<std::uint8_t>(arc), i});
  }
  return result;
}

bool Calipers::stands_before(const Placed& a, const Placed& b) const {
  const int k = modulo(b.arc - a.arc);
  if (k == 0) return a.place < b.place;
  const ObjectId a_to = ring_.next(a.edge), b_to = ring_.next(b.edge);
  Sign sign = Sign::kZero;
  switch (quarters(k)) {
    case 1:
      sign = kernel_->sign_after(dot_, {a_to, a.edge, b.edge, b_to});
      break;
    case 2:
      sign = kernel_->sign_after(slope_, {b.edge, b_to, a.edge, a_to});
      break;
    default:
      sign = kernel_->sign_after(dot_, {a.edge, a_to, b.edge, b_to});
  }
  return sign == Sign::kPositive || (sign == Sign::kZero && a.edge < b.edge);
}

// A sweep over the directions of one fold: for each of its `folds` rotations the first edge at or
// after it.
void Calipers::set_contacts(const std::vector<Placed>& sorted, const std::vector<Placed>& placed) {
  std::array<ObjectId, 4> first;
  first.fill(placed[0].edge);
  for (std::size_t i = placed.size(); i-- > 0;) {
    for (std::size_t arc = 0; arc <= placed[i].arc; ++arc) first[arc] = placed[i].edge;
  }
  for (const Placed& p : sorted) {
    for (int k = 1; k < folds_; ++k) {
      state_[p.edge].contact[index(k)] = first[static_cast<std::size_t>(modulo(p.arc + k))];
    }
    first[p.arc] = ring_.next(p.edge);
  }
}

void Calipers::build(const HullRing& ring) {
  const std::vector<ObjectId> before = ring_.cycle(), cycle = ring.cycle();
  changes_.insert(changes_.end(), before.begin(), before.end());
  changes_.insert(changes_.end(), cycle.begin(), cycle.end());
  ring_.assign(cycle);
  ties_.clear();
  for (const ObjectId e : cycle) make_room(e);
  for (const ObjectId e : before) {
    if (!ring_.has(e) || !has_list()) slots_.drop(state_[e].certificate);
  }
  if (!has_list()) return;
  const std::vector<Placed> by_place = placed(cycle);
  std::vector<Placed> sorted = by_place;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Placed& a, const Placed& b) { return a.arc < b.arc; });
  merge_sort(sorted, [this](const Placed& b, const Placed& a) { return stands_before(b, a); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool last = i + 1 == sorted.size();
    const Placed &e = sorted[i], &f = sorted[last ? 0 : i + 1];
    link(e.edge, f.edge, f.arc - e.arc - (last ? 1 : 0));
  }
  set_contacts(sorted, by_place);
  for (const ObjectId e : cycle) certify(e);
  settle();
}

}  // namespace kinex
