// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_uses.h"

#include <algorithm>
#include <string_view>

namespace kinex::formats {

namespace {

// "", ":x", and that with apostrophes, where a request has the label itself.
bool is_ending(std::string_view text) {
  if (text.size() >= 2 && text[0] == ':' && std::string_view("xyz").find(text[1]) != text.npos)
    text.remove_prefix(2);
  return text.find_first_not_of('\'') == text.npos;
}

bool is_for(const LogStructure& one, const LogStructure& reader) {
  const std::string begin = reader.label + "." + one.structure;
  return one.label.starts_with(begin) &&
         is_ending(std::string_view(one.label).substr(begin.size()));
}

}  // namespace

std::set<std::string> labels_only_read(const LogHeader& header) {
  std::set<std::string> labels;
  for (const LogStructure& one : header.structures) {
    if (std::any_of(header.structures.begin(), header.structures.end(),
                    [&one](const LogStructure& reader) { return is_for(one, reader); })) {
      labels.insert(one.label);
    }
  }
  return labels;
}

std::string ExternalByUse::text() const {
  return std::to_string(maintained) + " external" +
         (read == 0 ? "" : " (and " + std::to_string(read) + " of structures that these read)");
}

}  // namespace kinex::formats
