#include "app/workbench/participant/screens/withdraw_panel.h"

namespace tactus::workbench::nurse {

WithdrawPanel::WithdrawPanel(const Look& look, QWidget* parent) : PanelCard(look, parent) {
  addText(TextRole::kLead, phrase(QStringLiteral("off.withdraw")));
  addText(TextRole::kBody, phrase(QStringLiteral("off.withdraw_ask")));
  Button* keep_button = addButton(ButtonKind::kPrimary, phrase(QStringLiteral("off.keep")));
  Button* withdraw_button = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.withdraw")));
  connect(keep_button, &QAbstractButton::clicked, this, &WithdrawPanel::keep);
  connect(withdraw_button, &QAbstractButton::clicked, this, &WithdrawPanel::withdraw);
}

}  // namespace tactus::workbench::nurse
