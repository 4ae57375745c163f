// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/query_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/numbers/exactly.h"
#include "experiments/formats/input_error.h"

namespace kinex::formats {

namespace {

constexpr std::size_t kRows = 2 * ContactQuery::kPoints;  // of a query
constexpr std::size_t kColumns = 6;                       // without the truth
constexpr std::string_view kSpaces = " \t\r";
constexpr std::uint64_t kExactDouble = std::uint64_t{1} << 53;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kSpaces);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpaces) - begin + 1);
}

// One coordinate: a double if that is quick to see, else a fraction.
struct Number {
  double value = 0;
  std::optional<Rational> exact;  // if given, `value` is not
};

class QueryParser {
 public:
  QueryParser(std::string_view text, const std::string& file, ContactKind kind, Deadline* deadline)
      : text_(text), file_(file), kind_(kind), deadline_(deadline) {}

  QueryFile parse() {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text_.substr(0, 3) == kByteOrderMark) text_.remove_prefix(3);
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      const std::string_view line = trimmed(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
      if (!line.empty()) read_row(line);
    }
    if (row_ != 0) {
      throw InputError(
          file_, "line " + std::to_string(first_line_),
          "the last query has only " + std::to_string(row_) + (row_ == 1 ? " line" : " lines"),
          "a query is 8 lines: four points at t = 0, then the same at t = 1");
    }
    if (result_.queries.empty()) {
      throw InputError(file_, "", "there is no query in it",
                       "write 8 lines x_num,x_den,y_num,y_den,z_num,z_den[,truth] a query");
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw InputError(file_, "line " + std::to_string(line_), problem, remedy);
  }

  void read_row(std::string_view line) {
    if (deadline_ != nullptr) deadline_->poll();
    std::array<std::string_view, kColumns + 1> fields;
    const std::size_t count = split(line, fields);
    if (row_ == 0) first_line_ = line_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      coordinates_[3 * row_ + axis] = number(fields[2 * axis], fields[2 * axis + 1]);
    }
    read_truth(line, count == kColumns ? std::string_view{} : fields[kColumns], count > kColumns);
    if (++row_ == kRows) finish_query();
  }

  std::size_t split(std::string_view line, std::array<std::string_view, kColumns + 1>& fields) {
    std::size_t count = 0;
    for (std::string_view rest = line;;) {
      const std::size_t comma = rest.find(',');
      if (count < fields.size()) fields[count] = trimmed(rest.substr(0, comma));
      ++count;
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    if (count != kColumns && count != kColumns + 1) {
      fail(std::to_string(count) + (count == 1 ? " column in " : " columns in ") + show_text(line),
           "write x_num,x_den,y_num,y_den,z_num,z_den or these and the truth, 0 or 1");
    }
    return count;
  }

  Number number(std::string_view numerator, std::string_view denominator) const {
    if (const std::optional<double> value = quick_double(numerator, denominator)) {
      return {*value, std::nullopt};
    }
    const Integer n = integer(numerator), d = integer(denominator);
    if (d.is_zero()) {
      fail("the denominator " + show_text(denominator) + " is zero", "write a non-zero integer");
    }
    return {0, Rational(n, d)};
  }

  Integer integer(std::string_view text) const {
    std::optional<Integer> value = Integer::parse(text);
    if (!value) {
      fail(show_text(text) + " is not an integer",
           "write digits, with a minus sign before a negative number");
    }
    return std::move(*value);
  }

  // A numerator of at most 53 bits over a power of two of at most 64: exactly a double.
  static std::optional<double> quick_double(std::string_view numerator,
                                            std::string_view denominator) {
    std::int64_t n = 0;
    std::uint64_t d = 0;
    const char* const n_end = numerator.data() + numerator.size();
    const char* const d_end = denominator.data() + denominator.size();
    const auto [n_at, n_error] = std::from_chars(numerator.data(), n_end, n);
    const auto [d_at, d_error] = std::from_chars(denominator.data(), d_end, d);
    if (n_error != std::errc() || d_error != std::errc() || n_at != n_end || d_at != d_end) {
      return std::nullopt;
    }
    const auto limit = static_cast<std::int64_t>(kExactDouble);
    if (n > limit || n < -limit || d == 0 || (d & (d - 1)) != 0) return std::nullopt;
    return static_cast<double>(n) / static_cast<double>(d);
  }

  void read_truth(std::string_view line, std::string_view text, bool given) {
    if (row_ == 0 && result_.queries.empty()) result_.has_truth = given;
    if (given != result_.has_truth) {
      fail(show_text(line) + (given ? " has a truth column, and the lines before have none"
                                    : " has no truth column, and the lines before have one"),
           "write it in every line of the file or in none");
    }
    if (!given) return;
    if (text != "0" && text != "1") {
      fail("the truth " + show_text(text) + " is neither 0 nor 1",
           "write 1 for a contact and 0 for none");
    }
    const bool truth = text == "1";
    if (row_ != 0 && truth != truth_) {
      fail("the truth " + show_text(text) + " differs from that in line " +
               std::to_string(first_line_) + " of the same query",
           "write one truth in all eight lines of a query");
    }
    truth_ = truth;
  }

  void finish_query() {
    row_ = 0;
    bool doubles = true;
    for (const Number& number : coordinates_) doubles = doubles && !number.exact;
    if (doubles) {
      ContactQuery::Doubles values;
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = coordinates_[i].value;
      result_.queries.push_back({first_line_, ContactQuery(kind_, values), truth_});
      return;
    }
    std::vector<Rational> values;
    values.reserve(coordinates_.size());
    for (Number& number : coordinates_) {
      values.push_back(number.exact ? std::move(*number.exact)
                                    : exactly(number.value));
    }
    result_.queries.push_back({first_line_, ContactQuery(kind_, std::move(values)), truth_});
  }

  std::string_view text_;
  const std::string& file_;
  ContactKind kind_;
  Deadline* deadline_;
  std::size_t line_ = 0, first_line_ = 0;
  std::size_t row_ = 0;  // of the query
  bool truth_ = false;
  std::array<Number, ContactQuery::kCoordinates> coordinates_;
  QueryFile result_;
};

}  // namespace

QueryFile parse_queries(std::string_view text, const std::string& file, ContactKind kind,
                        Deadline* deadline) {
  return QueryParser(text, file, kind, deadline).parse();
}

std::string_view contact_kind_name(ContactKind kind) {
  return kind == ContactKind::kVertexFace ? "vertex-face" : "edge-edge";
}

std::optional<ContactKind> find_contact_kind(std::string_view name) {
  for (const ContactKind kind : {ContactKind::kVertexFace, ContactKind::kEdgeEdge}) {
    if (name == contact_kind_name(kind)) return kind;
  }
  return std::nullopt;
}

std::optional<ContactKind> contact_kind_of_path(std::string_view path) {
  while (!path.empty()) {
    const std::size_t slash = path.rfind('/');
    const std::string_view part = slash == std::string_view::npos ? path : path.substr(slash + 1);
    const bool vertex_face =
        part.find(contact_kind_name(ContactKind::kVertexFace)) != std::string_view::npos;
    const bool edge_edge =
        part.find(contact_kind_name(ContactKind::kEdgeEdge)) != std::string_view::npos;
    if (vertex_face != edge_edge) {
      return vertex_face ? ContactKind::kVertexFace : ContactKind::kEdgeEdge;
    }
    if (vertex_face || slash == std::string_view::npos) return std::nullopt;
    path = path.substr(0, slash);
  }
  return std::nullopt;
}

}  // namespace kinex::formats
