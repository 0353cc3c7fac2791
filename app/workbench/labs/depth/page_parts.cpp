#include "app/workbench/labs/depth/page_parts.h"

#include <QHBoxLayout>
#include <QLabel>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

QHBoxLayout* pageHead(const QString& name, QWidget* field, QWidget* menu) {
  auto* label = new QLabel(name, field->parentWidget());
  label->setBuddy(field);
  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid);
  head->addWidget(label);
  head->addWidget(field);
  head->addStretch(1);
  head->addWidget(menu);
  return head;
}

QLabel* mutedWords(const QString& words, QWidget* parent) {
  auto* label = new QLabel(words, parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  setMuted(*label);
  return label;
}

}  // namespace tactus::workbench
