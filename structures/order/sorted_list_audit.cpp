// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/order/sorted_list.h"
#include "structures/parts/key_value.h"

namespace kinex {

void SortedList::check_invariants(AuditReport& report) const {
  std::size_t count = 0;
  Place previous = kNone;
  std::vector<Place> places;
  for (Place s = first_; s != kNone && count <= slots_.size(); s = slots_[s].next, ++count) {
    const Slot& slot = slots_[s];
    const auto where = [&] { return " at object " + std::to_string(slot.object); };
    places.push_back(s);
    report.check(slot.previous == previous, [&] { return "a broken link" + where(); });
    report.check(slot.object < slot_of_.size() && slot_of_[slot.object] == s,
                 [&] { return "a lost object" + where(); });
    const bool has_next = slot.next != kNone;
    report.check(has_next == (slot.certificate != kNoCertificate),
                 [&] { return "a certificate too many or too few" + where(); });
    if (has_next && slot.certificate != kNoCertificate) {
      report.check(
          kernel_->query(slot.certificate) == order_.query(slot.object, object_at(slot.next)) &&
              kernel_->tag(slot.certificate) == s,
          [&] { return "a certificate of something else" + where(); });
      report.check(kernel_->outlook(slot.certificate) != Outlook::kIdenticallyZero ||
                       slot.object < object_at(slot.next),
                   [&] { return "a tie in the wrong order" + where(); });
    }
    previous = s;
  }
  report.check(previous == last_, [] { return std::string("the last place is another"); });
  report.check(count == size_, [] { return std::string("the list has another length"); });
  report.check(ties_.empty(), [] { return std::string("ties were not settled"); });
  if (has_tree_) {
    report.check(tree_.consistent() && tree_.in_order() == places,
                 [] { return std::string("the tree has another order"); });
  }
}

void SortedList::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<ObjectId> expected;
  for (const auto& [value, object] : sorted_keys(order_.key(), snapshot, slot_of_.size())) {
    expected.push_back(object);
  }
  report.check(expected == attribute().ids,
               [] { return std::string("the order differs from a sorted list"); });
}

}  // namespace kinex
