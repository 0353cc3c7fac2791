#include "app/workbench/kit/form_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace tactus::workbench {

FormDialog::FormDialog(const QString& title, const QString& text, const QList<Row>& rows, const QString& act,
                       QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(title);
  auto* const label = new QLabel(text, this);
  label->setWordWrap(true);
  auto* const form = new QFormLayout;
  for (const auto& [name, field] : rows) form->addRow(name, field);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  QPushButton* const ok = buttons->button(QDialogButtonBox::Ok);
  ok->setText(act);
  ok_ = ok;
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(label);
  column->addLayout(form);
  column->addWidget(buttons);
  constexpr int kWidth = 480;
  setMinimumWidth(kWidth);
}

}  // namespace tactus::workbench
