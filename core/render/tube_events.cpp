#include "core/render/tube_events.h"

#include <algorithm>
#include <utility>

namespace tactus::render {

TubeEvents::TubeEvents(const fuzzy::Variable& way, std::span<const fuzzy::TubeEvent> events, double offset_mm)
    : min_mm_(way.min), max_mm_(way.max) {
  for (const fuzzy::TubeEvent& event : events) {
    const fuzzy::Term* const term = fuzzy::findTerm(way.terms, event.term);
    if (term == nullptr) continue;  // no event of a model that was validated
    // In depths of the tube, as its end is: a core that ends there is reached whatever the rounding.
    events_.push_back({fuzzy::endOfCore(way, *term) - offset_mm, event.share, fuzzy::MembershipFunction::of(*term)});
  }
}

std::size_t TubeEvents::reached(double deepest_mm) const noexcept {
  std::size_t count = 0;
  for (const Event& event : events_) count += deepest_mm >= event.place_mm ? 1 : 0;
  return count;
}

double TubeEvents::left(double deepest_mm, double depth_mm) const noexcept {
  const double at_mm = std::clamp(depth_mm, min_mm_, max_mm_);
  double left = 1;
  for (const Event& event : events_) {
    if (deepest_mm >= event.place_mm) left *= 1 - event.share * event.membership(at_mm);
  }
  return left;
}

bool StrokeReach::follow(const RendererState& state, const TubeEvents& events) noexcept {
  deepest_mm = state.phase == Phase::kReleased ? state.depth_mm : std::max(deepest_mm, state.depth_mm);
  const std::size_t now = events.reached(deepest_mm);
  return std::exchange(done, now) != now;
}

}  // namespace tactus::render
