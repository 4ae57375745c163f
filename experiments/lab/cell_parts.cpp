// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/cell_parts.h"

#include <utility>

namespace kinex::lab {

namespace {

constexpr int kAuditedSize = 64;  // objects up to which every event is audited

Expectation expect(std::string claim, ExpectationKind kind, Quantity quantity, std::string source) {
  Expectation expectation;
  expectation.claim = std::move(claim);
  expectation.kind = kind;
  expectation.quantity = std::move(quantity);
  expectation.source = std::move(source);
  return expectation;
}

}  // namespace

Expectation expect_exactly(std::string claim, Quantity quantity, Integer count,
                           std::string source) {
  Expectation expectation =
      expect(std::move(claim), ExpectationKind::kExact, std::move(quantity), std::move(source));
  expectation.exact = std::move(count);
  return expectation;
}

Expectation expect_mean(std::string claim, Quantity quantity, double reference,
                        std::string source) {
  Expectation expectation =
      expect(std::move(claim), ExpectationKind::kMean, std::move(quantity), std::move(source));
  expectation.reference = reference;
  return expectation;
}

Expectation expect_witness(std::string claim, Quantity quantity, Integer (*count)(const Scene&),
                           std::string source) {
  Expectation expectation =
      expect(std::move(claim), ExpectationKind::kWitness, std::move(quantity), std::move(source));
  expectation.witness = count;
  return expectation;
}

Cell worst_case_cell(std::string structure, std::string workload, int n, int degree, double cost) {
  Cell cell;
  cell.question = "Is the largest possible number of events reached?";
  cell.structure = std::move(structure);
  cell.workload = std::move(workload);
  cell.parameters.n = n;
  cell.parameters.degree = degree;
  cell.family = "worst case";
  cell.bounded = true;
  if (degree > 1) cell.family += ", degree " + std::to_string(degree);
  cell.audit = n <= kAuditedSize ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.cost = cost;
  return cell;
}

}  // namespace kinex::lab
