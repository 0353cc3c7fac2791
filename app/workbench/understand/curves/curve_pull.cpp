// Pulling a line of the curves by the mouse and by keys, and the pins on it.
#include <QFocusEvent>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/curves_panel.h"

namespace tactus::workbench {

// The visible line that is nearest at the height of the mouse; the mean where none is near.
std::optional<std::size_t> CurvePlot::lineAt(QPointF place) const {
  constexpr double kNear = 12;  // px
  if (overlays_->familySize() > 0) return std::nullopt;
  const double x = plot_->xAxis->pixelToCoord(place.x());
  double nearest = kNear;
  std::optional<std::size_t> out;
  for (std::size_t i = 0; i <= weights_.size(); ++i) {
    const QCPGraph* line = plot_->graph(static_cast<int>(i));
    const auto at = line->data()->findBegin(x);
    if (!shown(i) || at == line->data()->constEnd() || std::isnan(at->value)) continue;
    const double off = std::abs(plot_->yAxis->coordToPixel(at->value) - place.y());
    // The mean is drawn over the others.
    if (off >= nearest || (i > kMeanGraph && off >= nearest - 1)) continue;
    nearest = off;
    out = i == kMeanGraph ? std::nullopt : std::optional(i - 1);
  }
  return out;
}

bool CurvePlot::isOnHandle(QPointF place) const {
  constexpr double kNear = 11;  // px
  if (!handle_) return false;
  const QPointF at(plot_->xAxis->coordToPixel(handle_->x()), plot_->yAxis->coordToPixel(handle_->y()));
  return (at - place).manhattanLength() < kNear;
}

// Alt takes a line, Alt and Shift draw a band, and the handle of a pulled line needs no key.
bool CurvePlot::beginPull(const QMouseEvent& event) {
  const QPointF place = event.position();
  if (event.button() != Qt::LeftButton || !plot_->axisRect()->rect().contains(place.toPoint())) return false;
  const double x = placeOf(x_, plot_->xAxis->pixelToCoord(place.x()));
  const double force_n = placeOf(output_, plot_->yAxis->pixelToCoord(place.y()));
  const bool alt = event.modifiers().testFlag(Qt::AltModifier);
  if (alt && event.modifiers().testFlag(Qt::ShiftModifier)) {
    drag_ = Drag::kBand;
    band_from_ = {x, force_n};
  } else if (alt) {
    drag_ = Drag::kForce;
    emit grabbed(lineAt(place), x, force_n);
  } else if (isOnHandle(place)) {
    drag_ = Drag::kForce;
  }
  return drag_ != Drag::kNone;
}

void CurvePlot::movePull(const QMouseEvent& event) {
  const QPointF to(placeOf(x_, plot_->xAxis->pixelToCoord(event.position().x())),
                   placeOf(output_, plot_->yAxis->pixelToCoord(event.position().y())));
  if (drag_ == Drag::kForce) {
    emit pulledTo(to.y());
  } else {
    emit bandDrawn({std::min(band_from_.x(), to.x()), std::max(band_from_.x(), to.x())},
                   {std::min(band_from_.y(), to.y()), std::max(band_from_.y(), to.y())});
  }
}

std::optional<double> CurvePlot::pinAt(double pixel_x) const {
  constexpr double kNear = 8;  // px
  for (const double x : pins_) {
    if (std::abs(plot_->xAxis->coordToPixel(x) - pixel_x) < kNear) return x;
  }
  return std::nullopt;
}

bool CurvePlot::event(QEvent* event) {
  // A shortcut of the window must not take the key that ends a pull.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
      by_keys_) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

// A step is a hundredth of the force's round range; page keys take ten of them, Shift a tenth.
void CurvePlot::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const double step = std::pow(10, std::floor(std::log10(output_.max - output_.min)) - 2);
  const double size = event->modifiers().testFlag(Qt::ShiftModifier) ? step / 10 : step;
  const auto pull = [this](double by_n) {
    by_keys_ = true;
    emit pullStepped(by_n);
  };
  switch (key) {
    case Qt::Key_Up: return pull(size);
    case Qt::Key_Down: return pull(-size);
    case Qt::Key_PageUp: return pull(10 * step);
    case Qt::Key_PageDown: return pull(-10 * step);
    case Qt::Key_Left: return emit placeStepped(-1);
    case Qt::Key_Right: return emit placeStepped(1);
    case Qt::Key_Return:
    case Qt::Key_Enter: {
      const bool pulled = std::exchange(by_keys_, false);
      return pulled ? emit pullReleased() : emit pullAsked();
    }
    case Qt::Key_Escape:
      if (!std::exchange(by_keys_, false)) break;
      return emit pullDropped();
    default: break;
  }
  QWidget::keyPressEvent(event);
}

void CurvePlot::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  if (event->reason() == Qt::MouseFocusReason) return;
  overlays_->setFocused(true);
  redraw(*plot_);
}

// Elsewhere no key would end what they pull here.
void CurvePlot::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  overlays_->setFocused(false);
  redraw(*plot_);
  if (event->reason() == Qt::ActiveWindowFocusReason || event->reason() == Qt::PopupFocusReason) return;
  if (std::exchange(by_keys_, false)) emit pullDropped();
}

}  // namespace tactus::workbench
