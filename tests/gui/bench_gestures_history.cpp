// Gestures with versions of the model: back and forth, named and signed off, side by side.
#include <algorithm>
#include <iterator>
#include <utility>

#include "tests/gui/bench_gestures.h"

namespace tactus::tests {

std::string BenchGestures::travel() {
  if (oneIn(5) && !kept_.empty()) {
    auto it = kept_.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(below(kept_.size())));
    edits_.returnTo(it->first);
    return "return";
  }
  const bool back = oneIn(2);
  for (int i = random_.below(4); i >= 0; --i) back ? edits_.undo() : edits_.redo();
  return back ? "undo" : "redo";
}

// A name or a signature for the state, or back to one that has it.
std::string BenchGestures::mark() {
  switch (random_.below(3)) {
    case 0:
      edits_.snapshot(oneIn(10) ? QStringLiteral("  ") : QStringLiteral("Try %1").arg(random_.below(9)));
      return "snapshot";
    case 1: edits_.signOff(oneIn(10) ? QString() : QString::fromStdString(someExpert())); return "sign-off";
    default: break;
  }
  const auto& events = edits_.history().events();
  std::vector<editing::StateId> marked;
  for (const editing::Event& event : events) {
    const bool named = event.kind == editing::EventKind::kSnapshot || event.kind == editing::EventKind::kSignOff;
    if (named) marked.push_back(event.state);
  }
  if (!marked.empty()) edits_.returnTo(pick(marked));
  return "back to a snapshot";
}

std::string BenchGestures::compare() {
  workbench::CompareController& compare = bench_.compare;
  const auto side = oneIn(2) ? workbench::CompareSide::kA : workbench::CompareSide::kB;
  switch (random_.below(6)) {
    case 0:
    case 1: compare.choose(side, pick(compare.options()).choice); return "another version to compare";
    case 2: compare.show(side); return "show a side";
    case 3:
      if (oneIn(4)) compare.compute();
      return "how far apart";
    case 4: compare.end(); return "end of the comparison";
    default: compare.toggle(); return "A and B";
  }
}

}  // namespace tactus::tests
