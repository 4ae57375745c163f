// SPDX-License-Identifier: GPL-3.0-or-later
// CycleRecords: certificates that edges of a graph are the longest of their cycles.
//
// A record (inside, outside) is the certificate "edge `inside` is at most as long as edge `outside`".
// All records of one edge outside the tree prove that it is the longest of a cycle: their insides are
// the other edges of that cycle. Which cycle that is, and what a failure means, is the owner's affair.
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

  struct Record {
    Item inside = kNoItem, outside = kNoItem;
    CertificateId certificate = kNoCertificate;
    std::uint32_t at_inside = 0, at_outside = 0;  // its places in the lists of the two
  };

  // `edges` outlives this part.
  CycleRecords(Kernel& kernel, StructureId structure, const TreeEdges& edges)
      : slots_(kernel, structure, "cycles"), edges_(&edges) {}

  const Record& operator[](Place place) const { return records_[place]; }
  // The records that name an edge, in no particular, but reproducible, order. Valid until a record
  // comes, goes or changes.
  std::span<const Place> of(Item item) const { return places_[item]; }
  std::size_t size() const { return records_.size() - free_.size(); }

  // Numbers of edges are below.
  void make_room(std::size_t items);
  void add(Item inside, Item outside);
  // The record becomes another one, with a certificate made anew.
  void change(Place place, Item inside, Item outside);
  void drop(Place place);
  // All records that name an edge.
  void drop_all(Item item);
  // All of them.
  void clear();

  // ---- certificates
  bool owns(CertificateId certificate) const { return slots_.owns(certificate); }
  // A certificate of this part has failed. Returns its record, which is to be changed or dropped.
  Place failed(CertificateId certificate) { return slots_.failed(certificate); }
  // A record that ties in the wrong order: `outside` goes first. Each is returned once; nullopt: there
  // is no other one among those made since the last call, and those noted.
  std::optional<Place> next_tie();
  // A record made since the last call, or since forget_failing, that fails right after now.
  std::optional<Place> next_failing();
  // What fails now fails next.
  void forget_failing() { failing_.clear(); }
  // New motions: notes the ties among the certificates of these objects.
  void note_ties(std::span<const ObjectId> objects);
  // The claims about these edges may be others now: makes their certificates anew where they are.
  void renew(std::span<const Item> items);

  // Each record of `outside` holds its claim, and ties in the right order.
  void check(Item outside, AuditReport& report) const;
  // No certificate belongs to no record.
  void check_all(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  std::uint32_t list(Item item, Place place);
  void unlist(Item item, std::uint32_t at);
  void certify(Place place);

  Slots slots_;
  const TreeEdges* edges_;
  std::vector<Record> records_;
  std::vector<Place> free_;
  std::vector<std::vector<Place>> places_;  // by item: the records that name it
  // Records whose certificates were identically zero, or negative right after now, when they were
  // made. They may have changed since.
  std::vector<Place> tied_, failing_;
};

}  // namespace kinex

#endif
