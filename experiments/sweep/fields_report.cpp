// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/fields_report.h"

#include <utility>

#include "experiments/formats/json_writer.h"

namespace kinex::sweep {

CellReport report_of(Outcome outcome, std::string message, const lab::Fields& fields) {
  CellReport report;
  report.outcome = outcome;
  report.message = std::move(message);
  report.exact = "{\"fields\":";
  formats::append_json_string(report.exact, fields.exact);
  report.exact += '}';
  report.times = fields.times;
  return report;
}

std::optional<lab::Fields> fields_of(const Record& record) {
  if (record.exact.empty()) return std::nullopt;
  const formats::JsonDocument document = formats::parse_json(record.exact, "exact fields");
  const formats::JsonValue& exact = *document;
  const formats::JsonValue* fields = exact.find("fields");
  if (fields == nullptr) return std::nullopt;
  return lab::Fields{std::string(fields->text()), record.times};
}

}  // namespace kinex::sweep
