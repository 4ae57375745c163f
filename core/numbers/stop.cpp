// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/stop.h"

namespace kinex {

Deadline::Deadline(double seconds, const std::atomic<bool>* interrupt)
    : interrupt_(interrupt), limited_(seconds > 0 && seconds < 1e9) {
  if (limited_) {
    left_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  resume();
}

void Deadline::resume() {
  if (running_ || (!limited_ && interrupt_ == nullptr)) return;
  running_ = true;
  end_ = Clock::now() + left_;
}

void Deadline::pause() {
  if (!running_) return;
  running_ = false;
  left_ = end_ - Clock::now();
}

bool Deadline::note_due() {
  if (is_due_) return true;
  if (interrupt_ != nullptr && interrupt_->load(std::memory_order_relaxed)) interrupted_ = true;
  if (!interrupted_ && !limited_) return false;
  const Clock::time_point now = Clock::now();
  if (!interrupted_ && now < end_) return false;
  is_due_ = true;
  due_since_ = interrupted_ ? now : end_;
  return true;
}

void Deadline::throw_if_late() const {
  if (Clock::now() - due_since_ > kGrace) throw Stopped();
}

}  // namespace kinex
