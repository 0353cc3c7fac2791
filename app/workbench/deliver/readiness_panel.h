// The panel that says whether the open model is ready to be delivered.
#pragma once

#include <array>

#include "app/workbench/deliver/readiness.h"
#include "app/workbench/kit/cards.h"

class QLabel;

namespace tactus::workbench {

class ReadinessController;
class ReadinessRow;

class ReadinessPanel : public Card {
  Q_OBJECT

 public:
  explicit ReadinessPanel(ReadinessController& readiness, QWidget* parent = nullptr);

 signals:
  /// The user asks for the place or the act of a line.
  void asked(tactus::workbench::ReadinessTopic topic);

 private:
  void showLines();

  ReadinessController& readiness_;
  QLabel* summary_;
  std::array<ReadinessRow*, kReadinessTopics> rows_{};  ///< one for each topic
};

}  // namespace tactus::workbench
