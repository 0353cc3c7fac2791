#include "app/workbench/participant/leave_panel.h"

#include <QLineEdit>

namespace tactus::workbench {

using nurse::ButtonKind;
using nurse::phrase;
using nurse::TextRole;

LeavePanel::LeavePanel(const nurse::Look& look, QWidget* parent)
    : PanelCard(look, parent), passphrase_(new QLineEdit(this)) {
  addText(TextRole::kLead, phrase(QStringLiteral("leave.ask")));
  passphrase_->setEchoMode(QLineEdit::Password);
  addWidget(passphrase_);
  setFocusProxy(passphrase_);
  wrong_ = addText(TextRole::kBody, phrase(QStringLiteral("leave.wrong")));
  wrong_->hide();
  const nurse::Button* leave = addButton(ButtonKind::kPlain, phrase(QStringLiteral("leave.button")));
  const nurse::Button* stay_button = addButton(ButtonKind::kPrimary, phrase(QStringLiteral("nav.back")));
  const auto enter = [this] { emit entered(passphrase_->text()); };
  connect(passphrase_, &QLineEdit::returnPressed, this, enter);
  connect(passphrase_, &QLineEdit::textEdited, wrong_, &QWidget::hide);
  connect(leave, &QAbstractButton::clicked, this, enter);
  connect(stay_button, &QAbstractButton::clicked, this, &LeavePanel::stay);
  connect(&look, &nurse::Look::changed, this, &LeavePanel::followLook);
  followLook();
}

void LeavePanel::followLook() {
  constexpr double kFieldMm = 14;
  passphrase_->setFont(look().font());
  passphrase_->setMinimumHeight(look().mm(kFieldMm));
  passphrase_->setAccessibleName(look().say(phrase(QStringLiteral("leave.ask"))));
}

void LeavePanel::refuse() {
  passphrase_->clear();
  wrong_->show();
}

}  // namespace tactus::workbench
