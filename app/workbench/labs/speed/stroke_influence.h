// What one stroke moves: the averaged force with and without it, as a sentence.
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "app/workbench/labs/data/lab_model.h"
#include "elicitation/tracing/sources.h"

namespace tactus::workbench {

/// Thread: gui. The comparison runs on a thread of its own.
class StrokeInfluence : public QObject {
  Q_OBJECT

 public:
  /// `model` outlives this.
  explicit StrokeInfluence(LabModel& model, QObject* parent = nullptr);

  /// Asks about a stroke that counts; `which` is its name on the screen. Until `stop`, the answer follows the model.
  void ask(const elicitation::StrokeKey& stroke, const QString& which);
  void stop();
  const std::optional<elicitation::StrokeKey>& asked() const { return asked_; }
  /// One sentence; while it is computed, it says so; empty if nothing is asked.
  const QString& sentence() const { return sentence_; }

 signals:
  void told();

 private:
  void compare();
  void tell(const QString& sentence);

  LabModel& model_;
  std::optional<elicitation::StrokeKey> asked_;
  QString which_;
  QString sentence_;
  Background work_;
};

}  // namespace tactus::workbench
