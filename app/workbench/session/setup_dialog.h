// "Check the set-up": one line for each thing that a session needs, with what a person has to do for it.
#pragma once

#include <QDialog>
#include <array>

#include "app/workbench/device/device_search.h"
#include "app/workbench/session/setup_check.h"

class QLabel;
class QPushButton;

namespace tactus::workbench {

class NumberBox;

class SetupDialog : public QDialog {
  Q_OBJECT

 public:
  /// The study is open. Looks for the device at once. `study` and `device` outlive this.
  SetupDialog(StudyConnection& study, DeviceSession& device, QWidget* parent);

  SetupCheck& check() { return check_; }

 signals:
  void certified(const tactus::session::SetupCertificate& certificate);

 private:
  struct Line {
    QLabel* mark;
    QLabel* found;
  };

  void build();
  QWidget* makeForceActs();
  QWidget* makeSoundActs();
  void look();
  void showState();

  DeviceSearch search_;
  SetupCheck check_;
  std::array<Line, session::kSetupItems.size()> lines_{};
  QLabel* instruction_;
  QWidget* directions_;
  QWidget* scale_acts_;
  QPushButton* repeat_;
  QPushButton* push_;
  NumberBox* scale_;
  QLabel* verdict_;
  QPushButton* again_;
  QPushButton* close_;
};

}  // namespace tactus::workbench
