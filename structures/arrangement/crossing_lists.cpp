// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/crossing_lists.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "predicates/predicates.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

CrossingLists::CrossingLists(Kernel& kernel, StructureId id, std::size_t objects)
    : kernel_(&kernel),
      slope_order_(kernel.bind(make_coordinate_order(0))),
      orientation_(kernel.bind(make_orientation_2())),
      slots_(kernel, id, "crossings"),
      stride_(static_cast<std::uint32_t>(objects)),
      rows_(objects),
      places_(objects * objects, kNowhere),
      certificates_(objects * objects, kNoCertificate),
      sides_(objects * objects),
      loose_(objects) {}

void CrossingLists::clear() {
  for (const ObjectId l : lines_) {
    drop(l);
    for (const ObjectId m : rows_[l]) places_[l * stride_ + m] = kNowhere;
    rows_[l].clear();
    loose_[l] = false;
  }
  lines_.clear();
  loose_lines_.clear();
  ties_.clear();
}

int CrossingLists::side_now(ObjectId l, ObjectId m) const {
  const Sign sign = kernel_->sign_after({slope_order_, {l, m}});
  return sign == Sign::kPositive ? 1 : sign == Sign::kNegative ? -1 : 0;
}

// x of the crossing with m is -(b_m - b_l) / (a_m - a_l): multiplied by both denominators.
Query CrossingLists::claim(ObjectId l, ObjectId m, ObjectId k) const {
  return side(l, m) == side(l, k) ? Query(orientation_, {l, k, m}) : Query(orientation_, {l, m, k});
}

// orientation(l, x, y) = b_l (a_y - a_x) + b_x (a_l - a_y) + b_y (a_x - a_l).
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
  const bool m_crosses = side(l, m) != 0, k_crosses = side(l, k) != 0;
  if (!m_crosses || !k_crosses) return m_crosses == k_crosses ? m < k : !m_crosses;
  const Sign sign = kernel_->sign_after(claim(l, m, k));
  return sign == Sign::kPositive || (sign == Sign::kZero && goes_first(l, m, k));
}

bool CrossingLists::is_tied(ObjectId l, ObjectId m) const {
  const std::size_t at = place(l, m);
  return slots_.is_tie(certificate(l, m)) ||
         (at > 0 && slots_.is_tie(certificate(l, rows_[l][at - 1])));
}

void CrossingLists::renumber(ObjectId l, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) {
    places_[l * stride_ + rows_[l][i]] = static_cast<std::uint32_t>(i);
  }
}

void CrossingLists::drop(ObjectId l) {
  for (const ObjectId m : rows_[l]) slots_.drop(certificate(l, m));
}

void CrossingLists::sort(ObjectId l) {
  merge_sort(rows_[l], [this, l](ObjectId m, ObjectId k) { return before(l, m, k); });
  renumber(l, 0, rows_[l].size());
  for (std::size_t i = 0; i < rows_[l].size(); ++i) certify(l, i);
}

void CrossingLists::certify(ObjectId l, std::size_t at) {
  const std::vector<ObjectId>& row = rows_[l];
  const ObjectId m = row[at];
  if (at + 1 == row.size() || side(l, m) == 0) {
    slots_.drop(certificate(l, m));
  } else {
    ties_.set(slots_, certificate(l, m), claim(l, m, row[at + 1]), l * stride_ + m);
    any_ties_ = any_ties_ || slots_.is_tie(certificate(l, m));
  }
}

// The certificate between the two comes first: the arithmetic reuses its polynomial.
void CrossingLists::exchange(ObjectId l, std::size_t at) {
  std::vector<ObjectId>& row = rows_[l];
  std::swap(certificate(l, row[at]), certificate(l, row[at + 1]));
  std::swap(row[at], row[at + 1]);
  renumber(l, at, at + 2);
  certify(l, at);
  if (at > 0) certify(l, at - 1);
  certify(l, at + 1);
}

CrossingLists::Swap CrossingLists::failed(CertificateId c) {
  const std::uint32_t tag = slots_.failed(c);
  const ObjectId l = tag / stride_, m = tag % stride_;
  const std::size_t at = place(l, m);
  exchange(l, at);
  return {l, m, rows_[l][at]};
}

void CrossingLists::take_out(ObjectId l, ObjectId m) {
  std::vector<ObjectId>& row = rows_[l];
  const std::size_t at = place(l, m);
  slots_.drop(certificate(l, m));
  row.erase(row.begin() + static_cast<std::ptrdiff_t>(at));
  places_[l * stride_ + m] = kNowhere;
  renumber(l, at, row.size());
  if (at > 0) certify(l, at - 1);
}

void CrossingLists::put_in(ObjectId l, ObjectId m, std::size_t at) {
  std::vector<ObjectId>& row = rows_[l];
  row.insert(row.begin() + static_cast<std::ptrdiff_t>(at), m);
  renumber(l, at, row.size());
  if (at > 0) certify(l, at - 1);
  certify(l, at);
}

// Behind the parallels, or at the end.
void CrossingLists::to_other_end(ObjectId l, ObjectId m) {
  const bool was_last = place(l, m) + std::size_t{1} == rows_[l].size();
  take_out(l, m);
  std::size_t first = 0;
  while (first < rows_[l].size() && side(l, rows_[l][first]) == 0) ++first;
  put_in(l, m, was_last ? first : rows_[l].size());
}

void CrossingLists::pass_at_infinity(ObjectId l, ObjectId m) {
  set_side(l, m, -1);
  to_other_end(l, m);
  to_other_end(m, l);
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
  rows_[line] = lines_;
  sort(line);
  lines_.insert(std::lower_bound(lines_.begin(), lines_.end(), line), line);
}

void CrossingLists::erase(ObjectId line) {
  lines_.erase(std::lower_bound(lines_.begin(), lines_.end(), line));
  drop(line);
  for (const ObjectId m : rows_[line]) places_[line * stride_ + m] = kNowhere;
  rows_[line].clear();
  for (const ObjectId k : lines_) take_out(k, line);
}

void CrossingLists::settle() {
  for (const ObjectId l : std::exchange(loose_lines_, {})) {
    loose_[l] = false;
    sort(l);
  }
}

void CrossingLists::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "crossings of a line";
  for (const ObjectId l : lines_) {
    group.about = {l};
    visitor.group(group);
    for (const ObjectId m : rows_[l]) {
      if (certificate(l, m) != kNoCertificate) visitor.certificate(certificate(l, m), "order");
    }
  }
}

void CrossingLists::check(AuditReport& report) const {
  report.check(loose_lines_.empty() && ties_.empty(), [] { return "a list was not settled"; });
  for (const ObjectId l : lines_) {
    const std::vector<ObjectId>& row = rows_[l];
    const auto name = [l] { return " on line " + std::to_string(l); };
    report.check(row.size() + 1 == lines_.size(), [&] { return "another number of lines" + name(); });
    for (std::size_t i = 0; i < row.size(); ++i) {
      const ObjectId m = row[i];
      report.check(m != l && place(l, m) == i && side(l, m) == -side(m, l),
                   [&] { return "a lost crossing" + name(); });
      if (i + 1 == row.size() || side(l, m) == 0) {
        report.check(certificate(l, m) == kNoCertificate,
                     [&] { return "a certificate too many" + name(); });
        continue;
      }
      const ObjectId k = row[i + 1];
      report.check(side(l, k) != 0, [&] { return "a parallel behind a crossing" + name(); });
      report.check(slots_.holds(certificate(l, m), claim(l, m, k), l * stride_ + m),
                   [&] { return "a wrong certificate" + name(); });
      report.check(!slots_.is_tie(certificate(l, m)) || goes_first(l, m, k),
                   [&] { return "a tie in the wrong order" + name(); });
    }
  }
}

std::size_t CrossingLists::bytes() const {
  const std::size_t n = stride_;
  return n * n * (2 * sizeof(std::uint32_t) + 1) + lines_.size() * lines_.size() * sizeof(ObjectId) +
         ties_.bytes();
}

}  // namespace kinex
