// Withdrawal: what it deletes is said before it happens. Keeping the data is the primary button.
#pragma once

#include "app/workbench/participant/screens/panel_card.h"

namespace tactus::workbench::nurse {

class WithdrawPanel : public PanelCard {
  Q_OBJECT

 public:
  explicit WithdrawPanel(const Look& look, QWidget* parent = nullptr);

 signals:
  void keep();
  void withdraw();
};

}  // namespace tactus::workbench::nurse
