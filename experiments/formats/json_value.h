// SPDX-License-Identifier: GPL-3.0-or-later
// JsonValue: a node of a JSON tree that keeps numbers as written, so that nothing is rounded.
#ifndef KINEX_EXPERIMENTS_FORMATS_JSON_VALUE_H
#define KINEX_EXPERIMENTS_FORMATS_JSON_VALUE_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace kinex::formats {

// 24 bytes, owns nothing: text and children belong to the JsonDocument, which must outlive it.
class JsonValue {
 public:
  enum class Kind : std::uint8_t { kNull, kBoolean, kNumber, kString, kArray, kObject };

  JsonValue() = default;  // value-initialised: null
  // A boolean.
  JsonValue(bool value, std::uint32_t offset)
      : data_(nullptr), size_(0), offset_(offset), kind_(Kind::kBoolean), boolean_(value) {}
  // A number or a string; null, which has no text.
  JsonValue(Kind kind, std::string_view text, std::uint32_t offset)
      : data_(text.data()),
        size_(static_cast<std::uint32_t>(text.size())),
        offset_(offset),
        kind_(kind),
        boolean_(false) {}
  // An array; or an object, whose names (strings) follow its items, in the same order.
  JsonValue(Kind kind, const JsonValue* items, std::uint32_t size, std::uint32_t offset)
      : data_(items), size_(size), offset_(offset), kind_(kind), boolean_(false) {}

  Kind kind() const { return kind_; }
  bool boolean() const { return boolean_; }
  // kString: the string; kNumber: the token as written; otherwise empty.
  std::string_view text() const {
    return has_text() ? std::string_view(static_cast<const char*>(data_), size_) : std::string_view();
  }
  // kArray, kObject: the values, in the order of the file; otherwise none.
  std::span<const JsonValue> items() const {
    return has_items() ? std::span(static_cast<const JsonValue*>(data_), size_)
                       : std::span<const JsonValue>();
  }
  // kObject: the names of the items, as strings.
  std::span<const JsonValue> keys() const {
    return kind_ == Kind::kObject ? std::span(static_cast<const JsonValue*>(data_) + size_, size_)
                                  : std::span<const JsonValue>();
  }
  // The name of the i-th item.
  std::string_view key(std::size_t i) const { return keys()[i].text(); }
  // The first byte of the value in the text.
  std::size_t offset() const { return offset_; }

  // The member of that name, or nullptr. Cost: one comparison a member.
  const JsonValue* find(std::string_view key) const;

 private:
  bool has_text() const { return kind_ == Kind::kString || kind_ == Kind::kNumber; }
  bool has_items() const { return kind_ == Kind::kArray || kind_ == Kind::kObject; }

  const void* data_;
  std::uint32_t size_;
  std::uint32_t offset_;
  Kind kind_;
  bool boolean_;
};

// "a number", "an object" ... for messages.
std::string_view kind_name(JsonValue::Kind kind);
// A value as it is shown in a message: scalars in full (cut if long), others by their kind.
std::string shown(const JsonValue& value);

}  // namespace kinex::formats

#endif
