#include "app/workbench/help/tour.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/layout.h"

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
  makeColumn(this, {place_, title_, text_, gap(theme::kGrid / 2), makeRow({end_, spring(1), back_, next_})},
             theme::kGrid, {2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid, theme::kGrid + theme::kGrid / 2});
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
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    QPushButton* const ringed = back_->hasFocus() ? back_ : end_->hasFocus() ? end_ : next_;
    ringed->click();
  } else {
    Card::keyPressEvent(event);
  }
}

TourFrame::TourFrame(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
}

void TourFrame::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::accent(), 3));
  painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), theme::kCornerRadius, theme::kCornerRadius);
}

QRect cardPlace(const QSize& window, const QRect& target, const QSize& card) {
  constexpr int kGap = theme::kGrid;
  const auto clamped = [&](QPoint corner) {
    return QRect({std::clamp(corner.x(), kGap, std::max(kGap, window.width() - card.width() - kGap)),
                  std::clamp(corner.y(), kGap, std::max(kGap, window.height() - card.height() - kGap))},
                 card);
  };
  const QPoint corners[] = {{target.right() + 1 + kGap, target.top()},
                            {target.left() - card.width() - kGap, target.top()},
                            {target.left(), target.bottom() + 1 + kGap},
                            {target.left(), target.top() - card.height() - kGap}};
  for (const QPoint& corner : corners) {
    if (const QRect place = clamped(corner); !place.intersects(target)) return place;
  }
  return clamped({target.right() + 1 - card.width() - kGap, target.bottom() + 1 - card.height() - kGap});
}

Tour::Tour(QWidget& window, std::vector<TourStep> steps)
    : window_(window), steps_(std::move(steps)), frame_(new TourFrame(&window)), card_(new TourCard(&window)) {
  frame_->hide();
  card_->hide();
  window_.installEventFilter(this);
  connect(card_, &TourCard::backRequested, this, [this] { goTo(step_ - 1); });
  connect(card_, &TourCard::nextRequested, this, [this] { goTo(step_ + 1); });
  connect(card_, &TourCard::endRequested, this, &Tour::end);
}

void Tour::goTo(int step) {
  if (step < 0) return;
  if (step >= steps()) return end();
  step_ = step;
  const TourStep& now = steps_[static_cast<std::size_t>(step)];
  watch(now.show());
  card_->showStep(now.title, now.text, step, steps());
  frame_->show();
  card_->show();
  place();
  // A layout that changes just now has its sizes only with the next event.
  QTimer::singleShot(0, this, &Tour::place);
}

void Tour::end() {
  step_ = -1;
  watch(nullptr);
  frame_->hide();
  card_->hide();
}

void Tour::watch(QWidget* shown) {
  if (shown == shown_) return;
  if (shown_ != nullptr) shown_->removeEventFilter(this);
  shown_ = shown;
  if (shown_ != nullptr) shown_->installEventFilter(this);
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (isRunning() && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) place();
  return QObject::eventFilter(watched, event);
}

void Tour::place() {
  if (!isRunning() || shown_ == nullptr) return;
  // A panel that the user took out of the window has no place in it.
  const bool inside = shown_->isVisible() && shown_->window() == &window_;
  frame_->setVisible(inside);
  const QRect target = inside ? QRect(shown_->mapTo(&window_, QPoint(0, 0)), shown_->size()) : window_.rect();
  frame_->setGeometry(target.adjusted(-3, -3, 3, 3));
  card_->setGeometry(cardPlace(window_.size(), target, card_->size()));
  frame_->raise();
  card_->raise();
}

}  // namespace tactus::workbench
