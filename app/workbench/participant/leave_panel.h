// The way back to the research mode: asks for the study's passphrase, over the nurse's screen.
#pragma once

#include "app/workbench/participant/screens/panel_card.h"

class QLineEdit;

namespace tactus::workbench {

class LeavePanel : public nurse::PanelCard {
  Q_OBJECT

 public:
  explicit LeavePanel(const nurse::Look& look, QWidget* parent = nullptr);

  /// What was typed is not the passphrase.
  void refuse();

 signals:
  void entered(const QString& passphrase);
  /// Back to the participant.
  void stay();

 private:
  void followLook();

  QLineEdit* passphrase_;
  nurse::Label* wrong_;
};

}  // namespace tactus::workbench
