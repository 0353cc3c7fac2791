// After "Force off": the force is zero, and she chooses what happens next. Nothing here needs the researcher.
#pragma once

#include "app/workbench/participant/screens/panel_card.h"

namespace tactus::workbench::nurse {

class ForceOffPanel : public PanelCard {
  Q_OBJECT

 public:
  explicit ForceOffPanel(const Look& look, QWidget* parent = nullptr);

  /// The researcher has been called.
  void setCalled(bool called);

 signals:
  void goOn();
  void callResearcher();
  void stopForToday();
  void withdraw();

 private:
  Label* called_;
  Button* call_;
};

}  // namespace tactus::workbench::nurse
