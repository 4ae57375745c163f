// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproduce/papers.h"

#include <algorithm>

#include "experiments/lab/family.h"

namespace kinex::reproduce {

namespace {

std::vector<lab::Paper> collect_papers() {
  std::vector<lab::Paper> all;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    for (const lab::Paper& paper : family.papers) {
      const auto known = std::find_if(all.begin(), all.end(),
                                      [&](const lab::Paper& other) { return other.name == paper.name; });
      if (known == all.end()) {
        all.push_back(paper);
      } else {
        known->parts.insert(known->parts.end(), paper.parts.begin(), paper.parts.end());
      }
    }
  }
  for (lab::Paper& paper : all) {
    std::stable_sort(paper.parts.begin(), paper.parts.end(),
                     [](const lab::PaperPart& a, const lab::PaperPart& b) { return a.place < b.place; });
  }
  return all;
}

}  // namespace

const std::vector<lab::Paper>& papers() {
  static const std::vector<lab::Paper> kPapers = collect_papers();
  return kPapers;
}

}  // namespace kinex::reproduce
