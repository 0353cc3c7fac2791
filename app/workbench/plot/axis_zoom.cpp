#include "app/workbench/plot/axis_zoom.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <optional>
#include <qcustomplot.h>
#include <utility>

#include "app/workbench/model/shown_procedure.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {
namespace {

constexpr double kZoomPerNotch = 1.25;
constexpr double kNotch = 120;         // of a wheel, eighths of a degree
constexpr double kPanPerNotch = 0.15;  // of the range
constexpr double kDragFrom = 3;        // px that tell a drag from a click

/// Where the part of the way ends that most questions are about, as the picture of the procedure has it.
std::optional<double> nearEndMm(const fuzzy::Variable& input) {
  const ProcedurePtr& about = shownProcedure();
  if (about == nullptr || about->pictures.empty() || about->wayInput().id != input.id) return std::nullopt;
  const procedure::Picture& picture = about->pictures.front();
  if (!picture.near) return std::nullopt;
  std::size_t end = 0;
  while (end < picture.way.size() && procedure::holds(*picture.near, picture.way[end])) ++end;
  if (end == 0 || end == picture.way.size()) return std::nullopt;
  constexpr double kStepMm = 10;
  const double end_mm = std::ceil(picture.way_mm[end] / kStepMm) * kStepMm;
  return end_mm > input.min && end_mm < input.max ? std::optional(end_mm) : std::nullopt;
}

}  // namespace

AxisZoom::AxisZoom(QCustomPlot& plot, ShownRanges& ranges) : QObject(&plot), plot_(plot), ranges_(ranges) {
  plot_.installEventFilter(this);
  connect(&ranges_, &ShownRanges::changed, this, [this](const std::string& id) {
    for (const Axis& axis : axes_) {
      if (axis.input.id != id) continue;
      apply();
      redraw(plot_);
      emit changed();
      return;
    }
  });
}

void AxisZoom::setInputs(const fuzzy::Variable& x, const std::optional<fuzzy::Variable>& y) {
  axes_ = {{x, true}};
  if (y) axes_.push_back({*y, false});
  apply();
}

void AxisZoom::apply() {
  for (const Axis& axis : axes_) {
    const figures::Interval range = ranges_.of(axis.input);
    (axis.across ? plot_.xAxis : plot_.yAxis)->setRange(range.low, range.high);
  }
}

double AxisZoom::valueAt(const Axis& axis, QPointF place) const {
  return axis.across ? plot_.xAxis->pixelToCoord(place.x()) : plot_.yAxis->pixelToCoord(place.y());
}

// Who shows a new range may give this the inputs again: the loops below work on copies of the list.

void AxisZoom::zoom(QPointF around, double factor) {
  for (const Axis& axis : std::vector<Axis>(axes_)) ranges_.zoom(axis.input, valueAt(axis, around), factor);
}

void AxisZoom::pan(QPointF from, QPointF to) {
  for (const Axis& axis : std::vector<Axis>(axes_)) {
    ranges_.pan(axis.input, valueAt(axis, from) - valueAt(axis, to));
  }
}

void AxisZoom::showAll() {
  for (const Axis& axis : std::vector<Axis>(axes_)) ranges_.showAll(axis.input);
}

bool AxisZoom::eventFilter(QObject* watched, QEvent* event) {
  if (axes_.empty()) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::Wheel: {
      const auto& wheel = static_cast<const QWheelEvent&>(*event);
      const QPoint turned = wheel.angleDelta();
      if (turned.x() != 0 && std::abs(turned.x()) > std::abs(turned.y())) {
        const QRect area = plot_.axisRect()->rect();
        pan({0, 0}, {kPanPerNotch * area.width() * turned.x() / kNotch, 0});
      } else {
        zoom(wheel.position(), std::pow(kZoomPerNotch, -turned.y() / kNotch));
      }
      return true;
    }
    case QEvent::MouseButtonPress: {
      const auto& press = static_cast<const QMouseEvent&>(*event);
      if (press.button() != Qt::LeftButton || press.modifiers() != Qt::ShiftModifier) break;
      dragged_from_ = press.position();
      moved_ = false;
      plot_.setCursor(Qt::ClosedHandCursor);
      return true;
    }
    case QEvent::MouseMove: {
      if (!dragged_from_) break;
      const QPointF to = static_cast<const QMouseEvent&>(*event).position();
      if (!moved_ && (to - *dragged_from_).manhattanLength() < kDragFrom) return true;
      moved_ = true;
      pan(*dragged_from_, to);
      dragged_from_ = to;
      return true;
    }
    case QEvent::MouseButtonRelease:
      if (!dragged_from_) break;
      plot_.unsetCursor();
      if (const QPointF place = *std::exchange(dragged_from_, std::nullopt); !moved_) emit shiftClicked(place);
      return true;
    case QEvent::MouseButtonDblClick:
      if (static_cast<const QMouseEvent&>(*event).button() != Qt::LeftButton) break;
      showAll();
      return true;
    case QEvent::ContextMenu: {
      const auto& menu = static_cast<const QContextMenuEvent&>(*event);
      openMenu(menu.globalPos(), menu.pos());
      return true;
    }
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

void AxisZoom::openMenu(const QPoint& global, QPointF place) {
  auto* menu = new QMenu(&plot_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Zoom in"), this, [this, place] { zoom(place, 1 / (kZoomPerNotch * kZoomPerNotch)); });
  menu->addAction(tr("Zoom out"), this, [this, place] { zoom(place, kZoomPerNotch * kZoomPerNotch); });
  for (const Axis& axis : axes_) {
    const auto near_end_mm = nearEndMm(axis.input);
    if (!near_end_mm) continue;
    menu->addAction(tr("Show the near part, to %1 mm").arg(*near_end_mm), this,
                    [this, input = axis.input, end = *near_end_mm] {
                      ranges_.show(input, {input.min, end});
                    });
  }
  menu->addSeparator();
  menu->addAction(tr("Show all"), this, &AxisZoom::showAll);
  emit menuOpens(menu, place);
  menu->popup(global);
}

}  // namespace tactus::workbench
