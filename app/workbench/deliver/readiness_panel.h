// The panel that says whether the open model is ready to be delivered.
#pragma once

#include <QFrame>
#include <QWidget>
#include <array>

#include "app/workbench/deliver/readiness.h"
#include "app/workbench/kit/cards.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tactus::workbench {

class ReadinessController;

/// The state of a line of the readiness as a small round sign: a tick, an exclamation mark, a cross or dots.
class ReadinessSign : public QWidget {
  Q_OBJECT

 public:
  explicit ReadinessSign(QWidget* parent = nullptr);

  void setState(Readiness state);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Readiness state_ = Readiness::kUnknown;
};

// One line of the readiness: its sign, its name and sentence, and the button that leads to the place or to the act.

class ReadinessRow : public QFrame {
  Q_OBJECT

 public:
  explicit ReadinessRow(QWidget* parent = nullptr);

  void setLine(const ReadinessLine& line);
  /// The holes that are not accepted, each with a button; those beyond what fits are counted.
  void showHoles(const std::vector<DeliverFindings::Hole>& holes);

 signals:
  void acted();
  void holeAccepted(const std::string& name);

 private:
  ReadinessSign* sign_;
  QLabel* name_;
  QLabel* sentence_;
  QPushButton* act_;
  QWidget* holes_;
  QVBoxLayout* hole_lines_;
  std::vector<DeliverFindings::Hole> shown_holes_;
};

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
