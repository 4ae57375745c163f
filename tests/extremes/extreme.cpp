// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/extremes/extreme.h"

#include <sstream>
#include <stdexcept>

#include "experiments/formats/file_io.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/polynomial_file.h"
#include "experiments/formats/scene_reader.h"
#include "tests/extremes/crowds.h"
#include "tests/places.h"

namespace kinex::extremes {

namespace {

[[noreturn]] void refuse(const std::string& text) {
  throw std::runtime_error("no place in time: " + text);
}

// "1/3", or "2^-80".
Rational parse_term(const std::string& word) {
  if (word.rfind("2^-", 0) == 0) {
    return Rational(Integer(1), Integer::power_of_two(std::stoul(word.substr(3))));
  }
  const std::optional<Rational> value = Rational::parse(word);
  if (!value) refuse(word);
  return *value;
}

// [TERM] {"+" | "-" TERM}, up to the end or to the word `stop`.
Rational parse_sum(std::istringstream& words, const std::string& stop = "") {
  Rational sum;
  int sign = 1;
  for (std::string word; words >> word && word != stop;) {
    if (word == "+" || word == "-") {
      sign = word == "+" ? 1 : -1;
    } else {
      sum += Rational(sign) * parse_term(word);
    }
  }
  return sum;
}

// p(t - by), up to a positive factor.
Polynomial shifted(const std::vector<Rational>& p, const Rational& by) {
  std::vector<Rational> result;
  for (auto c = p.rbegin(); c != p.rend(); ++c) {
    std::vector<Rational> next(result.size() + 1);
    for (std::size_t i = 0; i < result.size(); ++i) {
      next[i + 1] += result[i];
      next[i] -= by * result[i];
    }
    next[0] += *c;
    result = std::move(next);
  }
  return Polynomial::from_rationals(result);
}

Place parse_root(std::istringstream& words, const std::string& text) {
  std::size_t index = 0;
  std::string word;
  if (!(words >> index >> word) || word != "of") refuse(text);
  std::vector<Rational> p;
  while (words >> word && word != "+" && word != "-") p.push_back(parse_term(word));
  Rational by;
  if (words) {
    by = parse_sum(words);
    if (word == "-") by = -by;
  }
  RootCounters counters;
  std::vector<RootWithMultiplicity> roots = isolate_real_roots(shifted(p, by), counters);
  if (index < 1 || index > roots.size()) refuse(text);
  Place place;
  place.root = std::move(roots[index - 1].root);
  return place;
}

std::vector<std::pair<Place, std::size_t>> read_pairs(const formats::JsonValue& list) {
  std::vector<std::pair<Place, std::size_t>> pairs;
  for (const formats::JsonValue& item : list.items()) {
    pairs.emplace_back(parse_place(std::string(item.items()[0].text())), std::stoul(std::string(item.items()[1].text())));
  }
  return pairs;
}

std::string text_of(const formats::JsonValue& item, std::string_view key) {
  const formats::JsonValue* value = item.find(key);
  return value == nullptr ? std::string() : std::string(value->text());
}

Extreme read_entry(const formats::JsonValue& item) {
  Extreme e;
  e.name = text_of(item, "name");
  e.source = text_of(item, "source");
  e.file = text_of(item, "file");
  e.polynomial = text_of(item, "polynomial");
  e.crowd = text_of(item, "crowd");
  if (const formats::JsonValue* time = item.find("time")) {
    e.start = parse_term(std::string(time->items()[0].text()));
    e.end = parse_term(std::string(time->items()[1].text()));
  }
  if (const formats::JsonValue* instants = item.find("instants")) {
    e.instants = read_pairs(*instants);
    for (const auto& instant : *e.instants) e.events += instant.second;
    e.events_known = true;
  } else if (const formats::JsonValue* events = item.find("events")) {
    e.events = std::stoul(std::string(events->text()));
    e.events_known = true;
  }
  if (const formats::JsonValue* roots = item.find("roots")) {
    for (auto& [place, count] : read_pairs(*roots)) {
      e.roots.emplace_back(std::move(place), static_cast<int>(count));
    }
  }
  if (const formats::JsonValue* end = item.find("final")) {
    e.final_state = end->kind() == formats::JsonValue::Kind::kString ? end->text() : "list";
    for (const formats::JsonValue& id : end->items()) e.final_list.emplace_back(id.text());
  }
  if (const formats::JsonValue* sturm = item.find("sturm")) e.sturm = sturm->boolean();
  if (const formats::JsonValue* page = item.find("page")) e.page = page->boolean();
  return e;
}

}  // namespace

Place parse_place(const std::string& text) {
  std::istringstream words(text);
  Place place;
  if (text.rfind("root ", 0) == 0) {
    words.ignore(5);
    place = parse_root(words, text);
  } else if (text.rfind("between ", 0) == 0) {
    words.ignore(8);
    place.lower = parse_sum(words, "and");
    place.upper = parse_sum(words);
  } else {
    place.rational = parse_sum(words);
  }
  place.text = text;
  return place;
}

bool is_at(RealRoot& root, Place& place) {
  RootCounters counters;
  if (place.rational) {
    const Rational& t = *place.rational;
    return root.lower() <= t && t <= root.upper() && root.polynomial().sign_at(t) == Sign::kZero;
  }
  if (place.root) return compare(root, *place.root, counters) == 0;
  return compare(root, place.lower, counters) > 0 && compare(root, place.upper, counters) < 0;
}

std::string corpus_folder() { return KINEX_SOURCE_DIR "/tests/corpus/extremes"; }

std::vector<Extreme> read_extremes() {
  const std::string path = corpus_folder() + "/index.json";
  const std::string text = formats::read_text_file(path);
  std::vector<Extreme> extremes;
  const formats::JsonDocument index = formats::parse_json(text, path);
  for (const formats::JsonValue& item : index->items()) extremes.push_back(read_entry(item));
  return extremes;
}

Polynomial read_polynomial(const Extreme& extreme) {
  const std::string path = corpus_folder() + "/" + extreme.polynomial;
  const std::string text = formats::read_text_file(path);
  std::vector<formats::PolynomialLine> lines = formats::parse_polynomials(text, path);
  if (lines.size() != 1) throw std::runtime_error(path + ": not one polynomial");
  return std::move(lines[0].polynomial);
}

Scene Extreme::scene() const {
  if (!file.empty()) return formats::read_scene(corpus_folder() + "/" + file);
  if (!crowd.empty()) return make_crowd(crowd);
  const Polynomial p = read_polynomial(*this);
  std::vector<Rational> curve;
  for (const Integer& c : p.coefficients()) curve.emplace_back(c);
  Scene result;
  result.name = name;
  result.start = start;
  result.end = end;
  result.objects.push_back({"curve", {{{std::nullopt, std::nullopt, {{curve}}}}}});
  result.objects.push_back({"rest", {{{std::nullopt, std::nullopt, {{{Rational(0)}}}}}}});
  result.maintain.push_back({"sorted_list", "sorted_list", {}});
  return result;
}

}  // namespace kinex::extremes
