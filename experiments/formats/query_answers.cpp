// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/query_answers.h"

#include <array>
#include <utility>

#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/utf8.h"

namespace kinex::formats {

namespace {

constexpr int kDigits = 17;

std::array<std::pair<const char*, std::uint64_t>, 4> outcomes(const ContactTally& tally) {
  return {{{"true_positives", tally.true_positives},
           {"true_negatives", tally.true_negatives},
           {"false_positives", tally.false_positives},
           {"false_negatives", tally.false_negatives}}};
}

std::string time_text(ContactTime& time, RootCounters& counters) {
  const RootName name = name_instant(time, counters);
  const std::string number = decimal(time.root, kDigits, counters);
  if (name.lower == name.upper) return name.lower.to_string() + " = " + number;
  return number + ", root " + std::to_string(name.index) + " of " + name.polynomial.to_string() +
         " (low degree first), in [" + name.lower.to_string() + ", " + name.upper.to_string() + "]";
}

void write_time(JsonWriter& json, ContactTime& time, RootCounters& counters) {
  const RootName name = name_instant(time, counters);
  json.begin_object().key("polynomial").begin_array();
  for (const Integer& c : name.polynomial.coefficients()) json.string(c.to_string());
  json.end_array().key("root").number(name.index).key("interval").begin_array();
  json.string(name.lower.to_string()).string(name.upper.to_string()).end_array();
  json.key("decimal").string(decimal(time.root, kDigits, counters)).end_object();
}

}  // namespace

void ContactTally::count(bool contact, std::optional<bool> truth) {
  ++queries;
  contacts += contact ? 1 : 0;
  if (!truth) return;
  if (contact) {
    ++(*truth ? true_positives : false_positives);
  } else {
    ++(*truth ? false_negatives : true_negatives);
  }
}

std::string answer_text(ContactAnswer& answer, RootCounters& counters) {
  std::string text =
      "query " + std::to_string(answer.number) + " (line " + std::to_string(answer.line) + "): ";
  text += answer.contact ? "contact at " + time_text(*answer.time, counters) : "no contact";
  if (answer.truth && *answer.truth != answer.contact) {
    text += *answer.truth ? "; the file says contact" : "; the file says no contact";
  }
  return text + "\n";
}

std::string answer_json(ContactAnswer& answer, RootCounters& counters) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("query").number(answer.number);
  json.key("line").number(static_cast<std::uint64_t>(answer.line));
  json.key("contact").boolean(answer.contact).key("time");
  if (answer.contact) {
    write_time(json, *answer.time, counters);
  } else {
    json.null();
  }
  json.key("truth");
  if (answer.truth) {
    json.boolean(*answer.truth);
  } else {
    json.null();
  }
  json.end_object();
  return text + "\n";
}

std::string tally_text(const ContactTally& tally, const std::string& file, ContactKind kind,
                       bool has_truth) {
  std::string text = file + ": " + counted(tally.queries, "query, ", "queries, ") +
                     std::string(contact_kind_name(kind)) + ": " +
                     counted(tally.contacts, "contact", "contacts");
  if (!has_truth) return text + "; the file tells no truth\n";
  text += "; against the file:";
  const char* separator = " ";
  for (const auto& [name, number] : outcomes(tally)) {
    std::string words = name;
    words[words.find('_')] = ' ';
    if (number == 1) words.pop_back();  // "1 true positive"
    text += separator + std::to_string(number) + " " + words;
    separator = ", ";
  }
  return text + "\n";
}

std::string tally_json(const ContactTally& tally, const std::string& file, ContactKind kind,
                       bool has_truth) {
  std::string text;
  JsonWriter json(text);
  json.begin_object()
      .key("file")
      .string(is_utf8(file) ? file : show_text(file))
      .key("kind")
      .string(contact_kind_name(kind));
  json.key("queries").number(tally.queries).key("contacts").number(tally.contacts);
  for (const auto& [name, number] : outcomes(tally)) {
    json.key(name);
    if (has_truth) {
      json.number(number);
    } else {
      json.null();
    }
  }
  json.end_object();
  return text + "\n";
}

}  // namespace kinex::formats
