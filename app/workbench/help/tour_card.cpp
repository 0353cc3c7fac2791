#include "app/workbench/help/tour_card.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"

namespace tactus::workbench {
namespace {

constexpr int kCardWidth = 340;  // px at 100 %

}  // namespace

TourCard::TourCard(QWidget* parent)
    : Card(parent),
      title_(new QLabel(this)),
      text_(new QLabel(this)),
      place_(new QLabel(this)),
      back_(new QPushButton(tr("Go back"), this)),
      next_(new PrimaryButton(tr("Next"), this)),
      end_(new QPushButton(tr("End the tour"), this)) {
  setColors(theme::card(), theme::accent());
  title_->setFont(theme::headingFont());
  title_->setWordWrap(true);
  text_->setWordWrap(true);
  setMuted(*place_);
  end_->setFlat(true);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(theme::kGrid);
  buttons->addWidget(end_);
  buttons->addStretch(1);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid, theme::kGrid + theme::kGrid / 2);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(place_);
  layout->addWidget(title_);
  layout->addWidget(text_);
  layout->addSpacing(theme::kGrid / 2);
  layout->addLayout(buttons);
  connect(back_, &QPushButton::clicked, this, &TourCard::backRequested);
  connect(next_, &QPushButton::clicked, this, &TourCard::nextRequested);
  connect(end_, &QPushButton::clicked, this, &TourCard::endRequested);
}

void TourCard::showStep(const QString& title, const QString& text, int step, int steps) {
  const bool last = step + 1 == steps;
  title_->setText(title);
  text_->setText(text);
  place_->setText(tr("Tour, step %1 of %2").arg(step + 1).arg(steps));
  back_->setEnabled(step > 0);
  next_->setText(last ? tr("Done") : tr("Next"));
  end_->setVisible(!last);
  setAccessibleName(title);
  setAccessibleDescription(text);
  // The text wraps, so that the height follows from the width.
  setFixedWidth(appearance::scaled(kCardWidth));
  setFixedHeight(layout()->heightForWidth(minimumWidth()));
  next_->setFocus();
}

void TourCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    emit endRequested();
  } else if (event->key() == Qt::Key_Left) {
    emit backRequested();
  } else if (event->key() == Qt::Key_Right) {
    emit nextRequested();
  } else {
    Card::keyPressEvent(event);
  }
}

}  // namespace tactus::workbench
