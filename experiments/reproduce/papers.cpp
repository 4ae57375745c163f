// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/papers.h"

#include <algorithm>

#include "experiments/lab/family.h"

namespace kinex {

namespace {

std::vector<Paper> collect_papers() {
  std::vector<Paper> all;
  for (const FamilyExperiments& family : experiment_families()) {
    for (const Paper& paper : family.papers) {
      const auto known = std::find_if(all.begin(), all.end(),
                                      [&](const Paper& other) { return other.name == paper.name; });
      if (known == all.end()) {
        all.push_back(paper);
      } else {
        known->parts.insert(known->parts.end(), paper.parts.begin(), paper.parts.end());
      }
    }
  }
  for (Paper& paper : all) {
    std::stable_sort(paper.parts.begin(), paper.parts.end(),
                     [](const PaperPart& a, const PaperPart& b) { return a.place < b.place; });
  }
  return all;
}

}  // namespace

const std::vector<Paper>& papers() {
  static const std::vector<Paper> kPapers = collect_papers();
  return kPapers;
}

}  // namespace kinex
