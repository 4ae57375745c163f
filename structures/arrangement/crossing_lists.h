// SPDX-License-Identifier: GPL-3.0-or-later
// CrossingLists: for every line the list of all others in the order in which it crosses them, from
// left to right. A part of line_arrangement_2, which tells it when slopes change their order.
//
//            m      k                        on l: m, k      certificate "m before k on l"
//         --- \ -- / ------ l
//              \  /                          fails where the three meet; then it fails on m (l before
//               \/                           k) and on k (m before l) as well, and the triangle of the
//               /\                           three turns over
//
// Claims. m is before k on l: an orientation_2 of the three as points (a, b), whose sign depends on
// the order of the slopes of l and m, and of l and k. These are kept, as they were when the owner
// told last. Lines that are parallel identically cross nowhere; they are first in each other's lists,
// by id, without certificates.
//
// Ties. Of the line of the smallest id b is larger by the largest infinitesimal, and so on. So where
// three lines meet identically the smallest id decides whose cofactor in the orientation, the
// difference of the other two slopes, is not zero.
//
// A list may be loose within an instant: it has no certificates until settle() sorts it again.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_CROSSING_LISTS_H
#define KINEX_STRUCTURES_ARRANGEMENT_CROSSING_LISTS_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "structures/parts/slots.h"
#include "structures/parts/ties.h"

namespace kinex {

class CrossingLists {
 public:
  // Two neighbours on a line that have changed places: the one that was in front, and the one that
  // is now.
  struct Swap {
    ObjectId line, before, after;
  };

  // `objects`: of the scene.
  CrossingLists(Kernel& kernel, StructureId id, std::size_t objects);

  bool owns(CertificateId c) const { return slots_.owns(c); }
  // The order of the others on the line, from left to right.
  const std::vector<ObjectId>& order(ObjectId line) const { return rows_[line]; }
  // The lines that exist, ascending.
  const std::vector<ObjectId>& lines() const { return lines_; }

  void clear();
  // O(n log n) comparisons and O(n) certificates.
  void insert(ObjectId line);
  void erase(ObjectId line);
  // The line of a certificate of this part.
  ObjectId line_of(CertificateId c) const { return slots_.kernel().tag(c) / stride_; }
  // A certificate has failed.
  Swap failed(CertificateId c);
  // From now on l is steeper than m, and was not. Nothing else changes at the instant: each goes from
  // one end of the other's list to the other end.
  void pass_at_infinity(ObjectId l, ObjectId m);
  // The same without that. Calls loosened(k) before the list of k becomes loose.
  template <class Loosened>
  void turn(ObjectId l, ObjectId m, const Loosened& loosened) {
    set_side(l, m, -1);
    loosen_both(l, m, loosened);
  }
  // New motions: signs of slopes against all others anew, for each that has changed loosened(k).
  template <class Loosened>
  void motions_changed(std::span<const ObjectId> objects, const Loosened& loosened) {
    for (const ObjectId l : objects) {
      for (const ObjectId m : lines_) {
        if (m == l) continue;
        const int side = side_now(l, m);
        if (side == this->side(l, m)) continue;
        set_side(l, m, side);
        loosen_both(l, m, loosened);
      }
    }
    ties_.note_of(slots_, objects);
    any_ties_ = any_ties_ || !ties_.empty();
  }
  // Puts ties in order: calls tied(swap) for two neighbours that are level identically and change
  // places; changing(line) before.
  template <class Changing, class Tied>
  void settle_ties(const Changing& changing, const Tied& tied) {
    ties_.settle([&](std::uint32_t tag) {
      const ObjectId l = tag / stride_, m = tag % stride_;
      if (loose_[l] || !has(l, m) || !slots_.is_tie(certificate(l, m))) return;
      const ObjectId k = rows_[l][place(l, m) + 1];
      if (goes_first(l, m, k)) return;
      changing(l);
      exchange(l, place(l, m));
      tied(Swap{l, m, k});
    });
  }
  // Three lines have met identically.
  bool any_ties() const { return any_ties_; }
  bool any_loose() const { return !loose_lines_.empty(); }
  // Sorts the loose lists right after now.
  void settle();

  // The sign of (slope of m) - (slope of l): 0 if they are equal identically.
  int side(ObjectId l, ObjectId m) const { return sides_[l * stride_ + m]; }
  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  bool has(ObjectId l, ObjectId m) const { return places_[l * stride_ + m] != kNowhere; }
  std::uint32_t place(ObjectId l, ObjectId m) const { return places_[l * stride_ + m]; }
  // Of m and the one behind it on l.
  CertificateId& certificate(ObjectId l, ObjectId m) { return certificates_[l * stride_ + m]; }
  CertificateId certificate(ObjectId l, ObjectId m) const {
    return certificates_[l * stride_ + m];
  }
  int side_now(ObjectId l, ObjectId m) const;
  void set_side(ObjectId l, ObjectId m, int side) {
    sides_[l * stride_ + m] = static_cast<std::int8_t>(side);
    sides_[m * stride_ + l] = static_cast<std::int8_t>(-side);
  }
  // "m is before k on l"; neither is parallel to l.
  Query claim(ObjectId l, ObjectId m, ObjectId k) const;
  bool goes_first(ObjectId l, ObjectId m, ObjectId k) const;
  bool before(ObjectId l, ObjectId m, ObjectId k) const;
  bool is_tied(ObjectId l, ObjectId m) const;
  template <class Loosened>
  void loosen_both(ObjectId l, ObjectId m, const Loosened& loosened) {
    loosen(l, loosened);
    loosen(m, loosened);
    // The order of level neighbours depends on the slopes.
    for (const ObjectId k : lines_) {
      if (k != l && k != m && !loose_[k] && is_tied(k, l) && is_tied(k, m)) loosen(k, loosened);
    }
  }
  template <class Loosened>
  void loosen(ObjectId l, const Loosened& loosened) {
    if (loose_[l]) return;
    loosened(l);
    drop(l);
    loose_[l] = true;
    loose_lines_.push_back(l);
  }
  void drop(ObjectId l);
  void sort(ObjectId l);
  void renumber(ObjectId l, std::size_t from, std::size_t to);
  // The certificate of the lines at this place of l's list and the next, if there has to be one.
  void certify(ObjectId l, std::size_t at);
  void exchange(ObjectId l, std::size_t at);
  void take_out(ObjectId l, ObjectId m);
  void put_in(ObjectId l, ObjectId m, std::size_t at);
  void to_other_end(ObjectId l, ObjectId m);

  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  Kernel* kernel_;
  PredicateId slope_order_, orientation_;
  Slots slots_;
  Ties ties_;
  std::uint32_t stride_;
  std::vector<ObjectId> lines_;
  std::vector<std::vector<ObjectId>> rows_;  // by line
  std::vector<std::uint32_t> places_;        // by line and line
  std::vector<CertificateId> certificates_;
  std::vector<std::int8_t> sides_;
  std::vector<bool> loose_;  // by line
  std::vector<ObjectId> loose_lines_;
  bool any_ties_ = false;
};

}  // namespace kinex

#endif
