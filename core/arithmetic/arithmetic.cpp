// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/arithmetic.h"

#include <charconv>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/arithmetic/double_arithmetic.h"
#include "core/arithmetic/exact_arithmetic.h"
#include "core/arithmetic/gsl_arithmetic.h"
#include "core/arithmetic/mpfr_arithmetic.h"
#include "core/arithmetic/query_relation.h"
#include "core/arithmetic/sturm_arithmetic.h"
#include "core/arithmetic/touch.h"
#include "core/numbers/rounded_instant.h"
#include "core/numbers/show_text.h"

namespace kinex {

double Arithmetic::now_rounded() { return rounded_down(now_approximate()); }

void Arithmetic::fill(PredicateId, std::span<const ObjectId>, CoordinateTable& table) const {
  table = {};
}

void Arithmetic::signs_after(PredicateId predicate, const CoordinateTable&, std::size_t,
                             std::span<const ObjectId> first, ObjectId second, Sign* signs) {
  for (const ObjectId object : first) *signs++ = sign_after(Query(predicate, {object, second}));
}

OutOfInterval Arithmetic::out_of_interval(PredicateId predicate, const CoordinateTable&,
                                          std::size_t, std::span<const ObjectId> first,
                                          ObjectId low, ObjectId high) {
  OutOfInterval out;
  std::uint64_t bit = 1;
  for (const ObjectId object : first) {
    if (sign_after(Query(predicate, {object, low})) == Sign::kPositive) out.before |= bit;
    if (sign_after(Query(predicate, {object, high})) == Sign::kNegative) out.after |= bit;
    bit <<= 1;
  }
  return out;
}

Outlook Arithmetic::look_ahead_in_group(std::size_t, const Query& query, double limit,
                                        FailureTime& time) {
  return limit < std::numeric_limits<double>::infinity() ? look_ahead(query, limit, time)
                                                         : failure(query, time);
}

std::string Arithmetic::polynomial_model(PredicateId) const { return name(); }

void Arithmetic::visit(const Query&, const FailureTime&) {
  throw std::logic_error(name() + " cannot look from another instant");
}

void Arithmetic::leave() { throw std::logic_error(name() + " looks from no other instant"); }

namespace {

void check_fits(const Predicate& predicate, const NumberNeeds& needs) {
  const auto refuse = [&predicate](const std::string& problem) {
    throw std::logic_error("predicate " + std::string(predicate.name()) + " " + problem);
  };
  if (predicate.arity() < 1 || predicate.arity() > kMaxArity) {
    refuse("takes " + std::to_string(predicate.arity()) + " objects, from 1 to " +
           std::to_string(kMaxArity) + " can be");
  }
  if (needs.axes > 0 && predicate.dimension() > needs.axes) {
    refuse("reads " + std::to_string(predicate.dimension()) + " axes, objects have " +
           std::to_string(needs.axes) + ": its structure has to declare what it derives");
  }
}

}  // namespace

PredicateId Arithmetic::bind(std::shared_ptr<const Predicate> predicate) {
  check_fits(*predicate, needs_);
  predicates_.push_back(std::move(predicate));
  counters_.by_predicate.emplace_back();
  const PredicateId id = static_cast<PredicateId>(predicates_.size() - 1);
  opposite_.push_back(id);
  plain_.push_back(id);
  const bool touch = dynamic_cast<const FailsAtTouch*>(predicates_[id].get()) != nullptr;
  fails_at_touch_.push_back(touch);
  const std::string_view own = predicates_[id]->name();
  for (PredicateId other = id; touch && other-- > 0;) {
    if (predicates_[other]->name() != own || fails_at_touch(other)) continue;
    plain_[id] = other;
    break;
  }
  for (PredicateId other = id; other-- > 0;) {
    if (opposite_[other] != other || !predicates_[id]->negates(*predicates_[other])) continue;
    if (fails_at_touch(other) != touch) continue;
    opposite_[other] = id;
    opposite_[id] = other;
    break;
  }
  bound_predicate(id);
  return id;
}

int Arithmetic::related(const Query& a, const Query& b) const {
  const PredicateId p = plain_[a.predicate], q = plain_[b.predicate];
  if (p == q) {
    const int relation = query_relation(a, b, predicates_[p]->alternating());
    if (relation != 0 || !predicates_[p]->alternates_in_halves()) return relation;
    return has_halves_exchanged(a, b) ? -1 : 0;
  }
  return opposite_[p] == q && a.ids == b.ids ? -1 : 0;
}

const InstantName& Arithmetic::inexact_name(InstantDetail detail, std::string decimal) {
  if (name_of_now_.number == 0 || decimal != name_of_now_.decimal) ++name_of_now_.number;
  name_of_now_.detail = detail;
  name_of_now_.decimal = std::move(decimal);
  return name_of_now_;
}

std::unique_ptr<Arithmetic> make_arithmetic(std::string_view name, const Scene& scene) {
  return make_arithmetic(name, scene, needs_of_objects(scene));
}

std::unique_ptr<Arithmetic> make_arithmetic(std::string_view name, const Scene& scene,
                                            const NumberNeeds& needs) {
  if (name == "exact") return std::make_unique<ExactArithmetic>(scene, needs);
  if (name == "sturm") return make_sturm_arithmetic(scene, needs);
  if (name == "double") return make_double_arithmetic(scene, needs);
  if (name == "gsl") return make_gsl_arithmetic(scene, needs);
  if (name.substr(0, 5) == "mpfr:") {
    long bits = 0;
    const char* last = name.data() + name.size();
    const auto [end, error] = std::from_chars(name.data() + 5, last, bits);
    if (error == std::errc() && end == last && bits >= 2 && bits <= 100000) {
      return make_mpfr_arithmetic(scene, needs, bits);
    }
  }
  throw std::invalid_argument(
      "unknown arithmetic " + show_text(name) +
      "; choose exact, sturm, double, gsl or mpfr:P with 2 <= P <= 100000 bits");
}

}  // namespace kinex
