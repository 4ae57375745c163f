// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: hidden points and their witnesses.
#include <algorithm>

#include "structures/parts/sort_unique.h"
#include "structures/triangulation/regular_2.h"

namespace kinex {

Query Regular2::witness_query(ObjectId h, unsigned i) const {
  const Corners& c = witness_[h].corners;
  if (i == 3) return geometry_.power_claim(c, h);
  return geometry_.orientation_claim(c[i], c[(i + 1) % 3], h);
}

// Requires that h is in the finite triangle t, and not in conflict with it.
void Regular2::set_witness(ObjectId h, Triangle t) {
  Witness& witness = witness_[h];
  witness.corners = store_.corners(t);
  for (const unsigned i : {3u, 0u, 1u, 2u}) {  // the power first: it may be a failed one, negated
    if (corrupt_) return;
    witnesses_.set(witness.certificates[i], witness_query(h, i), h);
  }
}

void Regular2::drop_witness(ObjectId h) {
  for (CertificateId& slot : witness_[h].certificates) {
    if (!corrupt_) witnesses_.drop(slot);
    slot = kNoCertificate;
  }
  witness_[h].corners = {kNoObject, kNoObject, kNoObject};
}

// h goes without a witness until the instant is settled.
void Regular2::wait(ObjectId h) {
  drop_witness(h);
  waiting_.push_back(h);
  kernel_->settle_later(id_);
}

Regular2::Triangle Regular2::hint() const {
  if (hint_ != kNone && hint_ < store_.triangle_capacity() && store_.live(hint_)) return hint_;
  return Triangulation2::triangle(store_.out(store_.infinity()));
}

// From a corner of its last witness that is still a vertex.
Regular2::Triangle Regular2::locate_hidden(ObjectId h) const {
  for (const ObjectId v : witness_[h].corners) {
    if (v == kNoObject || !store_.has(v)) continue;
    return locate(geometry_, store_, h, Triangulation2::triangle(store_.out(v)));
  }
  return locate(geometry_, store_, h, hint());
}

// One failure at an instant: the triangulation of the vertices is right, and h is located in it. Where
// more fails, the triangulation is repaired first.
void Regular2::witness_failed(ObjectId h) {
  const bool shared = kernel_->instant_is_shared(id_);
  const Triangle t = shared ? kNone : locate_hidden(h);
  const bool conflict = t != kNone && geometry_.conflict(store_, t, h);
  if (t != kNone && !conflict) {
    set_witness(h, t);
  } else if (conflict && show(h, t)) {
    return;
  } else {
    ++waits_;
    wait(h);
  }
  kernel_->report(id_, kWitness, {h}, false);
}

// h becomes a vertex in the triangle t, which may be a ghost. False, with nothing changed, if it is in
// conflict with others, too, or on an edge.
bool Regular2::show(ObjectId h, Triangle t) {
  find_conflicts(geometry_, store_, h, t, conflicts_);
  if (conflicts_.cells.size() != 1) return false;
  for (const Corners& corners : conflicts_.star) {
    if (!geometry_.upright(corners)) return false;
  }
  Corners old = store_.corners(t);
  std::sort(old.begin(), old.end());
  if (!store_.replace(conflicts_.cells, conflicts_.star, fresh_)) return false;
  hint_ = fresh_.front();
  note_change({h, old[0], old[1], old[2]});
  for (const Triangle f : fresh_) set_certificate(3 * f + 1);  // first: one is the failed one, negated
  drop_witness(h);
  const std::uint64_t zeros = kernel_->possible_zeros();
  const std::array<HalfEdge, 3> rim{3 * fresh_[0], 3 * fresh_[1], 3 * fresh_[2]};
  for (const HalfEdge side : rim) set_certificate(side);
  after_change(rim, zeros);
  if (corrupt_) return true;
  if (old[2] == store_.infinity()) {
    kernel_->report(id_, kShow, {h, old[0], old[1]}, true);
  } else {
    kernel_->report(id_, kShow, {h, old[0], old[1], old[2]}, true);
  }
  return true;
}

// Gives a witness to every hidden point that waits for one, or makes it a vertex, which may hide
// others. Witnesses that hold identically are looked at again after new motions: the ties decide.
void Regular2::settle_hidden() {
  witness_ties_.settle([this](ObjectId h) {
    const Witness& witness = witness_[h];
    const bool tied = std::any_of(witness.certificates.begin(), witness.certificates.end(),
                                  [this](CertificateId c) { return witnesses_.is_tie(c); });
    if (tied) wait(h);
  });
  std::vector<ObjectId> round;
  for (std::uint32_t rounds = 0; !waiting_.empty() && !corrupt_ && !flat_; ++rounds) {
    if (!kernel_->is_exact() && rounds > kMostSews) {
      return give_up("no end of points that hide each other");
    }
    round.swap(waiting_);
    waiting_.clear();
    sort_unique(round);
    for (const ObjectId h : round) {
      if (corrupt_ || flat_) break;
      const bool settled = !present_[h] || store_.has(h) || witness_[h].corners[0] != kNoObject;
      if (!settled) put_in(h);
    }
  }
}

}  // namespace kinex
