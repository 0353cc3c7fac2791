// One line of the readiness: its sign, its name and sentence, and the button that leads to the place or to the act.
#pragma once

#include <QFrame>

#include "app/workbench/deliver/readiness.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tactus::workbench {

class ReadinessSign;

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

}  // namespace tactus::workbench
