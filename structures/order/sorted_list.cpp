// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/order/sorted_list.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/parts/key_value.h"

namespace kinex {

SortedList::SortedList(Kernel& kernel, StructureId id, const Key& key, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      list_(kernel, id, "list", KeyOrder(kernel, key, scene), scene.objects.size()) {}

std::vector<std::string_view> SortedList::event_kinds() const {
  return common_event_kinds({"swap", "tie"});
}

void SortedList::build(std::span<const ObjectId> objects) {
  list_.build(order().members(objects), tied());
}

void SortedList::rebuild() {
  std::vector<ObjectId> members = list_.items();
  std::sort(members.begin(), members.end());
  list_.build(std::move(members), tied());
}

void SortedList::certificate_failed(CertificateId failed) {
  const auto [before, after] = list_.failed(failed);
  kernel_->report(id_, kSwap, {before, after}, true);
  list_.settle(tied());
}

void SortedList::insert(ObjectId object) { list_.insert(object, tied()); }

void SortedList::erase(ObjectId object) {
  order().check_erasure(object);
  list_.erase(object, tied());
}

void SortedList::motions_changed(std::span<const ObjectId> objects) {
  list_.motions_changed(objects, tied());
}

Attribute SortedList::attribute() const { return {Attribute::Shape::kSequence, list_.items()}; }

void SortedList::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "neighbours";
  list_.each_link([&](Item before, Item after, CertificateId certificate) {
    group.about = {before, after};
    visitor.group(group);
    if (certificate != kNoCertificate) visitor.certificate(certificate, "order");
  });
}

std::vector<BoundCheck> SortedList::bounds(const BoundContext& context) const {
  const std::vector<int> pieces = order().member_pieces(context);
  const Integer n(static_cast<std::int64_t>(pieces.size()));
  std::vector<BoundCheck> result;
  result.push_back(at_most(
      "sorted_list.swaps",
      "every pair changes places at each sign change of its key difference at most",
      pair_sign_changes(pieces, order().degree(context.degree), order().reference_pieces(context)),
      counted(context.ledger->processed)));
  result.push_back(at_most("sorted_list.certificates", "one certificate per pair of neighbours",
                           n.is_zero() ? Integer(0) : n - Integer(1),
                           counted(context.ledger->max_live)));
  if (order().reference() == kNoObject) {
    result.push_back(at_most("sorted_list.locality", "an object has two neighbours", Integer(2),
                             counted(context.ledger->max_per_object)));
  }
  return result;
}

void SortedList::check_invariants(AuditReport& report) const { list_.check(report, "the list"); }

void SortedList::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<ObjectId> expected;
  for (const auto& [value, object] : sorted_keys(order().key(), snapshot, objects())) {
    expected.push_back(object);
  }
  report.check(expected == list_.items(),
               [] { return std::string("the order differs from a sorted list"); });
}

}  // namespace kinex
