// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_digest.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "core/engine/event.h"
#include "core/engine/simulator.h"
#include "experiments/formats/json_writer.h"

namespace kinex::formats {

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
  objects_ = objects.size();
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

namespace {

// Returns the byte after it.
char* put_head(char* at, std::uint8_t structure, std::uint8_t kind, bool external, bool difference,
               std::size_t ids) {
  at[0] = static_cast<char>(structure);
  at[1] = static_cast<char>(kind);
  at[2] = static_cast<char>((external ? 1 : 0) | (difference ? 2 : 0));
  at[3] = static_cast<char>(static_cast<unsigned char>(ids));
  return at + 4;
}

char* put_number(char* at, std::uint32_t number) {
  for (int i = 0; i < 4; ++i)
    at[i] = static_cast<char>(static_cast<unsigned char>(number >> 8 * i));
  return at + 4;
}

}  // namespace

void LogDigest::put(std::uint32_t number) {
  make_room(4);
  put_number(block_.get() + used_, number);
  used_ += 4;
}

void LogDigest::head(std::uint8_t structure, std::uint8_t kind, bool external, bool difference,
                     std::size_t ids) {
  make_room(4);
  put_head(block_.get() + used_, structure, kind, external, difference, ids);
  used_ += 4;
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
  const std::size_t ids = event.count;
  const std::span<const ObjectId> named(event.ids.data(), ids);
  const auto is_derived = [this](ObjectId id) { return id >= objects_; };
  if (std::any_of(named.begin(), named.end(), is_derived)) {
    head(event.structure, event.kind, event.external, difference, ids);
    add_ids(named, simulator);
  } else {
    // The usual record: its place in the block is known beforehand.
    make_room(4 + 4 * ids);
    char* at = block_.get() + used_;
    used_ += 4 + 4 * ids;
    at = put_head(at, event.structure, event.kind, event.external, difference, ids);
    for (const ObjectId id : named) at = put_number(at, id);
  }
  if (!difference) return;
  for (const std::span<const ObjectId> side : {event.gone, event.came}) {
    count(side.size());
    add_ids(side, simulator);
  }
}

void LogDigest::add_ids(std::span<const ObjectId> ids, const Simulator& simulator) {
  for (const ObjectId id : ids) {
    if (id < objects_) {
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

}  // namespace kinex::formats
