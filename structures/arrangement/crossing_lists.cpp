// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/crossing_lists.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "predicates/predicates.h"
#include "structures/parts/merge_sort.h"
#include "structures/parts/ties.h"

namespace kinex {

CrossingLists::CrossingLists(Kernel& kernel, StructureId id, const std::vector<bool>& is_line)
    : kernel_(&kernel),
      slope_order_(kernel.bind(make_coordinate_order(0))),
      orientation_(kernel.bind(make_orientation_2())),
      slots_(kernel, id, "crossings"),
      numbers_(is_line),
      rows_(is_line.size()),
      places_(std::size_t{numbers_.count()} * numbers_.count(), kNowhere),
      certificates_(places_.size(), kNoCertificate),
      sides_(places_.size()),
      loose_(is_line.size()) {}

// ---- signs and claims

int CrossingLists::side_now(ObjectId l, ObjectId m) const {
  const Sign sign = kernel_->sign_after({slope_order_, {l, m}});
  return sign == Sign::kPositive ? 1 : sign == Sign::kNegative ? -1 : 0;
}

void CrossingLists::set_side(ObjectId l, ObjectId m, int side) {
  sides_[at(l, m)] = static_cast<std::int8_t>(side);
  sides_[at(m, l)] = static_cast<std::int8_t>(-side);
}

// The crossing of l and m is at x = -(b_m - b_l) / (a_m - a_l): compared after multiplication by
// both denominators.
Query CrossingLists::claim(ObjectId l, ObjectId m, ObjectId k) const {
  return side(l, m) == side(l, k) ? Query(orientation_, {l, k, m}) : Query(orientation_, {l, m, k});
}

// orientation_2(l, x, y) = b_l (a_y - a_x) + b_x (a_l - a_y) + b_y (a_x - a_l).
bool CrossingLists::goes_first(ObjectId l, ObjectId m, ObjectId k) const {
  const bool same = side(l, m) == side(l, k);
  const ObjectId x = same ? k : m, y = same ? m : k;
  std::array<std::pair<ObjectId, int>, 3> cofactors{
      {{l, side(x, y)}, {x, side(y, l)}, {y, side(l, x)}}};
  std::sort(cofactors.begin(), cofactors.end());
  for (const auto& [id, sign] : cofactors) {
    if (sign != 0) return sign > 0;
  }
  return m < k;
}

bool CrossingLists::before(ObjectId l, ObjectId m, ObjectId k) const {
  const bool m_crosses = crosses(l, m), k_crosses = crosses(l, k);
  if (m_crosses != k_crosses) return k_crosses;
  if (!m_crosses) return k == l || (m != l && m < k);
  const Sign sign = kernel_->sign_after(claim(l, m, k));
  return sign == Sign::kPositive || (sign == Sign::kZero && goes_first(l, m, k));
}

bool CrossingLists::is_tied(ObjectId l, ObjectId m) const {
  const std::size_t p = place(l, m);
  return slots_.is_tie(slot(l, m)) || (p > 0 && slots_.is_tie(slot(l, rows_[l][p - 1])));
}

bool CrossingLists::has_wrong_tie(ObjectId l) const {
  const std::vector<ObjectId>& row = rows_[l];
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    if (slots_.is_tie(slot(l, row[i])) && !goes_first(l, row[i], row[i + 1])) return true;
  }
  return false;
}

bool CrossingLists::is_at_end(ObjectId l, ObjectId m) const {
  const std::size_t p = place(l, m);
  return p + 1 == rows_[l].size() || rows_[l][p - 1] == l;
}

// ---- one list

void CrossingLists::note(ObjectId l) { before_.try_emplace(l, rows_[l]); }

void CrossingLists::note_tie(ObjectId l) {
  any_ties_ = true;
  if (tied_lines_.empty() || tied_lines_.back() != l) tied_lines_.push_back(l);
}

void CrossingLists::renumber(ObjectId l, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) {
    places_[at(l, rows_[l][i])] = static_cast<std::uint32_t>(i);
  }
}

void CrossingLists::drop(ObjectId l) {
  for (const ObjectId m : rows_[l]) slots_.drop(slot(l, m));
}

void CrossingLists::loosen(ObjectId l) {
  if (loose_[l]) return;
  note(l);
  drop(l);
  loose_[l] = true;
  loose_lines_.push_back(l);
}

void CrossingLists::sort(ObjectId l) {
  merge_sort(rows_[l], [this, l](ObjectId m, ObjectId k) { return before(l, m, k); });
  renumber(l, 0, rows_[l].size());
  for (std::size_t i = 0; i < rows_[l].size(); ++i) certify(l, i);
}

void CrossingLists::certify(ObjectId l, std::size_t place) {
  const std::vector<ObjectId>& row = rows_[l];
  const ObjectId m = row[place];
  if (place + 1 == row.size() || !crosses(l, m)) {
    slots_.drop(slot(l, m));
  } else if (slots_.set(slot(l, m), claim(l, m, row[place + 1]), tag(l, m)) ==
             Outlook::kIdenticallyZero) {
    note_tie(l);
  }
}

void CrossingLists::take_out(ObjectId l, ObjectId m) {
  std::vector<ObjectId>& row = rows_[l];
  const std::size_t p = place(l, m);
  slots_.drop(slot(l, m));
  row.erase(row.begin() + static_cast<std::ptrdiff_t>(p));
  places_[at(l, m)] = kNowhere;
  renumber(l, p, row.size());
  if (p > 0) certify(l, p - 1);
}

void CrossingLists::put_in(ObjectId l, ObjectId m, std::size_t place) {
  std::vector<ObjectId>& row = rows_[l];
  row.insert(row.begin() + static_cast<std::ptrdiff_t>(place), m);
  renumber(l, place, row.size());
  if (place > 0) certify(l, place - 1);
  certify(l, place);
}

void CrossingLists::to_other_end(ObjectId l, ObjectId m) {
  const bool was_last = place(l, m) + 1 == rows_[l].size();
  take_out(l, m);
  put_in(l, m, was_last ? place(l, l) + 1 : rows_[l].size());
}

// ---- what the owner reports

void CrossingLists::build(std::span<const ObjectId> lines) {
  for (const ObjectId l : lines_) {
    drop(l);
    for (const ObjectId m : rows_[l]) places_[at(l, m)] = kNowhere;
    rows_[l].clear();
    loose_[l] = false;
  }
  loose_lines_.clear();
  lines_.assign(lines.begin(), lines.end());
  for (const ObjectId l : lines_) {
    for (const ObjectId m : lines_) {
      if (l < m) set_side(l, m, side_now(l, m));
    }
  }
  for (const ObjectId l : lines_) {
    rows_[l] = lines_;
    sort(l);
  }
  tied_lines_.clear();
  forget();
}

void CrossingLists::insert(ObjectId line) {
  for (const ObjectId k : lines_) set_side(line, k, side_now(line, k));
  for (const ObjectId k : lines_) {
    std::size_t low = 0, high = rows_[k].size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (before(k, rows_[k][middle], line)) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    put_in(k, line, low);
  }
  lines_.insert(std::lower_bound(lines_.begin(), lines_.end(), line), line);
  rows_[line] = lines_;
  sort(line);
  settle();
  forget();
}

void CrossingLists::erase(ObjectId line) {
  lines_.erase(std::lower_bound(lines_.begin(), lines_.end(), line));
  drop(line);
  for (const ObjectId m : rows_[line]) places_[at(line, m)] = kNowhere;
  rows_[line].clear();
  for (const ObjectId k : lines_) take_out(k, line);
  settle();
  forget();
}

// The certificate between the two comes first: the arithmetic reuses its polynomial.
CrossingLists::Swap CrossingLists::failed(CertificateId c) {
  const std::uint32_t tag = slots_.failed(c);
  const ObjectId l = numbers_.line(tag / numbers_.count()),
                 m = numbers_.line(tag % numbers_.count());
  const std::size_t p = place(l, m);
  std::vector<ObjectId>& row = rows_[l];
  const ObjectId k = row[p + 1];
  note(l);
  std::swap(slot(l, m), slot(l, k));
  std::swap(row[p], row[p + 1]);
  renumber(l, p, p + 2);
  certify(l, p);
  if (p > 0) certify(l, p - 1);
  certify(l, p + 1);
  return {l, m, k};
}

void CrossingLists::turn(ObjectId l, ObjectId m, bool alone) {
  if (side(l, m) == -1) return;  // seen when the motion changed
  note(l);
  note(m);
  alone = alone && !any_ties_ && !loose_[l] && !loose_[m] && is_at_end(l, m) && is_at_end(m, l);
  set_side(l, m, -1);
  if (!alone) return loosen_both(l, m);
  to_other_end(l, m);
  to_other_end(m, l);
}

void CrossingLists::loosen_both(ObjectId l, ObjectId m) {
  loosen(l);
  loosen(m);
  // The order of lines that meet identically depends on their slopes.
  for (const ObjectId k : lines_) {
    if (k != l && k != m && !loose_[k] && is_tied(k, l) && is_tied(k, m)) note_tie(k);
  }
}

void CrossingLists::motions_changed(std::span<const ObjectId> objects) {
  for (const ObjectId l : objects) {
    for (const ObjectId m : lines_) {
      if (m == l) continue;
      const int side = side_now(l, m), was = this->side(l, m);
      if (side == was) continue;
      reclassified_ = reclassified_ || side == 0 || was == 0;
      set_side(l, m, side);
      loosen_both(l, m);
    }
  }
  each_tie(*kernel_, slots_.structure(), objects, [this](CertificateId c) {
    if (slots_.owns(c)) note_tie(numbers_.line(kernel_->tag(c) / numbers_.count()));
  });
}

void CrossingLists::settle() {
  for (const ObjectId l : std::exchange(tied_lines_, {})) {
    if (!loose_[l] && has_wrong_tie(l)) loosen(l);
  }
  for (const ObjectId l : std::exchange(loose_lines_, {})) {
    loose_[l] = false;
    sort(l);
  }
  tied_lines_.clear();
}

void CrossingLists::forget() {
  before_.clear();
  reclassified_ = false;
}

// ---- for others

void CrossingLists::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "crossings of a line";
  for (const ObjectId l : lines_) {
    group.about = {l};
    visitor.group(group);
    for (const ObjectId m : rows_[l]) {
      if (slot(l, m) != kNoCertificate) visitor.certificate(slot(l, m), "order");
    }
  }
}

void CrossingLists::check(AuditReport& report) const {
  report.check(is_settled() && before_.empty(), [] { return "a list of crossings is not settled"; });
  for (const ObjectId l : lines_) {
    const std::vector<ObjectId>& row = rows_[l];
    const auto where = [l] { return " on line " + std::to_string(l); };
    report.check(row.size() == lines_.size(), [&] { return "another number of lines" + where(); });
    for (std::size_t i = 0; i < row.size(); ++i) {
      const ObjectId m = row[i];
      report.check(place(l, m) == i && (l == m || side(l, m) == -side(m, l)),
                   [&] { return "a lost crossing" + where(); });
      if (i + 1 == row.size() || !crosses(l, m)) {
        report.check(slot(l, m) == kNoCertificate,
                     [&] { return "a certificate too many" + where(); });
        const bool ordered = i + 1 == row.size() || crosses(l, row[i + 1]) ||
                             (m != l && (row[i + 1] == l || m < row[i + 1]));
        report.check(ordered, [&] { return "parallels in the wrong order" + where(); });
        continue;
      }
      const ObjectId k = row[i + 1];
      report.check(crosses(l, k), [&] { return "a parallel behind a crossing" + where(); });
      report.check(slots_.holds(slot(l, m), claim(l, m, k), tag(l, m)),
                   [&] { return "a wrong certificate" + where(); });
      report.check(!slots_.is_tie(slot(l, m)) || goes_first(l, m, k),
                   [&] { return "a tie in the wrong order" + where(); });
    }
  }
}

std::size_t CrossingLists::bytes() const {
  return places_.size() * (sizeof(std::uint32_t) + sizeof(CertificateId) + 1) + numbers_.bytes() +
         rows_.capacity() * sizeof(std::vector<ObjectId>) +
         lines_.size() * lines_.size() * sizeof(ObjectId);
}

}  // namespace kinex
