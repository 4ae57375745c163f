// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/json_document.h"

#include <rapidjson/reader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/show_text.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_defect.h"
#include "experiments/formats/utf8.h"

namespace kinex::formats {

namespace {

// Children of at least this many values share a block, unless there are more in one list.
constexpr std::size_t kMostInBlock = 1 << 16;
// Members up to which names are compared each with each.
constexpr std::size_t kFewMembers = 8;

// True if a number of JSON is no finite double. Most tokens are too short for that.
bool beyond_double(const char* token, std::size_t size) {
  if (size < 300 && std::memchr(token, 'e', size) == nullptr && std::memchr(token, 'E', size) == nullptr) {
    return false;
  }
  return !std::isfinite(std::strtod(std::string(token, size).c_str(), nullptr));
}

}  // namespace

// Handler of rapidjson. An open array or object lies on a stack with what is in it so far; closing it moves
// its children into a block of the document.
class JsonTreeBuilder {
 public:
  using Stream = rapidjson::InsituStringStream;

  // `bytes`: those of `text`, with NUL behind them; rapidjson decodes strings there.
  JsonTreeBuilder(std::string_view text, char* bytes, JsonDocument& document, Deadline* deadline)
      : text_(text), bytes_(bytes), document_(document), deadline_(deadline) {
    stack_.reserve(64);
  }

  // A copy that the document owns.
  static char* copied(std::string_view text, JsonDocument& document) {
    document.text_.reserve(text.size() + 1);
    document.text_.assign(text.begin(), text.end());
    document.text_.push_back('\0');
    return document.text_.data();
  }

  // Fills the document, or throws InputError.
  void parse_or_throw(const std::string& file, std::size_t first_line) {
    require(text_.size() < std::size_t{1} << 32, "parse_json: the text is longer than 4 GiB");
    const std::optional<JsonDefect> defect = parse();
    if (!defect) return;
    const TextPosition at = position_in(text_, defect->offset);
    throw InputError(
        file,
        "line " + std::to_string(at.line + first_line - 1) + ", column " + std::to_string(at.column),
        defect->problem, defect->remedy);
  }

  // What rapidjson calls. False: `defect_` says why.
  bool Null() { return add(JsonValue(JsonValue::Kind::kNull, {}, before(4))); }
  bool Bool(bool value) { return add(JsonValue(value, before(value ? 4 : 5))); }
  bool RawNumber(const char* token, rapidjson::SizeType size, bool) {
    const std::uint32_t offset = offset_of(token);
    if (size > kMaxNumberLength) {
      return fail({offset, "a number of " + std::to_string(size) + " characters", "write at most 1000000"});
    }
    if (beyond_double(token, size)) return fail(range_defect(text_, offset));
    return add(JsonValue(JsonValue::Kind::kNumber, {token, size}, offset));
  }
  bool String(const char* text, rapidjson::SizeType size, bool) {
    const std::uint32_t offset = offset_of(text) - 1;
    // Escapes alone can give a text that its bytes are not.
    if (has_escapes_ && !is_utf8({text, size})) {
      in_string_ = true;
      return fail(surrogate_defect(text_, offset));
    }
    return add(JsonValue(JsonValue::Kind::kString, {text, size}, offset));
  }
  bool Key(const char* text, rapidjson::SizeType size, bool copy) { return String(text, size, copy); }
  bool StartObject() { return open(JsonValue::Kind::kObject); }
  bool StartArray() { return open(JsonValue::Kind::kArray); }
  bool EndArray(rapidjson::SizeType count) {
    JsonValue* const items = block(count);
    const auto begin = stack_.end() - static_cast<std::ptrdiff_t>(count);
    std::copy(begin, stack_.end(), items);
    close(begin, items, count);
    return true;
  }
  bool EndObject(rapidjson::SizeType count) {
    JsonValue* const items = block(2 * std::size_t{count});
    const auto begin = stack_.end() - 2 * static_cast<std::ptrdiff_t>(count);
    for (std::size_t i = 0; i < count; ++i) {
      items[count + i] = begin[static_cast<std::ptrdiff_t>(2 * i)];
      items[i] = begin[static_cast<std::ptrdiff_t>(2 * i + 1)];
    }
    close(begin, items, count);
    return names_are_distinct(stack_.back().keys());
  }
  // Not called: numbers are text.
  bool Int(int) { return false; }
  bool Uint(unsigned) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }

 private:
  // The defect of the text, or nullopt.
  std::optional<JsonDefect> parse() {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    constexpr unsigned kFlags = rapidjson::kParseInsituFlag | rapidjson::kParseNumbersAsStringsFlag;
    // Before closing quotation marks become NUL.
    has_escapes_ = text_.find('\\') != std::string_view::npos;
    const std::size_t byte = first_not_utf8(text_);
    const std::size_t from = text_.starts_with(kMark) ? kMark.size() : 0;
    std::fill_n(bytes_, from, ' ');
    Stream stream(bytes_);
    stream_ = &stream;
    rapidjson::Reader reader;
    const rapidjson::ParseResult result = reader.Parse<kFlags>(stream, *this);
    // What lies before the defect has no NUL of its own.
    if (result.IsError()) std::replace(bytes_, bytes_ + stream.Tell(), '\0', '"');
    std::optional<JsonDefect> defect;
    if (result.Code() == rapidjson::kParseErrorTermination) {
      defect = std::move(defect_);
    } else if (result.IsError()) {
      defect = json_defect(text_, result.Code(), result.Offset());
    } else if (stream.Tell() < text_.size()) {
      defect = json_defect(text_, rapidjson::kParseErrorDocumentRootNotSingular, stream.Tell());
    }
    // Bytes that are no UTF-8 come first where they stand first.
    if (byte < text_.size() && (!defect || byte <= defect->offset || in_string_)) {
      return utf8_defect(text_, byte);
    }
    if (!defect) document_.root_ = stack_.front();
    return defect;
  }

  std::uint32_t offset_of(const char* at) const {
    return static_cast<std::uint32_t>(at - bytes_);
  }
  // Where a token of `size` bytes began that has just been read.
  std::uint32_t before(std::size_t size) const { return static_cast<std::uint32_t>(stream_->Tell() - size); }

  bool fail(JsonDefect defect) {
    defect_ = std::move(defect);
    return false;
  }

  bool add(const JsonValue& value) {
    if (deadline_ != nullptr) deadline_->poll();
    stack_.push_back(value);
    return true;
  }

  bool open(JsonValue::Kind kind) {
    if (depth_ >= kMaxJsonDepth) {
      return fail({before(1), "brackets are nested deeper than " + std::to_string(kMaxJsonDepth) + " levels",
                   "no file of kinex needs that"});
    }
    ++depth_;
    return add(JsonValue(kind, nullptr, 0, before(1)));
  }

  // The open value below `begin` gets its items.
  void close(std::vector<JsonValue>::iterator begin, const JsonValue* items, std::uint32_t count) {
    --depth_;
    JsonValue& value = *(begin - 1);
    value = JsonValue(value.kind(), items, count, static_cast<std::uint32_t>(value.offset()));
    stack_.erase(begin, stack_.end());
  }

  JsonValue* block(std::size_t size) {
    if (size > left_) {
      // A value takes some eight bytes of text.
      left_ = std::max(size, std::clamp<std::size_t>(text_.size() / 8, 16, kMostInBlock));
      document_.blocks_.push_back(std::make_unique_for_overwrite<JsonValue[]>(left_));
      next_ = document_.blocks_.back().get();
    }
    left_ -= size;
    return std::exchange(next_, next_ + size);
  }

  bool names_are_distinct(std::span<const JsonValue> names) {
    if (names.size() <= kFewMembers) {
      for (std::size_t i = 1; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (names[i].text() == names[j].text()) return fail_twice(names[i]);
        }
      }
      return true;
    }
    std::vector<const JsonValue*> order;
    for (const JsonValue& name : names) order.push_back(&name);
    std::sort(order.begin(), order.end(), [](const JsonValue* a, const JsonValue* b) {
      return std::pair(a->text(), a->offset()) < std::pair(b->text(), b->offset());
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (order[i]->text() == order[i - 1]->text()) return fail_twice(*order[i]);
    }
    return true;
  }

  bool fail_twice(const JsonValue& name) {
    return fail({name.offset(), "the name " + show_text(name.text()) + " stands twice in one object",
                 "remove one of them"});
  }

  std::string_view text_;
  char* bytes_;
  JsonDocument& document_;
  Deadline* deadline_;
  Stream* stream_ = nullptr;
  std::vector<JsonValue> stack_;
  int depth_ = 0;
  JsonValue* next_ = nullptr;  // free values of the last block
  std::size_t left_ = 0;
  bool has_escapes_ = false;
  bool in_string_ = false;  // the defect is somewhere in a string
  JsonDefect defect_;
};

JsonDocument parse_json(std::string_view text, const std::string& file, std::size_t first_line,
                        Deadline* deadline) {
  JsonDocument document;
  JsonTreeBuilder(text, JsonTreeBuilder::copied(text, document), document, deadline)
      .parse_or_throw(file, first_line);
  return document;
}

JsonDocument parse_json_in_place(std::string& text, const std::string& file, Deadline* deadline) {
  if (text.find('\\') != std::string::npos) return parse_json(text, file, 1, deadline);
  JsonDocument document;
  JsonTreeBuilder(text, text.data(), document, deadline).parse_or_throw(file, 1);
  return document;
}

}  // namespace kinex::formats
