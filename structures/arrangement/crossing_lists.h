// SPDX-License-Identifier: GPL-3.0-or-later
// CrossingLists: for every line the list of all lines in the order in which it crosses them, from
// left to right. A part of line_arrangement_2, which reports it every change in the order of slopes.
//
//            m      k                        on l: m, k      certificate "m before k on l"
//         --- \ -- / ------ l
//              \  /                          fails where the three meet; then it fails on m (l before
//               \/                           k) and on k (m before l) as well, and the triangle of the
//               /\                           three turns over
//
// A list begins with the lines that are parallel to its own line identically, by id; then comes the
// line itself; then those that it crosses.
//
// Certificates. One per pair of neighbours among the crossings of a line: an orientation_2 of the
// three lines as points (a, b). Its sign depends on the order of the slopes of l and m, and of l and
// k; these are kept as they were last reported.
//
// Where two lines become parallel each goes from one end of the other's crossings to the other end.
// If anything else happens at the instant their lists are loose: without certificates until settle()
// sorts them again.
//
// Ties. Of the line of the smallest id b is larger by the largest infinitesimal, and so on. So where
// three lines meet identically the smallest id decides whose cofactor in the orientation, the
// difference of the other two slopes, is not zero. A list in which such a tie arises is checked by
// settle().
#ifndef KINEX_STRUCTURES_ARRANGEMENT_CROSSING_LISTS_H
#define KINEX_STRUCTURES_ARRANGEMENT_CROSSING_LISTS_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "structures/arrangement/line_numbers.h"
#include "structures/arrangement/order_changes.h"
#include "structures/parts/slots.h"

namespace kinex {

class CrossingLists {
 public:
  // Two neighbours on a line that have changed places: the one that was in front, and the one that
  // is now.
  struct Swap {
    ObjectId line, before, after;
  };

  // `is_line`: by object, the lines that may be there.
  CrossingLists(Kernel& kernel, StructureId id, const std::vector<bool>& is_line);

  bool owns(CertificateId c) const { return slots_.owns(c); }
  // Of the lines that may be there.
  const LineNumbers& numbers() const { return numbers_; }
  // The lines that exist, ascending.
  const std::vector<ObjectId>& lines() const { return lines_; }
  const std::vector<ObjectId>& order(ObjectId line) const { return rows_[line]; }
  // The place of `other` in the list of `line`; both exist.
  std::size_t place(ObjectId line, ObjectId other) const { return places_[at(line, other)]; }
  // The sign of (slope of m) - (slope of l): 0 if they are equal identically.
  int side(ObjectId l, ObjectId m) const { return sides_[at(l, m)]; }

  // O(n^2 log n) comparisons.
  void build(std::span<const ObjectId> lines);
  // O(n log n) comparisons, O(n) certificates, O(n^2) time.
  void insert(ObjectId line);
  void erase(ObjectId line);
  // A certificate of this part has failed. O(1) beside 3 certificates.
  Swap failed(CertificateId c);
  // From now on l is steeper than m, and was not. `alone`: no other claim of the arrangement fails
  // at this instant. O(n) then; otherwise the lists of both are loose.
  void turn(ObjectId l, ObjectId m, bool alone);
  // New motions of these lines. O(n) comparisons for each.
  void motions_changed(std::span<const ObjectId> objects);
  // Sorts the lists that are loose and those with a tie in the wrong order, right after now.
  void settle();
  bool is_settled() const { return loose_lines_.empty() && tied_lines_.empty(); }

  // The lists that have changed since forget(), as they were then; some may be what they were.
  const LineOrders& before() const { return before_; }
  // True if two lines have become identically parallel since then, or have ceased to be.
  bool reclassified() const { return reclassified_; }
  void forget();

  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  std::size_t at(ObjectId l, ObjectId m) const {
    return std::size_t{numbers_[l]} * numbers_.count() + numbers_[m];
  }
  bool crosses(ObjectId l, ObjectId m) const { return l != m && side(l, m) != 0; }
  int side_now(ObjectId l, ObjectId m) const;
  void set_side(ObjectId l, ObjectId m, int side);
  // "m is before k on l", which crosses both.
  Query claim(ObjectId l, ObjectId m, ObjectId k) const;
  bool goes_first(ObjectId l, ObjectId m, ObjectId k) const;
  bool before(ObjectId l, ObjectId m, ObjectId k) const;
  // The slot of the claim about m and the next line on l.
  CertificateId& slot(ObjectId l, ObjectId m) { return certificates_[at(l, m)]; }
  CertificateId slot(ObjectId l, ObjectId m) const { return certificates_[at(l, m)]; }
  std::uint32_t tag(ObjectId l, ObjectId m) const { return static_cast<std::uint32_t>(at(l, m)); }
  bool is_tied(ObjectId l, ObjectId m) const;
  bool has_wrong_tie(ObjectId l) const;
  bool is_at_end(ObjectId l, ObjectId m) const;

  void note(ObjectId l);       // the list of l is about to change
  void note_tie(ObjectId l);   // it has a new tie
  void renumber(ObjectId l, std::size_t from, std::size_t to);
  void drop(ObjectId l);       // its certificates
  void loosen(ObjectId l);
  void loosen_both(ObjectId l, ObjectId m);
  void sort(ObjectId l);
  void certify(ObjectId l, std::size_t place);  // the claim about the lines there and behind
  void take_out(ObjectId l, ObjectId m);
  void put_in(ObjectId l, ObjectId m, std::size_t place);
  void to_other_end(ObjectId l, ObjectId m);

  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  Kernel* kernel_;
  PredicateId slope_order_, orientation_;
  Slots slots_;
  LineNumbers numbers_;
  std::vector<ObjectId> lines_;
  std::vector<std::vector<ObjectId>> rows_;  // by line
  std::vector<std::uint32_t> places_;        // by line and line, as the next two
  std::vector<CertificateId> certificates_;
  std::vector<std::int8_t> sides_;
  std::vector<bool> loose_;  // by line
  std::vector<ObjectId> loose_lines_, tied_lines_;
  bool any_ties_ = false;  // three lines have met identically
  LineOrders before_;
  bool reclassified_ = false;
};

}  // namespace kinex

#endif
