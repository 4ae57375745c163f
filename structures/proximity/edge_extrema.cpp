// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/edge_extrema.h"

#include <algorithm>

namespace kinex {

// ---- nodes

EdgeExtrema::Node EdgeExtrema::make(Kind kind, const Value& one, const Value& other) {
  Node node;
  if (free_.empty()) {
    node = static_cast<Node>(entries_.size());
    entries_.emplace_back();
  } else {
    node = free_.back();
    free_.pop_back();
  }
  Entry& entry = entries_[node];
  entry.kind = kind;
  entry.operands = {one, other};
  entry.value = kNoItem;
  for (const Value& operand : entry.operands) read(node, operand);
  refresh(node);
  return node;
}

void EdgeExtrema::drop(Node node) {
  Entry& entry = entries_[node];
  for (const Value& operand : entry.operands) unread(node, operand);
  slots_.drop(entry.certificate);
  entry.kind = Kind::kAbsent;
  free_.push_back(node);
}

void EdgeExtrema::clear() {
  for (Entry& entry : entries_) slots_.drop(entry.certificate);
  entries_.clear();
  free_.clear();
  tied_.clear();
  failing_.clear();
}

void EdgeExtrema::read(Node node, const Value& value) {
  if (value.node != kNone) entries_[value.node].readers.push_back(node);
}

void EdgeExtrema::unread(Node node, const Value& value) {
  if (value.node == kNone) return;
  std::vector<Node>& readers = entries_[value.node].readers;
  readers.erase(std::find(readers.begin(), readers.end(), node));
}

void EdgeExtrema::set_operand(Node node, std::size_t place, const Value& value) {
  Value& operand = entries_[node].operands[place];
  unread(node, operand);
  operand = value;
  read(node, operand);
  refresh(node);
}

// The shorter one first, as the certificate says.
std::array<Item, 2> EdgeExtrema::compared(const Entry& entry) const {
  const Item one = edge(entry.operands[0]), other = edge(entry.operands[1]);
  const bool in_order = entry.kind == Kind::kBound ||
                        (entry.kind == Kind::kLongest) == (entry.value == other);
  return in_order ? std::array{one, other} : std::array{other, one};
}

// Decides right after now.
void EdgeExtrema::refresh(Node node) {
  Entry& entry = entries_[node];
  const Item one = edge(entry.operands[0]), other = edge(entry.operands[1]);
  if (entry.kind == Kind::kBound) {
    const Outlook outlook = slots_.renew(entry.certificate, edges_->claim(one, other), node);
    if (outlook == Outlook::kIdenticallyZero) tied_.push_back(node);
    if (outlook == Outlook::kFailsNow) failing_.push_back(node);
    return;
  }
  const bool in_order = in_front(slots_.kernel(), order(), one, other);
  const Item shorter = in_order ? one : other, longer = in_order ? other : one;
  slots_.renew(entry.certificate, edges_->claim(shorter, longer), node);
  const Item value = entry.kind == Kind::kLongest ? longer : shorter;
  if (value == entry.value) return;
  entry.value = value;
  changed(node);
}

// Its value has become another one.
void EdgeExtrema::changed(Node node) {
  for (std::size_t i = 0; i < entries_[node].readers.size(); ++i) {
    refresh(entries_[node].readers[i]);
  }
}

std::vector<Item> EdgeExtrema::edges_of(const Value& value) const {
  std::vector<Item> result;
  std::vector<Value> left{value};
  while (!left.empty()) {
    const Value last = left.back();
    left.pop_back();
    if (last.edge != kNoItem) result.push_back(last.edge);
    if (last.node == kNone) continue;
    for (const Value& operand : entries_[last.node].operands) left.push_back(operand);
  }
  return result;
}

// ---- failures and ties

EdgeExtrema::Failure EdgeExtrema::failed(CertificateId failed) {
  const Node node = slots_.failed(failed);
  Entry& entry = entries_[node];
  const auto [shorter, longer] = compared(entry);
  if (entry.kind == Kind::kBound) return {true, shorter, longer};
  const bool longest = entry.kind == Kind::kLongest;
  const Item before = entry.value;
  entry.value = longest ? shorter : longer;
  slots_.set(entry.certificate, edges_->claim(longer, shorter), node);
  const Item after = entry.value;
  changed(node);
  return {false, before, after};
}

void EdgeExtrema::motions_changed(std::span<const ObjectId> objects) {
  std::vector<Node> nodes;
  for (const ObjectId object : objects) {
    for (const CertificateId c : slots_.kernel().certificates_of(object)) {
      if (slots_.is_tie(c) && slots_.owns(c)) nodes.push_back(slots_.kernel().tag(c));
    }
  }
  for (const Node node : nodes) refresh(node);
}

void EdgeExtrema::renew(std::span<const Item> items) {
  std::vector<bool> listed;
  for (const Item item : items) {
    if (listed.size() <= item) listed.resize(item + std::size_t{1}, false);
    listed[item] = true;
  }
  const auto is_listed = [&listed](Item item) { return item < listed.size() && listed[item]; };
  for (Node node = 0; node < entries_.size(); ++node) {
    const Entry& entry = entries_[node];
    if (entry.kind == Kind::kAbsent) continue;
    if (is_listed(edge(entry.operands[0])) || is_listed(edge(entry.operands[1]))) refresh(node);
  }
}

// The bound of a node that may be none any more, if its certificate has this outlook.
std::optional<EdgeExtrema::Broken> EdgeExtrema::broken(Node node, Outlook outlook) const {
  if (node >= entries_.size() || entries_[node].kind != Kind::kBound) return std::nullopt;
  const Entry& entry = entries_[node];
  if (slots_.kernel().outlook(entry.certificate) != outlook) return std::nullopt;
  const auto [shorter, longer] = compared(entry);
  return Broken{shorter, longer};
}

std::optional<EdgeExtrema::Broken> EdgeExtrema::next_tied() {
  while (!tied_.empty()) {
    const auto found = broken(tied_.back(), Outlook::kIdenticallyZero);
    tied_.pop_back();
    if (found && edges_->goes_first(found->longer, found->shorter)) return found;
  }
  return std::nullopt;
}

std::optional<EdgeExtrema::Broken> EdgeExtrema::next_failing() {
  while (!failing_.empty()) {
    const auto found = broken(failing_.back(), Outlook::kFailsNow);
    failing_.pop_back();
    if (found) return found;
  }
  return std::nullopt;
}

// ---- checks

void EdgeExtrema::check(AuditReport& report) const {
  std::size_t reading = 0, read = 0;
  for (Node node = 0; node < entries_.size(); ++node) {
    const Entry& entry = entries_[node];
    if (entry.kind == Kind::kAbsent) continue;
    read += entry.readers.size();
    for (const Value& operand : entry.operands) reading += operand.node == kNone ? 0 : 1;
    const Item one = edge(entry.operands[0]), other = edge(entry.operands[1]);
    report.check(entry.kind == Kind::kBound || entry.value == one || entry.value == other,
                 [] { return "an extremum that is neither operand"; });
    const auto [shorter, longer] = compared(entry);
    report.check(slots_.holds(entry.certificate, edges_->claim(shorter, longer), node),
                 [] { return "a certificate of something else"; });
    report.check(!slots_.is_tie(entry.certificate) || edges_->goes_first(shorter, longer),
                 [] { return "a tie in the wrong order"; });
  }
  report.check(reading == read, [] { return "a node that is read by others than it knows"; });
  report.check(slots_.line().live == size(), [] { return "a certificate without a node"; });
}

std::size_t EdgeExtrema::bytes() const {
  std::size_t total = entries_.capacity() * sizeof(Entry) +
                      (free_.capacity() + tied_.capacity() + failing_.capacity()) * sizeof(Node);
  for (const Entry& entry : entries_) total += entry.readers.capacity() * sizeof(Node);
  return total;
}

}  // namespace kinex
