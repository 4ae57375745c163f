// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/run_report.h"

#include <cstdio>

#include "experiments/formats/attribute_json.h"
#include "experiments/formats/counted.h"

namespace kinex::formats {

namespace {

std::string shortened(std::string text) {
  constexpr std::size_t kLongest = 100;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + " ..";
  return text;
}

std::string cell(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : " " + text;
}

std::string row_of(const StructureLedger& ledger) {
  std::string text;
  for (const std::uint64_t count :
       {ledger.processed, ledger.external, ledger.internal, ledger.failures, ledger.rebuilds,
        ledger.simultaneous_groups, ledger.max_live, ledger.max_per_object,
        ledger.audit_violations}) {
    text += cell(std::to_string(count), 11);
  }
  return text;
}

// A structure is rebuilt where certificates fail together in a way that no repairs resolve, and where points
// leave a common line. A few rebuilds more are no sign of anything.
constexpr std::uint64_t kFewRebuilds = 3;

// Of a structure that is rebuilt more often than degenerate instants and changes of the scene explain; else empty.
std::string rebuild_warning(const std::string& label, const StructureLedger& ledger, bool exact) {
  const std::uint64_t explained = ledger.simultaneous_groups + ledger.motion_updates +
                                  ledger.insertions + ledger.erasures;
  if (ledger.rebuilds <= explained + kFewRebuilds) return "";
  return "warning   " + label + " was rebuilt " + counted(ledger.rebuilds, "time", "times") +
         "; degenerate instants and changes of the scene explain " + std::to_string(explained) +
         " at most: its counts are those of rebuilds rather than of repairs" +
         (exact ? "" : "; compare with --arithmetic exact") + "\n";
}

std::string last_line(const Simulator& simulator, const RunOutcome& outcome) {
  const RunCounts counts = counts_of(simulator);
  char times[160];
  std::snprintf(times, sizeof times,
                "; CPU: setup %.3f s, simulate %.3f s, report %.3f s, audit %.3f s\n",
                simulator.seconds_setup(), simulator.seconds_simulate(), simulator.seconds_report(),
                simulator.seconds_audit());
  return std::string(status_name(outcome.status)) + ": " +
         counted(counts.events(), "event", "events") + " (" + std::to_string(counts.external) +
         " external, " + std::to_string(counts.internal) + " internal) from " +
         counted(counts.failures, "certificate failure", "certificate failures") + " at " +
         counted(counts.instants, "instant", "instants") + "; " +
         counted(counts.records, "log record", "log records") + times;
}

// at 3  rank_kd_tree_2 in [20, 80] x [20, 80]: ["a", "b"] by 7 nodes and 12 signs
std::string answer_lines(const Sample& sample, const BoxAnswer& query,
                         const Simulator& simulator) {
  std::string box, text;
  for (const auto& [low, high] : query.box) {
    box += std::string(box.empty() ? "" : " x ") + "[" + low.to_string() + ", " +
           high.to_string() + "]";
  }
  for (const BoxAnswer::OfStructure& answer : query.answers) {
    std::string ids;
    JsonWriter json(ids);
    write_attribute(json, {Attribute::Shape::kSequence, answer.ids}, simulator.scene());
    text += "at " + sample.t.to_string() + "  " + simulator.label(answer.structure) + " in " + box +
            ": " + ids + " by " + counted(answer.counts.nodes, "node", "nodes") + " and " +
            counted(answer.counts.signs, "sign", "signs") + "\n";
  }
  return text;
}

}  // namespace

std::string describe_results(const Simulator& simulator, const RunOutcome& outcome) {
  std::string text = "\n" + cell("", 24);
  for (const char* column : {"events", "external", "internal", "failures", "rebuilds", "groups",
                             "max live", "max/object", "violations"}) {
    text += cell(column, 11);
  }
  text += "\n";
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    std::string label = simulator.label(id);
    if (label.size() < 24) label.resize(24, ' ');
    text += label + row_of(simulator.ledger(id)) + "\n";
  }
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    for (const auto& [reason, count] : simulator.ledger(id).rebuild_reasons) {
      text += "rebuilt   " + simulator.label(id) + ", " + counted(count, "time", "times") + ": " +
              reason + "\n";
    }
    text += rebuild_warning(simulator.label(id), simulator.ledger(id), simulator.arithmetic().is_exact());
  }
  if (simulator.is_torn()) {
    text += "bounds    not judged: the run was stopped in the midst of an instant or its set-up\n";
  }
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    for (const BoundCheck& bound : outcome.bounds[id]) {
      text += "bound     " + bound.id + ": " + bound.observed.to_string() +
              " <= " + shortened(bound.bound.to_string()) +
              (bound.holds ? " holds" : " DOES NOT HOLD") + "\n";
    }
  }
  for (const Sample& sample : outcome.samples) {
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      std::string value;
      JsonWriter json(value);
      write_attribute(json, sample.values[id], simulator.scene());
      text += "at " + sample.t.to_string() + "  " + simulator.label(id) + " " + value + "\n";
    }
    for (const BoxAnswer& query : sample.queries) text += answer_lines(sample, query, simulator);
  }
  return text + last_line(simulator, outcome);
}

std::vector<std::string> failures_of(const Simulator& simulator, const RunOutcome& outcome) {
  std::vector<std::string> failures;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& ledger = simulator.ledger(id);
    if (ledger.corrupt)
      failures.push_back(simulator.label(id) + " is corrupt: " + ledger.corruption);
    for (const BoundCheck& bound : outcome.bounds[id]) {
      if (bound.holds) continue;
      failures.push_back(simulator.label(id) + ": bound " + bound.id + " is broken: observed " +
                         bound.observed.to_string() + ", bound " + bound.bound.to_string() + " (" +
                         bound.source + ")");
    }
  }
  for (const std::string& violation : simulator.violations())
    failures.push_back("audit: " + violation);
  return failures;
}

}  // namespace kinex::formats
