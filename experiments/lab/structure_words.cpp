// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/structure_words.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "experiments/formats/counted.h"
#include "structures/registry.h"

namespace kinex::lab {

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t kLineLength = 80;

std::string in_code(std::string_view text) { return "`" + std::string(text) + "`"; }

void add_with_comma(std::string& list, const std::string& item) {
  list += (list.empty() ? "" : ", ") + item;
}

// "0 <= delta < 1/2 (1/4)"
std::string range_of(const ParameterInfo& one) {
  std::string text = std::string(one.least) + " <= " + std::string(one.name);
  if (!one.most.empty()) text += (one.most_is_allowed ? " <= " : " < ") + std::string(one.most);
  if (!one.step.empty()) text += ", in steps of " + std::string(one.step);
  return in_code(text) + " (" + std::string(one.usual) + ")";
}

// The members of its entry in "maintain".
std::string members_of(const StructureInfo& info) {
  std::string text;
  if (info.uses_key) add_with_comma(text, in_code("key"));
  if (info.query) add_with_comma(text, in_code("query"));
  if (info.colours) add_with_comma(text, in_code("colours"));
  if (reading_of_choice(info) != nullptr) add_with_comma(text, in_code("over"));
  for (const ParameterInfo& one : info.parameters) add_with_comma(text, range_of(one));
  return text;
}

// Another structure than the usual one has the role.
bool has_other(const Reading& reading) {
  const std::vector<StructureInfo>& all = structure_infos();
  return !reading.role.empty() &&
         std::any_of(all.begin(), all.end(), [&](const StructureInfo& info) {
           return info.role == reading.role && info.name != reading.structure;
         });
}

// "`delaunay_2`, in space `delaunay_3`"
std::string read_by(const StructureInfo& info) {
  std::string text;
  for (const Reading& reading : info.reads) {
    std::string one = in_code(reading.structure);
    if (reading.axis) one += std::string(" by ") + "xyz"[*reading.axis];
    const std::string in_space = usual_structure(reading, 3);
    if (info.any_dimension && in_space != reading.structure)
      one += ", in space " + in_code(in_space);
    if (has_other(reading)) one += " or another with the role " + std::string(reading.role);
    add_with_comma(text, one);
  }
  if (!info.shares.structure.empty()) {
    add_with_comma(text, in_code(info.shares.structure) + " if it is shared");
  }
  return text;
}

std::string row(const Lines& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += cell.empty() ? " |" : " " + cell + " |";
  return text + "\n";
}

}  // namespace

std::string attribute_in_words(const StructureInfo& info) {
  switch (info.shape) {
    case Attribute::Shape::kSequence:
      return "a sequence of ids";
    case Attribute::Shape::kObject:
      return "one id";
    case Attribute::Shape::kTuples:
      if (info.width == 1) return "a set of ids";
      if (info.width == StructureInfo::kWidthOfParameter) {
        return "a set of tuples of \"" + std::string(info.parameters.front().name) + "\" ids";
      }
      return info.width == 2 ? "a set of pairs of ids"
                             : "a set of tuples of " + std::to_string(info.width) + " ids";
    case Attribute::Shape::kCycle:
      return "a cycle of ids, counter-clockwise";
    case Attribute::Shape::kOrders:
      return "an order of ids, and for every id an order of the others";
  }
  return "";
}

std::string domain_in_words(const StructureInfo& info) {
  std::string text = info.bodies                             ? "rigid convex polygons"
                     : info.extents == Extents::kRadius      ? "discs"
                     : info.extents == Extents::kHalfExtents ? "boxes or discs"
                     : info.lines == LineUse::kAlone         ? "lines"
                     : info.lines == LineUse::kWithPoints    ? "lines and points"
                     : info.graph                            ? "edges of graphs"
                                                             : "points";
  text += " in " + formats::counted(static_cast<std::uint64_t>(info.min_dimension), "axis", "axes");
  if (info.any_dimension) text += " or more";
  if (!info.has_events) return text + "; it follows no motion";
  if (info.linear()) return text + ", linear motions";
  if (info.largest_degree != StructureInfo::kAnyDegree) {
    return text + ", motions of degree " + std::to_string(info.largest_degree) + " at most";
  }
  return text +
         (info.bodies ? ", rigid motions of every degree" : ", polynomial motions of every degree");
}

Lines readings_in_words(const StructureInfo& info) {
  Lines lines;
  for (const Reading& reading : info.reads) {
    std::string line(reading.structure);
    if (reading.axis) line += std::string(" by ") + "xyz"[*reading.axis];
    const std::string in_space = usual_structure(reading, 3);
    if (info.any_dimension && in_space != reading.structure) line += ", in space " + in_space;
    std::string others;
    for (const StructureInfo& other : structure_infos()) {
      if (!reading.role.empty() && other.role == reading.role && other.name != reading.structure) {
        others += " " + std::string(other.name);
      }
    }
    if (!others.empty()) {
      line += ", or another structure with the role " + std::string(reading.role) +
              " that \"over\" names:" + others;
    }
    if (reading.passes_over) line += "; \"over\" names what that one reads";
    lines.push_back(std::move(line));
  }
  if (!info.shares.structure.empty()) {
    lines.push_back(std::string(info.shares.structure) +
                    ", where another structure of the scene can share it; else a part of its own");
  }
  return lines;
}

Lines parameters_in_words(const StructureInfo& info) {
  Lines lines;
  for (const ParameterInfo& one : info.parameters) {
    std::string line = "\"" + std::string(one.name) + "\", " + std::string(one.summary) + ": " +
                       (one.whole ? "an integer" : "a number") + " of at least " +
                       std::string(one.least);
    if (!one.most.empty()) {
      line += (one.most_is_allowed ? ", at most " : ", less than ") + std::string(one.most);
    }
    if (!one.step.empty()) line += ", in steps of " + std::string(one.step);
    lines.push_back(line + " (default " + std::string(one.usual) + ")");
  }
  return lines;
}

std::string structure_names_by_family() {
  std::size_t width = 0;
  for (const StructureInfo& info : structure_infos()) {
    width = std::max(width, family_of(info.name).size());
  }
  std::string text, line;
  std::string_view family;
  for (const StructureInfo& info : structure_infos()) {
    const std::string_view own = family_of(info.name);
    if (own != family || line.size() + 1 + info.name.size() > kLineLength) {
      text += line.empty() ? "" : line + "\n";
      line = "  " + std::string(own == family ? "" : own);
      line.resize(width + 3, ' ');
      family = own;
    }
    line += " " + std::string(info.name);
  }
  return text + line + "\n";
}

std::string structure_table(std::string_view family) {
  std::string text = row({"structure", "group", "maintains", "attribute", "takes", "reads"});
  text += row({"---", "---", "---", "---", "---", "---"});
  std::string_view last;
  for (const StructureInfo& info : structure_infos()) {
    const std::string_view own = family_of(info.name);
    if (!family.empty() && own != family) continue;
    if (family.empty() && own != last)
      text += row({"**" + std::string(own) + "**", "", "", "", "", ""});
    last = own;
    text +=
        row({in_code(info.name), info.group.empty() ? "" : in_code(info.group),
             std::string(info.summary), attribute_in_words(info), members_of(info), read_by(info)});
  }
  return text;
}

}  // namespace kinex::lab
