#include "app/workbench/labs/frame/lab_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"

namespace tactus::workbench {

LabCard::LabCard(const QString& title, QWidget* content, QWidget* parent) : Card(parent), head_(new QHBoxLayout) {
  auto* heading = new ElidedLabel(this);
  heading->setFont(theme::headingFont());
  heading->setFullText(title);
  head_->setContentsMargins(theme::kGrid, 0, 0, 0);
  head_->setSpacing(theme::kGrid);
  head_->addWidget(heading, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(0);
  layout->addLayout(head_);
  layout->addWidget(content, 1);
}

void LabCard::addTool(QWidget* tool) { head_->addWidget(tool); }

}  // namespace tactus::workbench
