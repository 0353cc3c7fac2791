// Random gestures at the controllers of the tuning bench: everything that the screen can do to a model.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/workbench/controllers/edit_controller.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/controllers/term_controller.h"
#include "core/base/random.h"

namespace tactus::tests {

/// Whole gestures of a hand that does not know what it does: drags with any number of moves that end, are cancelled or
/// are broken into, typed numbers that are none, edits of terms, rules and lists that make no sense. After each one
/// `check` finds whether everything still holds.
class BenchGestures {
 public:
  BenchGestures(std::uint64_t seed, workbench::ModelController& models, workbench::SceneController& scene,
                workbench::EditController& edits, workbench::TermController& terms);

  /// One gesture. Returns what it was.
  std::string play();

  /// The first thing that does not hold, or empty: the model is valid; what is open is the model of the history;
  /// its compiled form gives the same bits as one made anew; the state that undo, redo or a click went back to has the
  /// model that it had; the text of its file reads back to the same model.
  std::string check(bool with_file);

  /// Undoes everything, does everything again, and visits every state. Returns what does not hold, or empty.
  std::string unwind();

  std::size_t states() const { return kept_.size(); }
  std::size_t refusals() const { return refusals_; }

 private:
  std::string drag();
  std::string steps();
  std::string editTerm();
  std::string editMode();
  std::string editRule();
  std::string editFreeRule();
  std::string answer();
  std::string acceptance();
  std::string fix();
  std::string travel();
  std::string look();

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
  fuzzy::Rule someRule(const fuzzy::Expert& expert);

  base::Random random_;
  workbench::ModelController& models_;
  workbench::SceneController& scene_;
  workbench::EditController& edits_;
  workbench::TermController& terms_;
  std::map<editing::StateId, fuzzy::ForceModel> kept_;  ///< every state that ever was
  std::size_t refusals_ = 0;
};

}  // namespace tactus::tests
