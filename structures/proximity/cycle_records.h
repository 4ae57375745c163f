// SPDX-License-Identifier: GPL-3.0-or-later
// CycleRecords: certificates that edges of a graph are the longest of their cycles.
//
// A cycle belongs to its longest edge, the owner. Each other edge of it, `inside`, has one record: the
// certificate that `inside` is at most as long as `outside`, which is the owner or another edge of the
// cycle, so that all records of an owner together say that it is the longest. Which cycle that is, and
// what a failure means, is up to the structure.
#ifndef KINEX_STRUCTURES_PROXIMITY_CYCLE_RECORDS_H
#define KINEX_STRUCTURES_PROXIMITY_CYCLE_RECORDS_H

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "structures/parts/slots.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class CycleRecords {
 public:
  using Place = std::uint32_t;  // of a record; the tag of its certificate
  // The certificate that `inside` is at most as long as `outside`, both in the cycle of `owner`.
  struct Record {
    Item inside = kNoItem, outside = kNoItem, owner = kNoItem;
    CertificateId certificate = kNoCertificate;
    std::uint32_t at_inside = 0, at_owner = 0;  // its places in the lists of the two
    bool is_waiting = false;                    // for a certificate
  };

  // `edges` outlives this part.
  CycleRecords(Kernel& kernel, StructureId structure, const TreeEdges& edges)
      : slots_(kernel, structure, "cycles"), edges_(&edges) {}

  const Record& operator[](Place place) const { return records_[place]; }
  // The records of the cycle of an edge, and those whose inside it is: in no particular, but
  // reproducible, order. Valid until a record comes, goes or changes.
  std::span<const Place> cycle(Item owner) const { return cycles_[owner]; }
  std::span<const Place> uses(Item inside) const { return uses_[inside]; }
  std::size_t size() const { return records_.size() - free_.size(); }

  // All numbers of edges are less than `items`.
  void make_room(std::size_t items);
  void add(Item inside, Item outside, Item owner);
  // The record has these edges from now on.
  void change(Place place, Item inside, Item outside);
  void drop(Place place);
  void drop_cycle(Item owner);
  // Each of two edges owns the records that the other one had; they stay what they are.
  void exchange_cycles(Item a, Item b);
  // All of them.
  void clear();

  // ---- certificates
  // Makes those of the records that have come or changed since the last call. So a record that changes
  // twice, or goes again, costs none, and the certificates of records that have gone are replaced.
  void certify();
  // The kernel has retracted all certificates of the structure: none is made any more.
  void give_up() {
    waiting_.clear();
    spare_.clear();
    tied_.clear();
    failing_.clear();
  }
  bool owns(CertificateId certificate) const { return slots_.owns(certificate); }
  // A certificate of this part has failed. Returns its record, which is to be changed or dropped.
  Place failed(CertificateId certificate) { return slots_.failed(certificate); }
  // A record that ties in the wrong order: `outside` goes first. Each is returned once; nullopt: there
  // is no other one among those made since the last call, and those noted. Certifies.
  std::optional<Place> next_tie();
  // A record made since the last call, or since forget_failing, that fails right after now. Certifies.
  std::optional<Place> next_failing();
  // Certifies, and leaves what fails now to fail next.
  void forget_failing() {
    certify();
    failing_.clear();
  }
  // New motions: notes the ties among the certificates of these objects.
  void note_ties(std::span<const ObjectId> objects);
  // The claims about these edges may be others now: makes their certificates anew where they are.
  void renew(std::span<const Item> items);

  // Each record of the cycle holds its claim, and ties in the right order.
  void check(Item owner, AuditReport& report) const;
  // Every certificate belongs to a record.
  void check_all(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  using Lists = std::vector<std::vector<Place>>;

  static std::uint32_t list(Lists& lists, Item item, Place place);
  void unlist_inside(const Record& record);
  void wait(Place place);
  void renew(Place place);

  Slots slots_;
  const TreeEdges* edges_;
  std::vector<Record> records_;
  std::vector<Place> free_;
  Lists cycles_, uses_;  // by item
  std::vector<Place> waiting_;        // for certificates, and some that are not
  std::vector<CertificateId> spare_;  // certificates of no record
  // Records whose certificates were identically zero, or negative right after now, when they were
  // made. They may have changed since.
  std::vector<Place> tied_, failing_;
};

}  // namespace kinex

#endif
