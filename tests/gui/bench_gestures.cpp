#include "tests/gui/bench_gestures.h"

#include <QCoreApplication>
#include <cmath>
#include <limits>
#include <utility>

#include "core/fuzzy/membership.h"

namespace tactus::tests {
namespace {

using workbench::Grip;
using Part = Grip::Part;

}  // namespace

BenchGestures::BenchGestures(std::uint64_t seed, const BenchReach& bench)
    : random_(seed),
      bench_(bench),
      models_(bench.models),
      scene_(bench.scene),
      edits_(bench.edits),
      terms_(bench.terms),
      rules_(bench.rules) {
  kept_[edits_.history().current()] = edits_.model();
  QObject::connect(&edits_, &workbench::EditController::refused, &context_, [this] { ++refusals_; });
}

std::string BenchGestures::play() {
  broken_.clear();
  switch (random_.below(32)) {
    case 0:
    case 1: return editTerm();
    case 2:
    case 3: return editMode();
    case 4:
    case 5: return editRule();
    case 6:
    case 7: return editFreeRule();
    case 8:
    case 9: return answer();
    case 10:
    case 11:
    case 12:
    case 13:
    case 14: return grid();
    case 15: return oneIn(4) ? acceptance() : oneIn(3) ? contract() : look();
    case 16: return oneIn(8) ? fix() : look();
    case 17:
    case 18:
    case 19: return travel();
    case 20: return mark();
    case 21:
    case 22: return compare();
    case 23:
    case 24: return steps();
    default: return drag();
  }
}

void BenchGestures::watchMove(const std::function<void()>& move) {
  const editing::TermListId list = terms_.list();
  const std::vector<fuzzy::Term> before = terms_.terms();
  const bool sums = terms_.keepsSum();
  move();
  if (!(terms_.list() == list)) return;
  const std::vector<fuzzy::Term>& after = terms_.terms();
  const fuzzy::Variable& variable = terms_.variable();
  // What lay on a neighbor within rounding may have been put onto it exactly.
  const double rounding = 1e-8 * (variable.max - variable.min);
  for (const fuzzy::Term& term : before) {
    const fuzzy::Term* const now = fuzzy::findTerm(after, term.id);
    for (std::size_t p = 0; now != nullptr && p < term.points.size(); ++p) {
      if (!terms_.isLocked(term.id, p) || std::abs(now->points[p] - term.points[p]) <= rounding) continue;
      broken_ = "a locked vertex of " + term.id + " moved";
    }
  }
  if (!sums || before == after) return;
  if (!terms_.keepsSum()) broken_ = "the terms do not sum to one any more";
  for (int i = 0; i < 4; ++i) {
    const double x = random_.uniform(variable.min, variable.max);
    double sum = 0;
    bool on_vertex = false;
    for (const fuzzy::Term& term : after) {
      sum += fuzzy::MembershipFunction::of(term)(x);
      for (const double point : term.points) on_vertex = on_vertex || point == x;
    }
    if (!on_vertex && std::abs(sum - 1) > 1e-9) broken_ = "the terms sum to " + std::to_string(sum);
  }
}

std::string BenchGestures::drag() {
  if (terms_.terms().empty()) return "nothing";
  const std::size_t term = below(terms_.terms().size());
  Grip grip;
  grip.term = term;
  switch (random_.below(4)) {
    case 0: grip.part = oneIn(2) ? Part::kLeftEdge : Part::kRightEdge; break;
    case 1: break;
    default: grip = pick(workbench::handlesOf(terms_.terms(), term)).grip;
  }
  // A Gaussian has no edges to take hold of.
  if (!workbench::holds(terms_.terms(), grip)) return "nothing";
  const fuzzy::Variable& variable = terms_.variable();
  const double range = variable.max - variable.min;
  terms_.beginMove(grip);
  const auto move = [&] { terms_.moveBy(number(-range, range) * (oneIn(3) ? 1 : 0.1)); };
  std::string what = "drag";
  for (int i = random_.below(6); i > 0; --i) {
    watchMove(move);
    if (oneIn(8)) QCoreApplication::processEvents();
    if (oneIn(25)) what += ", " + breakIn();
  }
  if (oneIn(6)) {
    terms_.cancelMove();
    return what + ", canceled";
  }
  if (!oneIn(12)) terms_.endMove();  // otherwise the next gesture has to end it
  return what;
}

// Keys work while the mouse drags.
std::string BenchGestures::breakIn() {
  switch (random_.below(6)) {
    case 0: edits_.undo(); return "undo in the middle";
    case 1: terms_.setKeepsSum(oneIn(2)); return "another mode in the middle";
    case 2:
      if (const std::size_t count = rules_.expert().rules.size(); count > 0) rules_.weigh(below(count), number(0, 1));
      return "a weight in the middle";
    case 3: return editTerm() + " in the middle";
    case 4: return grid() + " in the middle";
    default: return editMode() + " in the middle";
  }
}

std::string BenchGestures::steps() {
  terms_.selectNext(oneIn(2) ? 1 : -1);
  for (int i = random_.below(5); i > 0; --i) {
    watchMove([&] { terms_.step(random_.below(7) - 3, oneIn(2)); });
    if (oneIn(40)) breakIn();
  }
  if (!oneIn(4)) terms_.endSteps();
  return "arrow keys";
}

std::string BenchGestures::editTerm() {
  const std::string term = termId();
  const fuzzy::Variable& variable = terms_.variable();
  switch (random_.below(7)) {
    case 0: terms_.add(QStringLiteral("New %1").arg(random_.below(9)), place(variable)); return "add a term";
    case 1:
      terms_.rename(term, oneIn(4) ? QString() : QStringLiteral("Name %1").arg(random_.below(9)));
      return "rename a term";
    case 2: terms_.remove(term, oneIn(2)); return "remove a term";
    case 3: {
      std::vector<double> cuts = {place(variable)};
      if (oneIn(3)) cuts.push_back(place(variable));
      terms_.split(term, cuts);
      return "split a term";
    }
    case 4: terms_.convert(term, fuzzy::kShapes[below(3)]); return "convert a term";
    default: terms_.setPoint(term, below(5), place(variable)); return "type a value";
  }
}

std::string BenchGestures::editMode() {
  switch (random_.below(7)) {
    case 0: terms_.setLocked(termId(), below(4), oneIn(2)); return "lock";
    case 1: terms_.setKeepsSum(oneIn(2)); return "terms that sum to one";
    case 2: terms_.setOwnList(oneIn(2)); return "own list";
    case 3: terms_.setExpert(oneIn(2) ? std::string() : someExpert()); return "another expert";
    case 4: terms_.chooseScope(oneIn(2)); return "whose terms are edited";
    default: terms_.setVariable(someVariable().id); return "another variable";
  }
}

std::string BenchGestures::look() {
  const auto input = below(edits_.model().inputs.size());
  scene_.setValue(input, place(edits_.model().inputs[input]));
  if (oneIn(4)) scene_.setXInput(input);
  scene_.reading();
  if (oneIn(20)) scene_.curves();
  return "look elsewhere";
}

double BenchGestures::number(double from, double to) {
  if (oneIn(40)) {
    constexpr double kOdd[] = {
        std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e308, 1e200, -0.0, 5e-324};
    return kOdd[below(6)];
  }
  return random_.uniform(from, to);
}

double BenchGestures::place(const fuzzy::Variable& variable) {
  const double range = variable.max - variable.min;
  return oneIn(5) ? number(variable.min - range, variable.max + range) : number(variable.min, variable.max);
}

std::string BenchGestures::termId() { return oneIn(30) ? "nowhere" : pick(terms_.terms()).id; }

const fuzzy::Variable& BenchGestures::someVariable() {
  const std::size_t index = below(edits_.model().inputs.size() + 1);
  return index < edits_.model().inputs.size() ? edits_.model().inputs[index] : edits_.model().output;
}

}  // namespace tactus::tests
