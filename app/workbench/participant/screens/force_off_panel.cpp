#include "app/workbench/participant/screens/force_off_panel.h"

namespace tactus::workbench::nurse {

ForceOffPanel::ForceOffPanel(const Look& look, QWidget* parent) : PanelCard(look, parent) {
  addText(TextRole::kLead, phrase(QStringLiteral("off.done")));
  called_ = addText(TextRole::kBody, phrase(QStringLiteral("off.called")));
  Button* go_on = addButton(ButtonKind::kPrimary, phrase(QStringLiteral("nav.continue")));
  call_ = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.call")));
  Button* stop = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.stop")));
  Button* withdraw_button = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.withdraw")));
  connect(go_on, &QAbstractButton::clicked, this, &ForceOffPanel::goOn);
  connect(call_, &QAbstractButton::clicked, this, &ForceOffPanel::callResearcher);
  connect(stop, &QAbstractButton::clicked, this, &ForceOffPanel::stopForToday);
  connect(withdraw_button, &QAbstractButton::clicked, this, &ForceOffPanel::withdraw);
  setCalled(false);
}

void ForceOffPanel::setCalled(bool called) {
  called_->setVisible(called);
  call_->setVisible(!called);
}

}  // namespace tactus::workbench::nurse
