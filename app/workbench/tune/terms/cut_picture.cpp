#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

constexpr double kBeside = 0.15;  // of the term's width, left and right of it
constexpr int kPlotHeight = 64;   // px
constexpr int kGripRadius = 5;    // px
constexpr double kGripReach = 8;  // px

}  // namespace

CutPicture::CutPicture(fuzzy::Variable variable, fuzzy::Term term, QWidget* parent)
    : QWidget(parent), variable_(std::move(variable)), term_(std::move(term)) {
  const auto shape = fuzzy::MembershipFunction::of(term_);
  const double from = std::max(shape.a, variable_.min);
  const double to = std::min(shape.d, variable_.max);
  low_ = std::max(variable_.min, from - kBeside * (to - from));
  high_ = std::min(variable_.max, to + kBeside * (to - from));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setAccessibleName(tr("Cuts of %1").arg(labelOf(term_)));
  setToolTip(tr("Drag a cut, or choose it with the arrows up and down and move it with left and right"));
}

QSize CutPicture::sizeHint() const { return {240, kPlotHeight + 4 + fontMetrics().height()}; }

QRectF CutPicture::area() const {
  return {kGripReach, kGripRadius, width() - 2 * kGripReach, static_cast<double>(kPlotHeight - kGripRadius)};
}

double CutPicture::pixelOf(double value) const {
  return area().left() + (value - low_) / (high_ - low_) * area().width();
}

double CutPicture::valueAt(double pixel) const {
  return low_ + std::clamp((pixel - area().left()) / area().width(), 0.0, 1.0) * (high_ - low_);
}

void CutPicture::setCuts(std::vector<double> cuts) {
  cuts_ = std::move(cuts);
  if (selected_ >= cuts_.size()) selected_ = 0;
  update();
}

std::optional<std::size_t> CutPicture::cutAt(double pixel) const {
  std::optional<std::size_t> nearest;
  double distance = kGripReach;
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    if (std::abs(pixelOf(cuts_[i]) - pixel) > distance) continue;
    distance = std::abs(pixelOf(cuts_[i]) - pixel);
    nearest = i;
  }
  return nearest;
}

// A cut stays between its neighbors.
void CutPicture::move(std::size_t cut, double value) {
  const double after = cut > 0 ? cuts_[cut - 1] : low_;
  const double before = cut + 1 < cuts_.size() ? cuts_[cut + 1] : high_;
  const double place = roundedPlace(variable_, value);
  if (place <= after || place >= before || place == cuts_[cut]) return;
  cuts_[cut] = place;
  update();
  emit moved(cuts_);
}

void CutPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF plot = area();
  const auto high = [&plot](double membership) { return plot.bottom() - membership * plot.height(); };
  const TermOutline outline = outlineOf(term_, low_, high_);
  QPolygonF shape;
  shape << QPointF(pixelOf(outline.x.front()), high(0));
  for (qsizetype i = 0; i < outline.x.size(); ++i) shape << QPointF(pixelOf(outline.x[i]), high(outline.membership[i]));
  shape << QPointF(pixelOf(outline.x.back()), high(0));
  painter.setPen(QPen(theme::mutedInk(), 1.4));
  painter.setBrush(theme::grid());
  painter.drawPolygon(shape);
  painter.setFont(theme::smallFont());
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    const double x = pixelOf(cuts_[i]);
    if (x < plot.left() || x > plot.right()) continue;
    const bool strong = i == selected_ && hasFocus();
    painter.setPen(QPen(theme::accent(), strong ? 2.4 : 1.4));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    painter.setBrush(strong ? theme::accent() : theme::card());
    painter.drawEllipse(QPointF(x, plot.top() + 1), kGripRadius - 1, kGripRadius - 1);
    painter.setPen(theme::ink());
    painter.drawText(QRectF(x - 40, plot.bottom() + 2, 80, height() - plot.bottom() - 2),
                     Qt::AlignHCenter | Qt::AlignTop, text(editing::numberText(variable_, cuts_[i])));
  }
}

void CutPicture::mousePressEvent(QMouseEvent* event) {
  const auto cut = cutAt(event->position().x());
  if (event->button() != Qt::LeftButton || !cut) return;
  selected_ = *cut;
  dragging_ = true;
  update();
}

void CutPicture::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_) move(selected_, valueAt(event->position().x()));
}

void CutPicture::mouseReleaseEvent(QMouseEvent* /*event*/) { dragging_ = false; }

void CutPicture::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (cuts_.empty() || (key != Qt::Key_Left && key != Qt::Key_Right && key != Qt::Key_Up && key != Qt::Key_Down)) {
    QWidget::keyPressEvent(event);
    return;
  }
  if (key == Qt::Key_Up || key == Qt::Key_Down) {
    selected_ = (selected_ + (key == Qt::Key_Down ? 1 : cuts_.size() - 1)) % cuts_.size();
    update();
    return;
  }
  const bool coarse = event->modifiers().testFlag(Qt::ShiftModifier);
  const double step = editing::editStep(variable_, coarse ? editing::StepSize::kCoarse : editing::StepSize::kFine);
  move(selected_, cuts_[selected_] + (key == Qt::Key_Right ? step : -step));
}

void CutPicture::focusInEvent(QFocusEvent* event) {
  update();
  QWidget::focusInEvent(event);
}

void CutPicture::focusOutEvent(QFocusEvent* event) {
  update();
  QWidget::focusOutEvent(event);
}

}  // namespace tactus::workbench
