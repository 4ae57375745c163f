// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_check.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/numbers/real_root.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/grid_line.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/log_digest.h"
#include "experiments/formats/log_instant.h"
#include "experiments/formats/log_rules.h"
#include "experiments/formats/log_scene_check.h"
#include "experiments/formats/sha256.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

constexpr std::string_view kStatuses[] = {"done", "limit", "interrupted"};

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

bool known_arithmetic(std::string_view name, bool exact) {
  if (name == "exact" || name == "sturm") return exact;
  if (exact) return false;
  if (name == "double" || name == "gsl") return true;
  if (!name.starts_with("mpfr:")) return false;
  const std::optional<Integer> bits = Integer::parse(name.substr(5));
  return bits && bits->to_string() == name.substr(5) && !(*bits < Integer(2)) &&
         !(Integer(100000) < *bits);
}

bool known_build(std::string_view build) {
  return build.starts_with("kinex ") && build.size() > 6 &&
         build.find_first_not_of("0123456789.", 6) == std::string_view::npos;
}

class Checker {
 public:
  explicit Checker(LogVerdict& verdict)
      : verdict_(verdict), header_(verdict.header), digest_(digested(header_), header_.objects) {
    check_header();
  }

  void check(const LogRecord& record) {
    ++verdict_.records;
    if (record.external) {
      ++verdict_.external;
      ++(only_read_.contains(record.structure) ? verdict_.external_by_use.read
                                               : verdict_.external_by_use.maintained);
    }
    line_ = record.line;
    if (record.sequence != due_) {
      complain("sequence number " + std::to_string(record.sequence) + " where " +
               std::to_string(due_) + " is due");
    }
    due_ = record.sequence + 1;  // one complaint for a line that is missing
    const Structure* structure = check_names(record);
    if (structure != nullptr) {
      check_certificate(record, *structure);
      check_change(record, *structure);
    }
    if (header_.has_times()) check_time(record.time);
  }

  void finish(const std::optional<LogEnd>& end, std::size_t line, bool is_cut) {
    line_ = line;
    verdict_.digest = digest_.hex();
    if (!end) {
      return complain(std::string(is_cut ? "the log was cut off within this line"
                                         : "the log has no last line: it was cut off") +
                      "; run the scene again (kinex run SCENE --events FILE); kinex log shows what "
                      "is there");
    }
    verdict_.status = end->status;
    verdict_.corrupt = end->corrupt;
    if (std::find(std::begin(kStatuses), std::end(kStatuses), end->status) == std::end(kStatuses)) {
      complain(quoted(end->status) + " is no way to end; it is done, limit or interrupted");
    }
    check_reached(*end);
    check_corrupt(*end);
    check_count("records", end->records, verdict_.records);
    check_count("external records", end->external, verdict_.external);
    if (end->digest != verdict_.digest) {
      complain("the last line's digest is " + end->digest + ", that of the records is " +
               verdict_.digest);
    }
    const std::string seal = sha256_hex(end->sealed);
    if (end->seal != seal) complain("the seal is broken: the log was changed after it was written");
  }

  // The time of the last record, if the log has names and it has no defect.
  RealRoot* instant() { return time_is_well_ && last_root_ ? &*last_root_ : nullptr; }

  void complain(const std::string& what) { complain_of(line_, what); }
  void complain_of(std::size_t line, const std::string& what) {
    if (verdict_.problems.size() < LogVerdict::kMaxProblems) {
      verdict_.problems.push_back("line " + std::to_string(line) + ": " + what);
    }
  }

 private:
  struct Structure {
    std::uint8_t place = 0;
    std::unordered_map<std::string, std::uint8_t> ranks;  // of kinds
    const StructureInfo* info = nullptr;
    const std::vector<KindRule>* own = nullptr;
  };

  static std::vector<DigestedStructure> digested(const LogHeader& header) {
    std::vector<DigestedStructure> result;
    for (const LogStructure& one : header.structures) {
      result.push_back({one.label, one.structure, one.kinds});
    }
    return result;
  }

  // ---- the header

  void check_header() {
    line_ = 1;
    if (!known_arithmetic(header_.arithmetic, header_.exact)) {
      complain(quoted(header_.arithmetic) + " is no " + (header_.exact ? "exact" : "inexact") +
               " arithmetic");
    }
    if (!known_build(header_.build)) complain(quoted(header_.build) + " is no build of kinex");
    for (std::uint32_t i = 0; i < header_.objects.size(); ++i) {
      if (header_.objects[i].empty()) complain("an object without a name");
      if (!objects_.emplace(header_.objects[i], i).second) {
        complain("the object " + quoted(header_.objects[i]) + " is there twice");
      }
    }
    for (const LogStructure& one : header_.structures) check_structure(one);
  }

  void check_structure(const LogStructure& said) {
    Structure structure;
    structure.place = static_cast<std::uint8_t>(structures_.size());
    structure.info = find_structure_info(said.structure);
    structure.own = own_kinds(said.structure);
    if (structure.info == nullptr || structure.own == nullptr) {
      complain("there is no structure " + quoted(said.structure));
      structure.info = nullptr;
    } else if (structure.info->uses_key == said.key.empty()) {
      complain(said.label + (said.key.empty() ? " has no \"key\"" : " takes no key"));
    }
    check_key(said);
    std::vector<std::string_view> kinds;
    if (structure.info != nullptr) {
      for (const KindRule& rule : *structure.own) kinds.push_back(rule.kind);
      kinds = common_event_kinds(std::move(kinds));
      if (!std::equal(kinds.begin(), kinds.end(), said.kinds.begin(), said.kinds.end())) {
        complain("\"kinds\" are not those of " + said.structure);
      }
    }
    for (std::size_t i = 0; i < said.kinds.size(); ++i) {
      if (!structure.ranks.emplace(said.kinds[i], static_cast<std::uint8_t>(i)).second) {
        complain("the kind " + quoted(said.kinds[i]) + " is there twice");
      }
    }
    if (!structures_.emplace(said.label, std::move(structure)).second) {
      complain("two structures have the label " + quoted(said.label));
    }
  }

  void check_key(const LogStructure& said) {
    static constexpr std::string_view kDistance = "{\"squared_distance_to\": ";
    if (!said.key.starts_with(kDistance)) return;
    const bool known = std::any_of(objects_.begin(), objects_.end(), [&](const auto& object) {
      std::string text;
      append_json_string(text, object.first);
      return said.key.substr(kDistance.size(), said.key.size() - kDistance.size() - 1) == text;
    });
    if (!known) complain("the key of " + said.label + " names no object of the scene");
  }

  // ---- a record

  // Adds it to the digest, as far as its names are known. nullptr: they are not.
  const Structure* check_names(const LogRecord& record) {
    const auto found = structures_.find(record.structure);
    if (found == structures_.end()) {
      complain("the header knows no structure " + quoted(record.structure));
      return nullptr;
    }
    const Structure& structure = found->second;
    const auto rank = structure.ranks.find(record.kind);
    if (rank == structure.ranks.end()) {
      complain(quoted(record.kind) + " is no kind of event of " + record.structure);
      return nullptr;
    }
    digest_.head(structure.place, rank->second, record.external, record.change.has_value(),
                 record.ids.size());
    add_ids(record.ids, structure);
    if (record.change) {
      for (const auto* side : {&record.change->gone, &record.change->came}) {
        digest_.count(side->size());
        add_ids(*side, structure);
      }
    }
    return structure.info == nullptr ? nullptr : &structure;
  }

  void add_ids(const std::vector<std::string>& ids, const Structure& structure) {
    for (const std::string& id : ids) {
      const auto object = objects_.find(id);
      if (object != objects_.end()) {
        digest_.object(object->second);
      } else {
        digest_.derived(id);
        check_derived(id, structure);
      }
    }
  }

  // A vertex or an edge of a body: "ferry.v2", "tanker.e0".
  void check_derived(const std::string& id, const Structure& structure) {
    const std::size_t dot = id.rfind('.');
    const bool of_body = structure.info != nullptr && structure.info->bodies;
    if (of_body && dot != std::string::npos && dot + 2 < id.size() &&
        (id[dot + 1] == 'v' || id[dot + 1] == 'e') &&
        id.find_first_not_of("0123456789", dot + 2) == std::string::npos &&
        objects_.count(id.substr(0, dot)) == 1) {
      return;
    }
    complain("the header knows no object " + quoted(id));
  }

  // Arguments of certificates of bodies other than bodies: a pair "a|b", a point "(x, y)", a line
  // "[a, b | c]", a number.
  bool is_construction(const std::string& id) const {
    for (std::size_t bar = id.find('|'); bar != std::string::npos; bar = id.find('|', bar + 1)) {
      if (objects_.count(id.substr(0, bar)) == 1 && objects_.count(id.substr(bar + 1)) == 1) {
        return true;
      }
    }
    const bool point = id.starts_with('(') && id.ends_with(')');
    const bool line = id.starts_with('[') && id.ends_with(']');
    if (!point && !line) return Rational::parse(id).has_value();
    return id.find_first_not_of("0123456789-/, |", 1) == id.size() - 1;
  }

  // The kinds that all structures have come last.
  std::optional<CommonEvent> common(const LogRecord& record, const Structure& structure) const {
    const std::size_t rank = structure.ranks.at(record.kind);
    if (rank < structure.own->size()) return std::nullopt;
    return static_cast<CommonEvent>(rank - structure.own->size());
  }

  void check_certificate(const LogRecord& record, const Structure& structure) {
    if (!record.certificate) return;
    if (common(record, structure)) {
      complain("a record of kind " + quoted(record.kind) + " has no certificate");
    }
    const std::string& predicate = record.certificate->predicate;
    const std::optional<std::size_t> arity = arity_of(predicate);
    if (!arity) return complain("there is no predicate " + quoted(predicate));
    const std::vector<std::string>& ids = record.certificate->ids;
    if (ids.size() != *arity) {
      complain(predicate + " takes " + counted(*arity, "object", "objects") + ", not " +
               std::to_string(ids.size()));
    }
    std::unordered_set<std::string_view> seen;
    for (const std::string& id : ids) {
      // A constant may stand twice: a vertex that two bodies have in common.
      const bool again = !seen.insert(id).second;
      if (again && objects_.count(id) != 0) complain(predicate + " names " + quoted(id) + " twice");
      if (objects_.count(id) == 0 && !(structure.info->bodies && is_construction(id)) &&
          !(record.kind == "cell" && grid_line(id))) {
        complain("the header knows no object " + quoted(id));
      }
    }
  }

  void check_change(const LogRecord& record, const Structure& structure) {
    const std::optional<CommonEvent> kind = common(record, structure);
    const bool rebuild = kind == CommonEvent::kRebuild;
    if (record.reason.has_value() != rebuild) {
      complain(rebuild ? "a rebuild without a \"reason\"" : "a \"reason\" that is of no rebuild");
    } else if (rebuild && record.reason->empty()) {
      complain("an empty \"reason\"");
    }
    Effect effect = Effect::kNever;
    if (!kind) {
      effect = (*structure.own)[structure.ranks.at(record.kind)].effect;
    } else if (kind == CommonEvent::kSettled) {
      effect = Effect::kAlways;
    } else if (rebuild) {
      effect = record.change ? Effect::kAlways : Effect::kNever;
    }
    if (effect != Effect::kSometimes && record.external != (effect == Effect::kAlways)) {
      complain("an event of kind " + quoted(record.kind) + " is " +
               (record.external ? "not external here" : "external"));
    }
    const std::size_t ids = kind && *kind < CommonEvent::kSettled ? 1 : 0;
    if (kind && record.ids.size() != ids) {
      complain("a record of kind " + quoted(record.kind) + " has " +
               (ids == 1 ? "one id" : "no ids"));
    }
    if (kind == CommonEvent::kSettled && !record.change) {
      complain("\"settled\" without \"gone\" and \"came\"");
    }
    if (!record.change) return;
    if (!record.external) complain("\"gone\" and \"came\" in a record that is not external");
    check_sides(*record.change, *structure.info);
  }

  void check_sides(const LogChange& change, const StructureInfo& info) {
    const bool tuples = info.shape == Attribute::Shape::kTuples;
    if ((change.width != 0) != tuples) {
      return complain(tuples ? "\"gone\" and \"came\" are tuples of ids"
                             : "\"gone\" and \"came\" are ids, not tuples");
    }
    if (tuples && info.width != StructureInfo::kWidthOfParameter && change.width != info.width) {
      return complain("\"gone\" and \"came\" are tuples of " + std::to_string(info.width) + " ids");
    }
    if (change.gone == change.came) complain("\"gone\" and \"came\" are the same");
    for (const auto* side : {&change.gone, &change.came}) {
      if (info.shape == Attribute::Shape::kObject && side->size() > 1) {
        complain("the attribute is one object");
      }
      if (tuples) check_tuples(*side, change.width);
    }
    if (!tuples) return;
    std::unordered_set<std::string> gone;
    const auto tuple = [&change](const std::vector<std::string>& ids, std::size_t i) {
      std::string text;
      for (std::size_t k = i; k < i + change.width; ++k) text += ids[k] + '\0';
      return text;
    };
    for (std::size_t i = 0; i < change.gone.size(); i += change.width) {
      gone.insert(tuple(change.gone, i));
    }
    for (std::size_t i = 0; i < change.came.size(); i += change.width) {
      if (gone.count(tuple(change.came, i)) == 0) continue;
      complain("a tuple both in \"gone\" and in \"came\"");
    }
  }

  // Tuples ascend, and so do the ids of each; only in tuples of more than two may an id recur.
  void check_tuples(const std::vector<std::string>& ids, std::size_t width) {
    std::vector<std::size_t> last;
    for (std::size_t i = 0; i < ids.size(); i += width) {
      std::vector<std::size_t> tuple;
      for (std::size_t k = i; k < i + width; ++k) {
        const auto object = objects_.find(ids[k]);
        if (object != objects_.end()) tuple.push_back(object->second);
      }
      if (tuple.size() != width) continue;  // already reported
      const bool twice = width == 2 && tuple[0] == tuple[1];
      if (twice || !std::is_sorted(tuple.begin(), tuple.end()) || (!last.empty() && tuple <= last)) {
        return complain("tuples are in the scene's order, each tuple too");
      }
      last = std::move(tuple);
    }
  }

  // ---- times

  void check_time(const LogInstant& time) {
    if (last_ && same_text(*last_, time)) return;
    time_is_well_ = false;
    const std::string problem = instant_problem(time, header_);
    if (!problem.empty()) return complain(problem);  // it cannot be compared
    if (header_.has_names()) {
      RealRoot root = root_of(time);
      const int order = last_root_ ? compare(*last_root_, root, counters_) : -1;
      if (order > 0) complain("the time is before that of the record before it");
      if (order < 0) ++verdict_.instants;
      last_root_ = std::move(root);
      time_is_well_ = true;
    } else if (header_.has_intervals()) {
      if (last_ && time.upper < last_lower_) {
        complain("the time is before that of a record before it");
      }
      last_lower_ = last_ ? std::max(last_lower_, time.lower) : time.lower;
    }
    last_ = time;
  }

  void check_reached(const LogEnd& end) {
    if (!end.reached) {
      if (end.status != "done") complain("\"reached\" is null in a run that was stopped");
      return;
    }
    bool before = false;
    if (last_root_) before = compare(*last_root_, *end.reached, counters_) > 0;
    if (last_ && !header_.has_names() && header_.has_intervals()) {
      before = *end.reached < last_lower_;
    }
    if (before) complain("\"reached\" is before the time of the last record");
  }

  void check_corrupt(const LogEnd& end) {
    for (const LogCorruption& one : end.corrupt) {
      if (structures_.count(one.label) == 0) {
        complain("\"corrupt\" names " + quoted(one.label) +
                 ", a structure that is not in the header");
      } else if (header_.exact) {
        complain(quoted(one.label) + " is corrupt in an exact arithmetic, where nothing can be");
      }
    }
  }

  void check_count(const std::string& what, std::uint64_t said, std::uint64_t right) {
    if (said == right) return;
    complain("the last line says " + std::to_string(said) + " " + what + ", there " +
             (right == 1 ? "is " : "are ") + std::to_string(right));
  }

  LogVerdict& verdict_;
  const LogHeader& header_;
  LogDigest digest_;
  const std::set<std::string> only_read_ = labels_only_read(header_);
  std::unordered_map<std::string, std::uint32_t> objects_;
  std::unordered_map<std::string, Structure> structures_;
  std::size_t line_ = 1;
  std::uint64_t due_ = 1;  // sequence number
  std::optional<LogInstant> last_;
  std::optional<RealRoot> last_root_;
  bool time_is_well_ = false;
  Rational last_lower_;
  RootCounters counters_;
};

}  // namespace

LogVerdict check_log(std::string_view text, const std::string& file, const Scene* scene,
                     const std::string& hash) {
  LogReader reader(text, file);
  LogVerdict verdict;
  verdict.header = reader.header();
  Checker checker(verdict);
  std::optional<LogSceneCheck> of_scene;
  if (scene != nullptr) of_scene.emplace(verdict.header, *scene, hash, verdict.problems);
  if (of_scene && !of_scene->is_of_scene()) of_scene.reset();
  LogRecord record;
  while (reader.next(record)) {
    checker.check(record);
    if (!of_scene) continue;
    const std::string problem = of_scene->check(record, checker.instant());
    for (const auto& late : of_scene->late_problems()) checker.complain_of(late.line, late.problem);
    if (!problem.empty()) checker.complain(problem);
  }
  if (of_scene) {
    for (const auto& late : of_scene->late_problems(true)) checker.complain_of(late.line, late.problem);
  }
  checker.finish(reader.end(), reader.line(), reader.cut_line() != 0);
  if (!of_scene) return verdict;
  if (reader.end()) {
    const std::string problem = of_scene->check(*reader.end());
    if (!problem.empty()) checker.complain(problem);
  }
  verdict.with_scene = true;
  verdict.certificates = of_scene->certificates();
  verdict.unchecked = of_scene->unchecked();
  return verdict;
}

}  // namespace kinex::formats
