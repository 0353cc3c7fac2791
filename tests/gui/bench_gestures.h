// Random gestures at the controllers of the tuning bench: everything that the screen can do to a model.
#pragma once

#include <QObject>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/base/random.h"

#include "tests/gui/bench_controllers.h"

namespace tactus::tests {

/// Whole gestures of a hand that does not know what it does: drags with any number of moves that end, are canceled or
/// are broken into, typed numbers that are none, edits of terms, rules and lists that make no sense, answers in the
/// grids, snapshots, sign-offs, ways back to any state, versions side by side, fixes of findings. After each one
/// `check` finds whether everything still holds.
class BenchGestures {
 public:
  /// A model must be open in `reach`, whose controllers outlive this.
  BenchGestures(std::uint64_t seed, const BenchReach& reach);

  /// One gesture. Returns what it was.
  std::string play();

  /// The first thing that does not hold, or empty: the model is valid; what is open is the model of the history;
  /// its compiled form gives the same bits as one made anew; the state that undo, redo or a click went back to has the
  /// model that it had; what the comparison shows is its side; the rule editor stands at rules that are there and says
  /// how strongly they act; a move kept locked vertices and the sum of one; the text of the model's file reads back to
  /// the same model.
  std::string check(bool with_file);

  /// Undoes everything, does everything again, and visits every state. Returns what does not hold, or empty.
  std::string unwind();

  std::size_t states() const { return kept_.size(); }
  std::size_t refusals() const { return refusals_; }

 private:
  // bench_gestures.cpp: membership functions
  std::string drag();
  std::string breakIn();
  std::string steps();
  std::string editTerm();
  std::string editMode();
  std::string look();
  void watchMove(const std::function<void()>& move);
  // bench_gestures_rules.cpp
  std::string grid();
  std::string editRule();
  std::string editFreeRule();
  std::string answer();
  std::string acceptance();
  std::string contract();
  std::string fix();
  fuzzy::Rule someRule(const fuzzy::Expert& expert);
  // bench_gestures_history.cpp
  std::string travel();
  std::string mark();
  std::string compare();
  // bench_gestures_check.cpp
  std::string checkModel();
  std::string checkShown();
  std::string checkRules();
  std::string checkFile();

  template <class List>
  const auto& pick(const List& list) {
    return list[below(list.size())];
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_.below(static_cast<int>(count))); }
  bool oneIn(int count) { return random_.below(count) == 0; }
  double number(double from, double to);
  double place(const fuzzy::Variable& variable);
  std::string termId();
  std::string someExpert() { return pick(edits_.model().experts).id; }
  const fuzzy::Variable& someVariable();

  QObject context_;
  base::Random random_;
  BenchReach bench_;
  workbench::ModelController& models_;
  workbench::SceneController& scene_;
  workbench::EditController& edits_;
  workbench::TermController& terms_;
  workbench::RuleController& rules_;
  std::map<editing::StateId, fuzzy::ForceModel> kept_;  ///< every state that ever was
  std::size_t refusals_ = 0;
  std::string broken_;  ///< by the last gesture
};

}  // namespace tactus::tests
