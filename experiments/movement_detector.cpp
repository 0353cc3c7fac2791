#include "experiments/movement_detector.h"

#include <algorithm>
#include <cmath>

namespace tactus::experiments {

MovementDetector::MovementDetector(const StrokeSettings& settings, double lowest_been_mm)
    : settings_(settings),
      half_window_(static_cast<std::size_t>(std::lround(settings.speed_window_s / 2 / EvenPositions::kStepS))),
      pause_steps_(static_cast<std::size_t>(std::lround(settings.longest_pause_s / EvenPositions::kStepS))),
      lowest_been_mm_(lowest_been_mm) {}

void MovementDetector::advance(const EvenPositions& positions, bool ended) {
  const std::size_t margin = ended ? 0 : half_window_;
  for (; decided_ + margin < positions.size(); ++decided_) {
    const double speed_mm_s = slopeAt(positions, decided_);
    const double position_mm = positions.at(decided_);
    speeds_mm_s_.push_back(speed_mm_s);
    lookForward(decided_, position_mm, speed_mm_s);
    lookBack(decided_, position_mm, speed_mm_s);
  }
  if (!ended || decided_ == 0) return;
  if (phase_ == Phase::kMoving) close(decided_ - 1, furthest_mm_ - begin_mm_, true);
  if (phase_ == Phase::kPausing) close(paused_at_, furthest_mm_ - begin_mm_, false);
  back_.reset();
}

std::optional<Movement> MovementDetector::take() {
  if (found_.empty()) return std::nullopt;
  const Movement movement = found_.front();
  found_.pop_front();
  return movement;
}

std::size_t MovementDetector::earliestNeeded() const noexcept {
  std::size_t earliest = decided_;
  if (phase_ != Phase::kIdle) earliest = std::min(earliest, forward_.begin);
  if (back_) earliest = std::min(earliest, back_->begin);
  for (const auto& movement : found_) earliest = std::min(earliest, movement.begin);
  return earliest;
}

void MovementDetector::forgetBefore(std::size_t step) {
  while (first_ < step && !speeds_mm_s_.empty()) {
    speeds_mm_s_.pop_front();
    ++first_;
  }
}

/// Slope of the straight line through the positions around `step`: an average over the window, without delay.
double MovementDetector::slopeAt(const EvenPositions& positions, std::size_t step) const {
  const std::size_t from = std::max(positions.first(), step < half_window_ ? 0 : step - half_window_);
  const std::size_t to = std::min(positions.size() - 1, step + half_window_);
  const double middle = static_cast<double>(from + to) / 2;
  double moment = 0;
  double squares = 0;
  for (std::size_t i = from; i <= to; ++i) {
    const double distance = static_cast<double>(i) - middle;
    moment += distance * positions.at(i);
    squares += distance * distance;
  }
  return squares > 0 ? moment / squares / EvenPositions::kStepS : 0;
}

/// The first step of the movement that reached its starting speed at `step`.
std::size_t MovementDetector::quietBefore(std::size_t step, double direction) const {
  while (step > first_ && direction * speedAt(step - 1) >= settings_.stop_speed_mm_s) --step;
  return step;
}

void MovementDetector::lookForward(std::size_t step, double position_mm, double speed_mm_s) {
  const bool fast = speed_mm_s >= settings_.start_speed_mm_s;
  furthest_mm_ = std::max(furthest_mm_, position_mm);
  if (fast && phase_ == Phase::kIdle) {
    forward_ = {quietBefore(step, 1), step, step, step};
    begin_mm_ = position_mm;
    furthest_mm_ = position_mm;
    phase_ = Phase::kMoving;
  } else if (fast) {
    forward_.fast_to = step;
    phase_ = Phase::kMoving;
  } else if (phase_ == Phase::kMoving && speed_mm_s < settings_.stop_speed_mm_s) {
    phase_ = Phase::kPausing;
    paused_at_ = step;
  } else if (phase_ == Phase::kPausing) {
    const bool gone_back = furthest_mm_ - position_mm > settings_.longest_reversal_mm;
    if (gone_back || step - paused_at_ > pause_steps_) close(paused_at_, furthest_mm_ - begin_mm_, false);
  }
}

void MovementDetector::close(std::size_t end, double length_mm, bool interrupted) {
  phase_ = Phase::kIdle;
  forward_.end = end;
  forward_.interrupted = interrupted;
  if (length_mm >= settings_.least_mm) found_.push_back(forward_);
}

void MovementDetector::lookBack(std::size_t step, double position_mm, double speed_mm_s) {
  if (speed_mm_s <= -settings_.start_speed_mm_s) {
    if (!back_) back_ = Movement{quietBefore(step, -1), step, step, step, false, false};
    back_->fast_to = step;
    return;
  }
  if (back_ && speed_mm_s < -settings_.stop_speed_mm_s) return;
  if (back_) {
    back_->end = step;
    if (lowest_been_mm_ - position_mm >= settings_.shortest_mm) found_.push_back(*back_);
    back_.reset();
  }
  lowest_been_mm_ = std::min(lowest_been_mm_, position_mm);
}

}  // namespace tactus::experiments
