// The upper envelope (pointwise maximum) of lines over one interval.
#pragma once

#include <algorithm>
#include <span>

namespace tactus::fuzzy {

/// A line over one interval, given by its heights at the two ends.
struct EndHeights {
  double y0, y1;
};

/// A point of the envelope. `t` in [0, 1]: position in the interval.
struct EnvelopePoint {
  double t, height;
};

/// Calls `visit(line, from, to)` for each piece of the maximum of `lines` in turn. `line` is the highest one between
/// the EnvelopePoints `from` and `to`. The pieces cover all of [0, 1]; each starts at the height at which the previous
/// one ended. If lines coincide, the first one is visited. If there are no lines, there is no call.
///
/// `Line` has the members y0 and y1, its heights at the two ends. The walk moves from crossing to crossing. Each step
/// moves to a line that ends higher, so there are at most as many pieces as lines, even if several lines cross in one
/// point.
/// Thread: any. Real-time safe: yes, if `visit` is. Always inlined, because the general path spends most of its time
/// here.
template <class Line, class Visit>
[[gnu::always_inline]] inline void walkUpperEnvelope(std::span<const Line> lines, const Visit& visit) {
  if (lines.empty()) return;
  const Line* top = lines.data();
  for (const Line& line : lines) {
    if (line.y0 > top->y0 || (line.y0 == top->y0 && line.y1 > top->y1)) top = &line;
  }
  EnvelopePoint from{0, top->y0};
  while (true) {
    const Line* next = nullptr;
    double next_t = 1;
    for (const Line& line : lines) {
      if (line.y1 <= top->y1) continue;
      const double below = top->y0 - line.y0;
      const double crossing = std::max(from.t, below / (below + (line.y1 - top->y1)));
      if (crossing < next_t || (next != nullptr && crossing == next_t && line.y1 > next->y1)) {
        next = &line;
        next_t = crossing;
      }
    }
    if (next == nullptr) break;
    const EnvelopePoint to{next_t, top->y0 + next_t * (top->y1 - top->y0)};
    visit(*top, from, to);
    from = to;
    top = next;
  }
  visit(*top, from, EnvelopePoint{1, top->y1});
}

}  // namespace tactus::fuzzy
