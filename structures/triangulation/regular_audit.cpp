// SPDX-License-Identifier: GPL-3.0-or-later
// RegularTriangulation: bounds and invariants.
#include <string>
#include <utility>

#include "structures/parts/binomial.h"
#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/regular_triangulation.h"

namespace kinex {
namespace {

// What is counted, in each dimension. D: the largest degree of motions and weights.
struct Terms {
  const char *certificates, *compactness, *events, *tied, *responsiveness;
  // Each is times D and the number of sets of kCorners + 1, or of kCorners, objects.
  int powers, orientations, tied_powers, tied_orientations;
  int most_created;
};
constexpr Terms kPlaneTerms{
    "Euler's formula: 3n' - 3 edges of the closed triangulation of n' vertices; 4 for each hidden "
    "point",
    "3n' - 3 + 4 (n - n') for n' >= 3 vertices: at most 4n - 6",
    "each power changes sign 4D times, each orientation 2D times: 4D C(n,4) + 2D C(n,3)",
    "four points change at a root of their power, or of their four orientations; three of the hull "
    "at one "
    "of their orientation, or of their three angles: 8D C(n,4) + 6D C(n,3)",
    "5 certificates for a flip, 6 for a point that shows, 7 for one that hides",
    4,
    2,
    8,
    6,
    7};
constexpr Terms kSpaceTerms{
    "Euler's formula on the 3-sphere: 2 (E - V) facets of the closed triangulation; 5 for each "
    "hidden "
    "point; of points in one plane 3n' - 3, and 4 for each hidden one",
    "2 (E - V) + 5 (n - n') for n' >= 4 vertices, V = n' + 1, E <= C(n' + 1, 2): at most (n + 1)(n "
    "- 2)",
    "each power changes sign 5D times, each orientation 3D times: 5D C(n,5) + 3D C(n,4)",
    "five points change at a root of their power, or of their five orientations; four of the hull "
    "at one "
    "of their orientation, or of the angles at their six edges: 15D C(n,5) + 24D C(n,4)",
    "9 certificates for a flip, 10 for a point that shows, 9 for one that hides",
    5,
    3,
    15,
    24,
    10};

}  // namespace

template <class Complex>
std::vector<BoundCheck> RegularTriangulation<Complex>::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  if (this->corrupt_) return checks;
  bounds_of_state(context, 0, checks);
  bounds_of_events(context, "", checks);
  return checks;
}

template <class Complex>
void RegularTriangulation<Complex>::bounds_of_state(const BoundContext& context, std::size_t more,
                                                    std::vector<BoundCheck>& checks) const {
  const Terms& terms = Complex::kAxes == 2 ? kPlaneTerms : kSpaceTerms;
  const auto id = [this](const char* what) { return std::string(this->name()) + "." + what; };
  const StructureLedger& ledger = *context.ledger;
  BoundCheck check;
  check.id = id("certificates");
  check.source = terms.certificates;
  check.bound = counted(more);
  if (!this->flat_) {
    const std::size_t vertices = this->store_.vertices();
    std::uint64_t facets = 3 * vertices - 3;
    if constexpr (Complex::kAxes == 3) {
      std::vector<Cell> star;
      Complex::star(this->store_, this->store_.infinity(), star);
      // The hull has E - F + 2 vertices, and F ghosts, three edges to each two.
      const std::size_t at_infinity = 3 * star.size() / 2 - star.size() + 2;
      facets = 2 * (edges().size() + at_infinity - vertices - 1);
    }
    check.bound = counted(facets + kClaims * hidden().size() + more);
  }
  check.observed = counted(ledger.live);
  check.holds = check.bound == check.observed;
  checks.push_back(std::move(check));
  const Integer n = counted(context.objects());
  const Integer most_live =
      Complex::kAxes == 2 ? Integer(4) * n - Integer(6) : (n + Integer(1)) * (n - Integer(2));
  checks.push_back(at_most(id("compactness"), terms.compactness,
                           most_live.sign() < 0 ? Integer(0) : most_live,
                           counted(ledger.max_live)));
  const Integer most_cells = Complex::kAxes == 2
                                 ? Integer(2) * n - Integer(2)
                                 : floor_divide((n + Integer(1)) * (n - Integer(2)), Integer(2));
  checks.push_back(
      at_most(id("largest_sew"), "the cells of the largest part that was sewn: not all of them",
              most_cells.sign() < 0 ? Integer(0) : most_cells, counted(this->largest_sew())));
}

template <class Complex>
void RegularTriangulation<Complex>::bounds_of_events(const BoundContext& context,
                                                     const std::string& prefix,
                                                     std::vector<BoundCheck>& checks) const {
  const Terms& terms = Complex::kAxes == 2 ? kPlaneTerms : kSpaceTerms;
  const auto id = [&](const char* what) { return std::string(this->name()) + "." + prefix + what; };
  const StructureLedger& ledger = *context.ledger;
  // The theorems count changes in general position; degenerate instants may fail more certificates.
  if (!context.plain() || ledger.rebuilds != 0 || this->sews_ != 0 || this->blocks_ != 0 ||
      waits_ != 0) {
    return;
  }
  const Integer n = counted(context.objects());
  const auto most = [&](int powers, int orientations) {
    const Integer d(context.degree);
    return Integer(powers) * d * binomial(n, static_cast<int>(kClaims)) +
           Integer(orientations) * d * binomial(n, static_cast<int>(Complex::kCorners));
  };
  if (ties_ != 0) {
    checks.push_back(at_most(id("events"), terms.tied,
                             most(terms.tied_powers, terms.tied_orientations), counted(changes_)));
    return;
  }
  const Integer plain = most(terms.powers, terms.orientations);
  checks.push_back(at_most(id("events"), terms.events, plain, counted(changes_)));
  checks.push_back(
      at_most(id("witnesses"), terms.events, plain, counted(witnesses_.line().failures)));
  checks.push_back(at_most(id("responsiveness"), terms.responsiveness, Integer(terms.most_created),
                           counted(ledger.created_per_event.max)));
}

template <class Complex>
void RegularTriangulation<Complex>::check_invariants(AuditReport& report) const {
  for (ObjectId id = 0; id < present_.size(); ++id) {
    const Witness& witness = witness_[id];
    const bool wanted = present_[id] && !this->flat_ && !this->store_.has(id);
    report.check(witness.there() == wanted && (present_[id] || !this->store_.has(id)),
                 [&] { return named("a vertex with a witness, or hidden without one:", {id}); });
    if (!witness.there()) continue;
    for (std::size_t i = 0; i < kClaims; ++i) {
      report.check(witnesses_.holds(witness.certificates[i], witness_query(id, i), id),
                   [&] { return named("a wrong certificate of hidden point", {id}); });
    }
    report.check(this->geometry_.orientation(witness.corners) == Sign::kPositive &&
                     !this->geometry_.below(witness.corners, id),
                 [&] { return named("a witness that proves nothing, of point", {id}); });
  }
  report.check(waiting_.empty(), [] { return std::string("hidden points wait for a witness"); });
  report.check(!this->flat_ || Complex::cells(this->store_) == 0,
               [] { return std::string("cells of points that have none"); });
  report.check(this->untold_.size() == 0,
               [] { return std::string("cells that were not reported"); });
  const std::string defect = this->store_.defect();
  report.check(defect.empty(), [&] { return defect; });
  if (!defect.empty()) return;
  for (Cell c = 0; c < Complex::capacity(this->store_); ++c) {
    if (!this->store_.live(c)) continue;
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      const Facet mate = Complex::mate(this->store_, f);
      if (f > mate) continue;
      const CertificateId label = this->store_.label(f);
      const auto holds = [&](Facet tag) {
        const bool tie = this->kernel_->sign_after(this->claim_of(tag)) == Sign::kZero;
        return this->facets_.holds(label, tie ? this->tie_claim_of(tag) : this->claim_of(tag), tag);
      };
      const auto text = [&](const char* what) {
        std::string facet = "facet";
        for (const ObjectId v : Complex::simplex(this->store_, c)) {
          if (v != this->store_.apex(f)) facet += " " + std::to_string(v);
        }
        return facet + what;
      };
      report.check(holds(f) || holds(mate),
                   [&] { return text(" has no certificate or another one's"); });
      report.check(!this->facets_.is_tie(label), [&] { return text(" is identically flat"); });
    }
  }
}

template std::vector<BoundCheck> RegularTriangulation<PlaneComplex>::bounds(
    const BoundContext&) const;
template std::vector<BoundCheck> RegularTriangulation<SpaceComplex>::bounds(
    const BoundContext&) const;
template void RegularTriangulation<SpaceComplex>::bounds_of_state(const BoundContext&, std::size_t,
                                                                  std::vector<BoundCheck>&) const;
template void RegularTriangulation<SpaceComplex>::bounds_of_events(const BoundContext&,
                                                                   const std::string&,
                                                                   std::vector<BoundCheck>&) const;
template void RegularTriangulation<PlaneComplex>::bounds_of_events(const BoundContext&,
                                                                   const std::string&,
                                                                   std::vector<BoundCheck>&) const;
template void RegularTriangulation<PlaneComplex>::check_invariants(AuditReport&) const;
template void RegularTriangulation<SpaceComplex>::check_invariants(AuditReport&) const;

}  // namespace kinex
