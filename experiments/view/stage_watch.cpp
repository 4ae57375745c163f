// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/stage_watch.h"

#include <algorithm>
#include <utility>

namespace kinex::view {

namespace {

// The highest stage with a count since `before`; kDouble if none.
Stage highest(const StageCounts& before, const StageCounts& after) {
  for (int stage = kStages - 1; stage > 0; --stage) {
    const auto i = static_cast<std::size_t>(stage);
    if (after[i] != before[i]) return static_cast<Stage>(stage);
  }
  return Stage::kDouble;
}

}  // namespace

StageWatch::StageWatch(std::unique_ptr<Arithmetic> arithmetic)
    : Arithmetic(arithmetic->needs()), inner_(std::move(arithmetic)) {}

namespace {

SignNow* signs_of(Arithmetic* arithmetic) { return dynamic_cast<SignNow*>(arithmetic); }

}  // namespace

ExactStageWatch::ExactStageWatch(std::unique_ptr<Arithmetic> arithmetic)
    : StageWatch(std::move(arithmetic)), signs_(dynamic_cast<SignNow*>(&inner())) {}

std::unique_ptr<StageWatch> make_stage_watch(std::unique_ptr<Arithmetic> arithmetic) {
  if (signs_of(arithmetic.get()) == nullptr) {
    return std::make_unique<StageWatch>(std::move(arithmetic));
  }
  return std::make_unique<ExactStageWatch>(std::move(arithmetic));
}

std::size_t StageWatch::Hash::operator()(const Query& query) const {
  std::uint64_t hash = query.predicate;
  for (const ObjectId id : query.ids) hash = (hash ^ id) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

std::optional<StagesUsed> StageWatch::stages(const Query& query) const {
  const auto found = stages_.find(query);
  if (found == stages_.end()) return std::nullopt;
  return found->second;
}

template <class Search>
Outlook StageWatch::note_search(const Query& query, const Search& search) {
  const PredicateCounters before = inner_->counters().by_predicate[query.predicate];
  const Outlook outlook = search();
  if (outlook == Outlook::kFails || outlook == Outlook::kFailsNow) {
    const PredicateCounters& after = inner_->counters().by_predicate[query.predicate];
    stages_[query] = {
        std::max(highest(before.failures, after.failures), highest(before.looks, after.looks)),
        Stage::kDouble};
  }
  return outlook;
}

template <class Comparison>
int StageWatch::note_order(const Query& a, const Query* b, const Comparison& comparison) {
  const StageCounts before = inner_->counters().comparisons;
  const int order = comparison();
  const Stage stage = highest(before, inner_->counters().comparisons);
  if (stage == Stage::kDouble) return order;
  raise(a, stage);
  if (b != nullptr) raise(*b, stage);
  return order;
}

void StageWatch::raise(const Query& query, Stage stage) {
  const auto found = stages_.find(query);
  if (found != stages_.end()) found->second.ordered = std::max(found->second.ordered, stage);
}

Outlook StageWatch::failure(const Query& query, FailureTime& time) {
  return note_search(query, [&] { return inner_->failure(query, time); });
}

Outlook StageWatch::look_ahead(const Query& query, double limit, FailureTime& time) {
  return note_search(query, [&] { return inner_->look_ahead(query, limit, time); });
}

Outlook StageWatch::look_further(const Query& query, double from, double limit, FailureTime& time) {
  return note_search(query, [&] { return inner_->look_further(query, from, limit, time); });
}

int StageWatch::compare(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb) {
  return note_order(a, &b, [&] { return inner_->compare(a, ta, b, tb); });
}

int StageWatch::compare_with_now(const Query& a, FailureTime& ta) {
  return note_order(a, nullptr, [&] { return inner_->compare_with_now(a, ta); });
}

int StageWatch::compare(const Query& a, FailureTime& ta, const Rational& t) {
  return note_order(a, nullptr, [&] { return inner_->compare(a, ta, t); });
}

std::string_view stage_name(Stage stage) {
  switch (stage) {
    case Stage::kDouble:
      return "double";
    case Stage::kWide:
      return "128-bit integers";
    case Stage::kMultiprecision:
      return "MPFR";
    case Stage::kExact:
      return "exact integers";
  }
  return "";
}

}  // namespace kinex::view
