// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cycle_records.h"

namespace kinex {

// ---- records

void CycleRecords::make_room(std::size_t items) {
  if (places_.size() < items) places_.resize(items);
}

std::uint32_t CycleRecords::list(Item item, Place place) {
  places_[item].push_back(place);
  return static_cast<std::uint32_t>(places_[item].size() - 1);
}

// The last of the list comes to its place.
void CycleRecords::unlist(Item item, std::uint32_t at) {
  std::vector<Place>& places = places_[item];
  Record& last = records_[places.back()];
  (last.inside == item ? last.at_inside : last.at_outside) = at;
  places[at] = places.back();
  places.pop_back();
}

void CycleRecords::add(Item inside, Item outside) {
  Place place;
  if (free_.empty()) {
    place = static_cast<Place>(records_.size());
    records_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  records_[place] = {inside, outside, kNoCertificate, list(inside, place), list(outside, place)};
  certify(place);
}

void CycleRecords::change(Place place, Item inside, Item outside) {
  Record& record = records_[place];
  if (record.inside != inside) {
    unlist(record.inside, record.at_inside);
    record.inside = inside;
    record.at_inside = list(inside, place);
  }
  if (record.outside != outside) {
    unlist(record.outside, record.at_outside);
    record.outside = outside;
    record.at_outside = list(outside, place);
  }
  certify(place);
}

void CycleRecords::drop(Place place) {
  Record& record = records_[place];
  slots_.drop(record.certificate);
  unlist(record.inside, record.at_inside);
  unlist(record.outside, record.at_outside);
  record = {};
  free_.push_back(place);
}

void CycleRecords::drop_all(Item item) {
  while (!places_[item].empty()) drop(places_[item].back());
}

void CycleRecords::clear() {
  for (Record& record : records_) slots_.drop(record.certificate);
  records_.clear();
  free_.clear();
  places_.clear();
  tied_.clear();
  failing_.clear();
}

// ---- certificates

void CycleRecords::certify(Place place) {
  Record& record = records_[place];
  const Query claim = edges_->claim(record.inside, record.outside);
  const Outlook outlook = slots_.set(record.certificate, claim, place);
  if (outlook == Outlook::kIdenticallyZero) tied_.push_back(place);
  if (outlook == Outlook::kFailsNow) failing_.push_back(place);
}

std::optional<CycleRecords::Place> CycleRecords::next_tie() {
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
    for (const Place place : places_[item]) {
      const Record& record = records_[place];
      const Query claim = edges_->claim(record.inside, record.outside);
      if (!slots_.holds(record.certificate, claim, place)) {
        certify(place);
      } else if (slots_.is_tie(record.certificate)) {
        tied_.push_back(place);
      }
    }
  }
}

// ---- checks

void CycleRecords::check(Item outside, AuditReport& report) const {
  for (const Place place : places_[outside]) {
    const Record& record = records_[place];
    if (record.outside != outside) continue;
    report.check(slots_.holds(record.certificate, edges_->claim(record.inside, outside), place),
                 [] { return "a certificate of something else"; });
    report.check(!slots_.is_tie(record.certificate) || edges_->goes_first(record.inside, outside),
                 [] { return "a tie in the wrong order"; });
  }
}

void CycleRecords::check_all(AuditReport& report) const {
  report.check(slots_.line().live == size(), [] { return "certificates of no cycle"; });
}

std::size_t CycleRecords::bytes() const {
  std::size_t sum = records_.capacity() * sizeof(Record) +
                    places_.capacity() * sizeof(std::vector<Place>) +
                    (free_.capacity() + tied_.capacity() + failing_.capacity()) * sizeof(Place);
  for (const std::vector<Place>& places : places_) sum += places.capacity() * sizeof(Place);
  return sum;
}

}  // namespace kinex
