// The answer word that the button of the device highlights. Each press highlights the next word. The first one is drawn
// by chance: a fixed first word would need the fewest presses and would be chosen too often.
#pragma once

#include <QString>
#include <cstddef>
#include <random>
#include <vector>

#include "experiments/force_protocol.h"

namespace tactus::workbench {

/// Plain state. Thread: gui.
class LitWord {
 public:
  void reset() { presses_ = 0; }
  /// Highlights the next of `words`, which is not empty and stays the same until `reset`.
  void next(const std::vector<experiments::ForceAnswerOption>& words, std::mt19937_64& chance) {
    if (presses_ == 0) first_ = std::uniform_int_distribution<std::size_t>(0, words.size() - 1)(chance);
    first_word_ = words[first_].id;
    id_ = QString::fromStdString(words[(first_ + static_cast<std::size_t>(presses_)) % words.size()].id);
    ++presses_;
  }

  /// The highlighted word; empty: none.
  QString id() const { return presses_ > 0 ? id_ : QString(); }
  int presses() const { return presses_; }
  /// The word that the first press highlighted.
  const std::string& firstWord() const { return first_word_; }

 private:
  int presses_ = 0;
  std::size_t first_ = 0;
  std::string first_word_;
  QString id_;
};

}  // namespace tactus::workbench
