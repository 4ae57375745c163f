// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cycle_records.h"

namespace kinex {

// ---- records

void CycleRecords::make_room(std::size_t items) {
  if (cycles_.size() >= items) return;
  cycles_.resize(items);
  uses_.resize(items);
}

std::uint32_t CycleRecords::list(Lists& lists, Item item, Place place) {
  lists[item].push_back(place);
  return static_cast<std::uint32_t>(lists[item].size() - 1);
}

// The last of the list comes to its place.
void CycleRecords::unlist_inside(const Record& record) {
  std::vector<Place>& places = uses_[record.inside];
  records_[places.back()].at_inside = record.at_inside;
  places[record.at_inside] = places.back();
  places.pop_back();
}

void CycleRecords::add(Item inside, Item outside, Item owner) {
  Place place;
  if (free_.empty()) {
    place = static_cast<Place>(records_.size());
    records_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  records_[place] = {inside,
                     outside,
                     owner,
                     kNoCertificate,
                     list(uses_, inside, place),
                     list(cycles_, owner, place),
                     false};
  wait(place);
}

void CycleRecords::change(Place place, Item inside, Item outside) {
  Record& record = records_[place];
  if (record.inside != inside) {
    unlist_inside(record);
    record.inside = inside;
    record.at_inside = list(uses_, inside, place);
  }
  record.outside = outside;
  wait(place);
}

void CycleRecords::drop(Place place) {
  Record& record = records_[place];
  if (record.certificate != kNoCertificate) spare_.push_back(record.certificate);
  unlist_inside(record);
  std::vector<Place>& places = cycles_[record.owner];
  records_[places.back()].at_owner = record.at_owner;
  places[record.at_owner] = places.back();
  places.pop_back();
  record = {};
  free_.push_back(place);
}

void CycleRecords::drop_cycle(Item owner) {
  while (!cycles_[owner].empty()) drop(cycles_[owner].back());
}

void CycleRecords::exchange_cycles(Item a, Item b) {
  cycles_[a].swap(cycles_[b]);
  for (const Item owner : {a, b}) {
    for (const Place place : cycles_[owner]) records_[place].owner = owner;
  }
}

void CycleRecords::clear() {
  for (Record& record : records_) slots_.drop(record.certificate);
  for (CertificateId& spare : spare_) slots_.drop(spare);
  spare_.clear();
  waiting_.clear();
  records_.clear();
  free_.clear();
  cycles_.clear();
  uses_.clear();
  tied_.clear();
  failing_.clear();
}

// ---- certificates

void CycleRecords::wait(Place place) {
  if (records_[place].is_waiting) return;
  records_[place].is_waiting = true;
  waiting_.push_back(place);
}

void CycleRecords::certify() {
  for (const Place place : waiting_) {
    Record& record = records_[place];
    if (!record.is_waiting) continue;  // it has gone
    record.is_waiting = false;
    if (record.certificate == kNoCertificate && !spare_.empty()) {
      record.certificate = spare_.back();
      spare_.pop_back();
    }
    const Query claim = edges_->claim(record.inside, record.outside);
    const Outlook outlook = slots_.set(record.certificate, claim, place);
    if (outlook == Outlook::kIdenticallyZero) tied_.push_back(place);
    if (outlook == Outlook::kFailsNow) failing_.push_back(place);
  }
  waiting_.clear();
  for (CertificateId& spare : spare_) slots_.drop(spare);
  spare_.clear();
}

std::optional<CycleRecords::Place> CycleRecords::next_tie() {
  certify();
  while (!tied_.empty()) {
    const Place place = tied_.back();
    tied_.pop_back();
    const Record& record = records_[place];
    if (!slots_.is_tie(record.certificate)) continue;
    if (!edges_->goes_first(record.inside, record.outside)) return place;
  }
  return std::nullopt;
}

std::optional<CycleRecords::Place> CycleRecords::next_failing() {
  certify();
  while (!failing_.empty()) {
    const Place place = failing_.back();
    failing_.pop_back();
    const CertificateId c = records_[place].certificate;
    if (c == kNoCertificate) continue;
    if (slots_.kernel().outlook(c) == Outlook::kFailsNow) return place;
  }
  return std::nullopt;
}

void CycleRecords::note_ties(std::span<const ObjectId> objects) {
  Kernel& kernel = slots_.kernel();
  for (const ObjectId object : objects) {
    for (const CertificateId c : kernel.certificates_of(object)) {
      if (slots_.is_tie(c) && slots_.owns(c)) tied_.push_back(kernel.tag(c));
    }
  }
}

void CycleRecords::renew(std::span<const Item> items) {
  for (const Item item : items) {
    for (const Place place : cycles_[item]) renew(place);
    for (const Place use : uses_[item]) {
      for (const Place place : cycles_[records_[use].owner]) {
        if (place == use || records_[place].outside == item) renew(place);
      }
    }
  }
}

void CycleRecords::renew(Place place) {
  const Record& record = records_[place];
  const Query claim = edges_->claim(record.inside, record.outside);
  if (!slots_.holds(record.certificate, claim, place)) {
    wait(place);
  } else if (slots_.is_tie(record.certificate)) {
    tied_.push_back(place);
  }
}

// ---- checks

void CycleRecords::check(Item owner, AuditReport& report) const {
  for (const Place place : cycles_[owner]) {
    const Record& record = records_[place];
    const Query claim = edges_->claim(record.inside, record.outside);
    report.check(record.owner == owner && slots_.holds(record.certificate, claim, place),
                 [] { return "a certificate of something else"; });
    report.check(
        !slots_.is_tie(record.certificate) || edges_->goes_first(record.inside, record.outside),
        [] { return "a tie in the wrong order"; });
  }
}

void CycleRecords::check_all(AuditReport& report) const {
  report.check(slots_.line().live == size(), [] { return "certificates of no cycle"; });
}

std::size_t CycleRecords::bytes() const {
  std::size_t sum =
      records_.capacity() * sizeof(Record) +
      (free_.capacity() + waiting_.capacity() + tied_.capacity() + failing_.capacity()) *
          sizeof(Place) +
      spare_.capacity() * sizeof(CertificateId);
  for (const Lists* lists : {&cycles_, &uses_}) {
    sum += lists->capacity() * sizeof(std::vector<Place>);
    for (const std::vector<Place>& places : *lists) sum += places.capacity() * sizeof(Place);
  }
  return sum;
}

}  // namespace kinex
