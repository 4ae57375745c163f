// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/norm_lengths.h"

namespace kinex {

Item NormLengths::find(const Pair& pair) const {
  const auto place = item_of_.find(pair);
  return place == item_of_.end() ? kNoItem : place->second;
}

Item NormLengths::add(const Form& form) {
  Item item;
  if (free_.empty()) {
    item = static_cast<Item>(forms_.size());
    forms_.push_back(form);
  } else {
    item = free_.back();
    free_.pop_back();
    forms_[item] = form;
  }
  item_of_.insert_or_assign(form.pair(), item);
  return item;
}

void NormLengths::remove(Item item) {
  const auto place = item_of_.find(forms_[item].pair());
  if (place != item_of_.end() && place->second == item) item_of_.erase(place);
  free_.push_back(item);
}

std::size_t NormLengths::bytes() const {
  return forms_.capacity() * sizeof(Form) + item_of_.size() * (sizeof(Pair) + 48) +
         free_.capacity() * sizeof(Item) + order_.bytes();
}

}  // namespace kinex
