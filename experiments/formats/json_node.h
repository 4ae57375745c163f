// SPDX-License-Identifier: GPL-3.0-or-later
// JsonNode: a value inside a parsed file that knows its path, for readers with precise messages.
#ifndef KINEX_EXPERIMENTS_FORMATS_JSON_NODE_H
#define KINEX_EXPERIMENTS_FORMATS_JSON_NODE_H

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/numbers/rational.h"
#include "experiments/formats/json_document.h"

namespace kinex::formats {

// Shared by all nodes of one file; must outlive them.
struct JsonSource {
  std::string file;
  std::string_view text;
  std::size_t first_line = 1;    // 0: of an option, without lines in messages
  Deadline* deadline = nullptr;  // readers poll it between numbers; null: none
};

// A child refers to its parent, which must outlive it (readers go down the tree on the stack).
class JsonNode {
 public:
  JsonNode(const JsonValue& value, const JsonSource& source) : value_(&value), source_(&source) {}

  const JsonValue& value() const { return *value_; }
  bool is(JsonValue::Kind kind) const { return value_->kind() == kind; }
  std::size_t size() const { return value_->items().size(); }
  // The deadline of the file, for readers that may take long.
  void poll() const {
    if (source_->deadline != nullptr) source_->deadline->poll();
  }

  // Each throws InputError if the value is of another kind.
  std::string_view string() const;
  bool boolean() const;
  // A number, or a string with a number: exact, as written.
  Rational rational() const;
  // The same, into a number that is there already: no allocation but for its digits.
  void read(Rational& number) const;
  // A JSON number that is an integer in [low, high], however it is written: 2, 2.0 or 2e0.
  int integer(int low, int high) const;
  void require_array() const;
  void require_object(std::initializer_list<std::string_view> allowed) const {
    require_object(std::span(allowed.begin(), allowed.size()));
  }
  void require_object(std::span<const std::string_view> allowed) const;

  JsonNode at(std::size_t index) const;          // requires index < size()
  JsonNode member(std::string_view name) const;  // InputError if it is missing
  std::optional<JsonNode> find(std::string_view name) const;

  // "/objects/3/motion"; "" for the whole file.
  std::string path() const;
  // Throws "FILE: PATH: PROBLEM; REMEDY (line N)".
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;
  // Throws "... SHOWN is not WHAT; REMEDY", or "an array in place of WHAT; REMEDY".
  [[noreturn]] void refuse(std::string_view what, const std::string& remedy) const;

 private:
  JsonNode(const JsonValue& value, const JsonNode& parent, std::size_t index)
      : value_(&value), source_(parent.source_), parent_(&parent), index_(index) {}

  const JsonValue* value_;
  const JsonSource* source_;
  const JsonNode* parent_ = nullptr;
  std::size_t index_ = 0;  // in the parent's items
};

}  // namespace kinex::formats

#endif
