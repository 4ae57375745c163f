// SPDX-License-Identifier: GPL-3.0-or-later
// Kernel: the counts of live certificates, of a structure and of every object.
#include <algorithm>
#include <bit>
#include <cstring>

#include "core/engine/kernel.h"

namespace kinex {
namespace {

// The places k with from[k] in none of the four places of `in`: bit k.
unsigned places_missing(const ObjectId* from, const ObjectId* in) {
  typedef ObjectId Four __attribute__((vector_size(16)));
  Four a, b;
  std::memcpy(&a, from, sizeof(a));
  std::memcpy(&b, in, sizeof(b));
  const auto missing = (a != b) & (a != __builtin_shufflevector(b, b, 1, 2, 3, 0)) &
                       (a != __builtin_shufflevector(b, b, 2, 3, 0, 1)) &
                       (a != __builtin_shufflevector(b, b, 3, 0, 1, 2));
  const auto bits = missing & decltype(missing){1, 2, 4, 8};
  return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
}

// Three certificates of two objects as they change when two neighbours a and b of a list change places:
//
//     a b,  z a,  b y    become    b a,  z b,  a y
//
// Each object is in as many as before.
bool exchanges_neighbours(const StoredQuery* const* before, const Query* after) {
  const ObjectId a = before[0]->ids[0], b = before[0]->ids[1];
  const ObjectId differ = (after[0].ids[0] ^ b) | (after[0].ids[1] ^ a) |
                          (before[1]->ids[0] ^ after[1].ids[0]) | (before[1]->ids[1] ^ a) |
                          (after[1].ids[1] ^ b) | (before[2]->ids[0] ^ b) | (after[2].ids[0] ^ a) |
                          (before[2]->ids[1] ^ after[2].ids[1]);
  return differ == 0;
}

}  // namespace

std::span<const ObjectId> Kernel::objects_of(const Query& query) {
  // Of most queries one argument stands for all: its list is the answer.
  std::size_t stand = 0, last = 0;
  for (std::size_t i = 0; i < query.arity; ++i) {
    if (derived_.is_constant(query.ids[i])) continue;
    ++stand;
    last = i;
  }
  if (stand == 0) return {};
  if (stand == 1 && derived_.is_derived(query.ids[last])) {
    return derived_.object(query.ids[last]).stands_for;
  }
  std::vector<ObjectId>& all = objects_of_query_;
  all.clear();
  for (std::size_t i = 0; i < query.arity; ++i) {
    if (!derived_.is_derived(query.ids[i])) {
      all.push_back(query.ids[i]);
      continue;
    }
    const std::vector<ObjectId>& more = derived_.object(query.ids[i]).stands_for;
    all.insert(all.end(), more.begin(), more.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void Kernel::note_live(StructureId structure, ObjectId object) {
  StructureLedger& ledger = *ledgers_[structure];
  if (ledger.live > ledger.max_live) ledger.max_live = ledger.live;
  const std::uint32_t live = live_per_object_[structure][object];
  if (live > ledger.max_per_object) ledger.max_per_object = live;
}

void Kernel::count_created(StructureId structure, const Query& query) {
  StructureLedger& ledger = *ledgers_[structure];
  ++ledger.certificates_created;
  const bool most_of_all = ++ledger.live > ledger.max_live;
  const std::uint64_t most = ledger.max_per_object;
  std::uint32_t* const live = live_per_object_[structure].data();
  each_object(query, [&](ObjectId object) {
    if (++live[object] > most || most_of_all) [[unlikely]] note_or_defer(structure, object);
  });
}

void Kernel::count_retracted(const Certificate& certificate) {
  StructureLedger& ledger = *ledgers_[certificate.structure];
  ++ledger.certificates_retracted;
  --ledger.live;
  std::uint32_t* const live = live_per_object_[certificate.structure].data();
  const StoredQuery& stored = certificate.stored;
  if (derived_.size() == 0 && !stored.is_long()) {
    for (std::size_t i = 0; i < stored.arity; ++i) --live[stored.ids[i]];
  } else {
    each_object(queue_.query(certificate), [live](ObjectId object) { --live[object]; });
  }
}

// Most objects of a certificate of two stay and need no counting.
void Kernel::count_replaced(const Certificate& certificate, const Query& after) {
  const StructureId structure = certificate.structure;
  const StoredQuery& before = certificate.stored;
  if (before.arity != 2 || after.arity != 2 || derived_.size() > 0) {
    count_retracted(certificate);
    count_created(structure, after);
    return;
  }
  StructureLedger& ledger = *ledgers_[structure];
  ++ledger.certificates_created;
  ++ledger.certificates_retracted;
  const bool most_of_all = ledger.live > ledger.max_live;
  std::uint32_t* const live = live_per_object_[structure].data();
  for (const std::size_t i : {0u, 1u}) {
    const ObjectId gone = before.ids[i], come = after.ids[i];
    if (gone != after.ids[0] && gone != after.ids[1]) --live[gone];
    if (come != before.ids[0] && come != before.ids[1]) {
      if (++live[come] > ledger.max_per_object || most_of_all) [[unlikely]] {
        note_or_defer(structure, come);
      }
    }
  }
}

// Counts a group as one by one, if nothing can be refused and the largest numbers are taken later: most
// objects stay and need no counting. False, with nothing counted: it has to be done one by one.
bool Kernel::count_together(const Group& group) {
  const StructureId structure = queue_.certificate(group.ids[0]).structure;
  const StructureLedger& ledger = *ledgers_[structure];
  if (!deferred_ || derived_.size() > 0 || ledger.live > ledger.max_live) return false;
  switch (group.queries[0].arity) {
    case 2: return count_together<2>(group, structure);
    case 4: return count_together<4>(group, structure);
    default: return false;
  }
}

template <std::size_t kArguments>
bool Kernel::count_together(const Group& group, StructureId structure) {
  bool fit = true;
  std::array<const StoredQuery*, Group::kMost> stored;
  for (std::size_t i = 0; i < group.size; ++i) {
    const Certificate& c = queue_.certificate(group.ids[i]);
    stored[i] = &c.stored;
    const Query& query = group.queries[i];
    const bool repeats =
        kArguments == 2 ? query.ids[0] == query.ids[1] : repeats_an_object(query);
    fit = fit & c.live & (c.structure == structure) & (c.stored.arity == kArguments) &
          (query.arity == kArguments) & !repeats;
    for (std::size_t k = 0; k < i; ++k) fit = fit & (group.ids[k] != group.ids[i]);
  }
  if (!fit) return false;
  StructureLedger& ledger = *ledgers_[structure];
  std::uint32_t* const live = live_per_object_[structure].data();
  const auto come = [&](ObjectId object) {
    if (++live[object] > ledger.max_per_object) [[unlikely]] note_or_defer(structure, object);
  };
  if (kArguments == 2 && group.size == 3 &&
      exchanges_neighbours(stored.data(), group.queries.data())) {
    // No count changes.
  } else if constexpr (kArguments == 2) {  // those that leave before those that come: most do both
    for (std::size_t i = 0; i < group.size; ++i) {
      --live[stored[i]->ids[0]];
      --live[stored[i]->ids[1]];
    }
    for (std::size_t i = 0; i < group.size; ++i) {
      come(group.queries[i].ids[0]);
      come(group.queries[i].ids[1]);
    }
  } else {
    for (std::size_t i = 0; i < group.size; ++i) {
      const ObjectId* const before = stored[i]->ids.data();
      const ObjectId* const after = group.queries[i].ids.data();
      for (unsigned gone = places_missing(before, after); gone != 0; gone &= gone - 1) {
        --live[before[std::countr_zero(gone)]];
      }
      for (unsigned places = places_missing(after, before); places != 0; places &= places - 1) {
        come(after[std::countr_zero(places)]);
      }
    }
  }
  ledger.certificates_created += group.size;
  ledger.certificates_retracted += group.size;
  return true;
}

}  // namespace kinex
