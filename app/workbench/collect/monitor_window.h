// The researcher's window during a session, on another screen than the participant's. It never takes the keyboard from
// her: only while the session is paused may the researcher type.
#pragma once

#include <QWidget>

#include "app/workbench/collect/monitor_controller.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTimer;

namespace tactus::workbench {

class Card;
class ForceTrace;
class PrimaryButton;

// Draws a ForceTrace: the commanded force as a band, the delivered force as a line.

class ForcePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ForcePlot(const ForceTrace& trace, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {480, 200}; }
  QSize minimumSizeHint() const override { return {240, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const ForceTrace& trace_;
};

class MonitorWindow : public QWidget {
  Q_OBJECT

 public:
  /// `monitor` outlives this.
  explicit MonitorWindow(MonitorController& monitor, QWidget* parent = nullptr);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* makeState();
  QWidget* makeNotes();
  QWidget* makeForce();
  QWidget* makeCourse();
  void refreshState();
  void followForce();
  void addLines();
  void typeNotes(bool typing);
  void storeNote();

  MonitorController& monitor_;
  QLabel* code_;
  Card* mark_;  ///< SIMULATED, or SET-UP NOT CHECKED
  QLabel* mark_text_;
  Card* call_;
  QLabel* call_text_;
  QPushButton* coming_;
  QLabel* screen_;
  QLabel* now_;
  QLabel* device_;
  QLabel* reading_;
  QProgressBar* progress_;
  QLabel* share_;
  PrimaryButton* pause_;
  QLineEdit* note_;
  QPushButton* store_note_;
  QLabel* note_hint_;
  ForcePlot* plot_;
  QLabel* force_;
  QListWidget* course_;
  QTimer* calm_;
  int shown_lines_ = 0;
};

}  // namespace tactus::workbench
