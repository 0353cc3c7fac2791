// The maximum of lines over one interval, walked piece by piece.
#pragma once

#include <algorithm>
#include <span>

namespace tactus::fuzzy {

/// A line over one interval, by its heights at the two ends.
struct EndHeights {
  double y0, y1;
};

/// A point of the maximum: `t` in [0, 1] is the way through the interval.
struct EnvelopePoint {
  double t, height;
};

/// Calls `visit(line, from, to)` for each piece of the maximum of `lines` in turn, `line` being the highest one between
/// the EnvelopePoints `from` and `to`. The pieces cover all of [0, 1], and a piece begins with the height at which the
/// one before it ended. Of lines that coincide the first counts. No lines, no pieces.
///
/// `Line` has the heights y0 and y1 at the two ends. The walk goes from crossing to crossing; each step goes to a line
/// that ends higher, so there are at most as many pieces as lines, also where several cross in one point.
/// Thread: any. Real-time safe: yes, if `visit` is. Inlined always: the general path spends most of its time here.
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
