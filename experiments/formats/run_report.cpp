// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/run_report.h"

#include <algorithm>
#include <cstdio>

#include "experiments/formats/attribute_json.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/plain_text.h"

namespace kinex::formats {

namespace {

std::string shortened(std::string text) {
  constexpr std::size_t kLongest = 100;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + " ..";
  return text;
}

std::string label_of(const Simulator& simulator, StructureId id) {
  return plain(simulator.label(id));
}

constexpr std::size_t kLeastLabel = 24, kLeastCount = 11;

using Row = std::vector<std::string>;

Row head_row() {
  return {"",         "events", "external", "internal",   "failures",
          "rebuilds", "groups", "max live", "max/object", "violations"};
}

Row row_of(const std::string& label, const StructureLedger& ledger) {
  Row row{label};
  for (const std::uint64_t count :
       {ledger.processed, ledger.external, ledger.internal, ledger.failures, ledger.rebuilds,
        ledger.simultaneous_groups, ledger.max_live, ledger.max_per_object,
        ledger.audit_violations}) {
    row.push_back(std::to_string(count));
  }
  return row;
}

// Labels flush left, counts flush right, each column as wide as its longest field.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), kLeastCount);
  widths.front() = kLeastLabel;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size() + (i == 0 ? 0 : 1));
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - row[i].size(), ' ');
      text += i == 0 ? row[i] + space : space + row[i];
    }
    text += "\n";
  }
  return text;
}

// What the column "groups" counts, if there is something in it.
std::string groups_note(const Simulator& simulator) {
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    if (simulator.ledger(id).simultaneous_groups > 0)
      return "groups    instants at which several certificates of a structure fail\n";
  }
  return "";
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

// "sorted_list.swaps", and of a structure with a label of its own "north: sorted_list.swaps".
std::string bound_name(const std::string& id, const std::string& label) {
  return id.starts_with(label + ".") ? id : label + ": " + id;
}

// "12 events (5 external, 7 internal) from 10 certificate failures"
std::string events_text(const RunCounts& counts) {
  return counted(counts.events(), "event", "events") + " (" + std::to_string(counts.external) +
         " external, " + std::to_string(counts.internal) + " internal) from " +
         counted(counts.failures, "certificate failure", "certificate failures");
}

std::string last_line(const Simulator& simulator, const RunOutcome& outcome) {
  const CountsByUse counts = counts_by_use(simulator);
  const std::string read =
      counts.read.records == 0 && counts.read.events() == 0
          ? ""
          : ", and " + events_text(counts.read) + " of structures that these read,";
  char times[160];
  std::snprintf(times, sizeof times,
                "; CPU: setup %.3f s, simulate %.3f s, report %.3f s, audit %.3f s\n",
                simulator.seconds_setup(), simulator.seconds_simulate(), simulator.seconds_report(),
                simulator.seconds_audit());
  return std::string(status_name(outcome.status)) + ": " + events_text(counts.maintained) + read +
         " at " + counted(counts.maintained.instants, "instant", "instants") + "; " +
         counted(counts.maintained.records + counts.read.records, "log record", "log records") +
         times;
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
    text += "at " + sample.t.to_string() + "  " + label_of(simulator, answer.structure) + " in " + box +
            ": " + plain(ids) + " by " + counted(answer.counts.nodes, "node", "nodes") + " and " +
            counted(answer.counts.signs, "sign", "signs") + "\n";
  }
  return text;
}

}  // namespace

std::string describe_results(const Simulator& simulator, const RunOutcome& outcome) {
  std::vector<Row> rows{head_row()};
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    rows.push_back(row_of(label_of(simulator, id), simulator.ledger(id)));
  }
  std::string text = "\n" + aligned(rows) + groups_note(simulator);
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    for (const auto& [reason, count] : simulator.ledger(id).rebuild_reasons) {
      text += "rebuilt   " + label_of(simulator, id) + ", " + counted(count, "time", "times") + ": " +
              reason + "\n";
    }
    text += rebuild_warning(label_of(simulator, id), simulator.ledger(id), simulator.arithmetic().is_exact());
  }
  if (simulator.is_torn()) {
    text += "bounds    not judged: the run was stopped in the midst of an instant or its set-up\n";
  }
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    for (const BoundCheck& bound : outcome.bounds[id]) {
      text += "bound     " + bound_name(bound.id, label_of(simulator, id)) + ": " +
              bound.observed.to_string() + " <= " + shortened(bound.bound.to_string()) +
              (bound.holds ? " holds" : " DOES NOT HOLD") + "\n";
    }
  }
  return text + describe_samples(simulator, outcome) + last_line(simulator, outcome);
}

std::string describe_samples(const Simulator& simulator, const RunOutcome& outcome) {
  std::string text;
  for (const Sample& sample : outcome.samples) {
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      std::string value;
      JsonWriter json(value);
      write_attribute(json, sample.values[id], simulator.scene());
      text += "at " + sample.t.to_string() + "  " + label_of(simulator, id) + " " + plain(value) + "\n";
    }
    for (const BoxAnswer& query : sample.queries) text += answer_lines(sample, query, simulator);
  }
  return text;
}

std::vector<std::string> failures_of(const Simulator& simulator, const RunOutcome& outcome) {
  std::vector<std::string> failures;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& ledger = simulator.ledger(id);
    if (ledger.corrupt)
      failures.push_back(label_of(simulator, id) + " is corrupt: " + ledger.corruption);
    for (const BoundCheck& bound : outcome.bounds[id]) {
      if (bound.holds) continue;
      failures.push_back(label_of(simulator, id) + ": bound " + bound.id + " is broken: observed " +
                         bound.observed.to_string() + ", bound " + bound.bound.to_string() + " (" +
                         bound.source + ")");
    }
  }
  // An audit finds again that a structure is corrupt.
  const auto is_told = [&](const std::string& violation) {
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      if (simulator.ledger(id).corrupt &&
          violation.starts_with(simulator.label(id) + ": corrupt: ")) {
        return true;
      }
    }
    return false;
  };
  for (const std::string& violation : simulator.violations()) {
    if (!is_told(violation)) failures.push_back("audit: " + violation);
  }
  return failures;
}

}  // namespace kinex::formats
