// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/log_digest.h"

#include <cstring>
#include <optional>
#include <utility>

#include "core/event.h"
#include "core/simulator.h"
#include "experiments/json_writer.h"

namespace kinex {

namespace {

constexpr std::uint32_t kDerived = 0xffffffffu;

template <class Names>
void append_names(std::string& text, const Names& names) {
  text += '[';
  bool first = true;
  for (const auto& name : names) {
    if (!first) text += ',';
    first = false;
    append_json_string(text, name);
  }
  text += ']';
}

}  // namespace

std::vector<DigestedStructure> digested_structures(const Simulator& simulator) {
  std::vector<DigestedStructure> structures;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    DigestedStructure& one = structures.emplace_back();
    one.label = simulator.label(id);
    one.structure = simulator.structure(id).name();
    for (const std::string_view kind : simulator.event_kinds(id)) one.kinds.emplace_back(kind);
  }
  return structures;
}

LogDigest::LogDigest(const std::vector<DigestedStructure>& structures,
                     const std::vector<std::string>& objects) {
  begin(structures, {objects.begin(), objects.end()});
}

LogDigest::LogDigest(const Simulator& simulator) {
  std::vector<std::string_view> objects;
  for (const SceneObject& object : simulator.scene().objects) objects.push_back(object.id);
  begin(digested_structures(simulator), objects);
}

void LogDigest::begin(const std::vector<DigestedStructure>& structures,
                      const std::vector<std::string_view>& objects) {
  std::string text = "kinex-digest 2\n[";
  for (const DigestedStructure& one : structures) {
    if (text.back() != '[') text += ',';
    text += '[';
    append_json_string(text, one.label);
    text += ',';
    append_json_string(text, one.structure);
    text += ',';
    append_names(text, one.kinds);
    text += ']';
  }
  text += "]\n";
  append_names(text, objects);
  text += '\n';
  hash_.add(text);
}

void LogDigest::head(std::uint8_t structure, std::uint8_t kind, bool external, bool difference,
                     std::size_t ids) {
  make_room(4);
  block_[used_++] = static_cast<char>(structure);
  block_[used_++] = static_cast<char>(kind);
  block_[used_++] = static_cast<char>((external ? 1 : 0) | (difference ? 2 : 0));
  block_[used_++] = static_cast<char>(static_cast<unsigned char>(ids));
}

void LogDigest::derived(std::string_view name) {
  put(kDerived);
  put(static_cast<std::uint32_t>(name.size()));
  make_room(name.size());
  std::memcpy(block_.get() + used_, name.data(), name.size());
  used_ += name.size();
}

void LogDigest::add(const Event& event, const Simulator& simulator) {
  const bool difference = event.has_difference();
  head(event.structure, event.kind, event.external, difference, event.count);
  add_ids({event.ids.data(), event.count}, simulator);
  if (!difference) return;
  for (const std::span<const ObjectId> side : {event.gone, event.came}) {
    count(side.size());
    add_ids(side, simulator);
  }
}

void LogDigest::add_ids(std::span<const ObjectId> ids, const Simulator& simulator) {
  const std::size_t objects = simulator.scene().objects.size();
  for (const ObjectId id : ids) {
    if (id < objects) {
      object(id);
    } else {
      derived(simulator.object_name(id));
    }
  }
}

void LogDigest::flush(std::size_t bytes) {
  std::optional<RunClock::Scope> scope;
  if (clock_ != nullptr) scope.emplace(*clock_, RunPhase::kReport);
  if (!holds_) settled_ = used_;
  hash_.add({block_.get(), settled_});
  used_ -= settled_;
  std::memmove(block_.get(), block_.get() + settled_, used_);
  settled_ = 0;
  if (used_ + bytes <= size_) return;
  const std::size_t size = 2 * (used_ + bytes);
  std::unique_ptr<char[]> larger = std::make_unique<char[]>(size);
  std::memcpy(larger.get(), block_.get(), used_);
  block_ = std::move(larger);
  size_ = size;
}

std::string LogDigest::hex() {
  settle();
  flush(0);
  return hash_.hex();
}

}  // namespace kinex
