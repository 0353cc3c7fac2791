#include "app/workbench/deliver/link/link_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/deliver/link/link_controller.h"
#include "app/workbench/deliver/link/link_text.h"

namespace tactus::workbench {

LinkRow::LinkRow(const LinkController& link, QWidget* parent)
    : QWidget(parent), link_(link), state_(new QLabel(this)), open_(new QPushButton(this)) {
  auto* name = new QLabel(tr("Live link"), this);
  name->setFont(theme::headingFont());
  state_->setTextFormat(Qt::PlainText);
  state_->setWordWrap(true);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  words->addWidget(name);
  words->addWidget(state_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * theme::kGrid);
  layout->addLayout(words, 1);
  layout->addWidget(open_, 0, Qt::AlignVCenter);
  connect(open_, &QPushButton::clicked, this, &LinkRow::asked);
  connect(&link_, &LinkController::changed, this, &LinkRow::showState);
  showState();
}

void LinkRow::showState() {
  const bool serving = link_.isServing();
  state_->setText(serving ? servingText(link_) : tr("Off. A running simulator can follow each edit."));
  setInk(*state_, serving ? theme::accent() : theme::ink());
  open_->setText(serving ? tr("Show who is connected…") : tr("Serve to a simulator…"));
}

}  // namespace tactus::workbench
