// Effort and comfort of a part that she has done, one question after the other.
#pragma once

#include <QString>
#include <optional>

#include "app/workbench/participant/participant_state.h"

namespace tactus::workbench {

/// Plain state. Thread: gui.
class BlockRating {
 public:
  void begin() { *this = {}; }
  /// Ignores what is no answer.
  void choose(const QString& id);
  bool isAnswered() const { return !chosen_.isEmpty(); }
  bool isFirst() const { return !effort_ || !*effort_; }
  /// Takes what is chosen. Whether both questions are answered now; who does not say the one is not asked the other.
  bool next();
  void back();

  /// 1 to 7; nothing: she did not say.
  std::optional<int> effort() const { return effort_.value_or(std::nullopt); }
  std::optional<int> comfort() const { return comfort_; }
  ScaleState state() const;

 private:
  std::optional<int> points() const;

  QString chosen_;
  std::optional<std::optional<int>> effort_;  ///< of the first question, once it is answered
  std::optional<int> comfort_;
};

/// The points of a scale: `1` to `7`; nothing for anything else.
std::optional<int> scalePoints(const QString& id);

}  // namespace tactus::workbench
