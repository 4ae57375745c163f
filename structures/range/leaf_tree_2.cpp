// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/leaf_tree_2.h"

namespace kinex {

void LeafTree2::changing() {
  if (is_changing_) return;
  before_ = leaves();
  is_changing_ = true;
  kernel_->settle_later(id_);
}

void LeafTree2::instant_over() {
  if (!is_changing_) return;
  is_changing_ = false;
  const std::vector<ObjectId> now = leaves();
  if (now != before_) kernel_->report_settled(id_, before_, now);
}

}  // namespace kinex
