// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a reproduced paper: claims.json, and the README.md made from it.
#ifndef KINEX_EXPERIMENTS_REPRODUCE_PAPER_FILES_H
#define KINEX_EXPERIMENTS_REPRODUCE_PAPER_FILES_H

#include <string>
#include <vector>

#include "experiments/lab/machine.h"
#include "experiments/lab/part.h"

namespace kinex::reproduce {

struct ReproducedPart {
  const lab::PaperPart* part;
  lab::PartReport report;
  bool interrupted = false;
  std::vector<std::string> troubles;  // audits and bounds that failed
};

struct ReproductionFacts {
  std::string command;
  lab::BuildFacts build;
  lab::MachineFacts machine;
};

std::string claims_json(const lab::Paper& paper, const std::vector<ReproducedPart>& parts,
                        const ReproductionFacts& facts);
// `drawn`: the figures are there as SVG files.
std::string paper_readme(const lab::Paper& paper, const std::vector<ReproducedPart>& parts,
                         const ReproductionFacts& facts, bool drawn);

}  // namespace kinex::reproduce

#endif
