#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/axis_zoom.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/landmark_marks.h"
#include "app/workbench/plot/plot_marks.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_grip.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {

GripMarks::GripMarks(QCustomPlot& plot, const QString& layer) : QCPLayerable(&plot, layer), font_(theme::smallFont()) {}

void GripMarks::setHandles(std::vector<Handle> handles) { handles_ = std::move(handles); }

void GripMarks::setLines(std::vector<Line> lines) { lines_ = std::move(lines); }

void GripMarks::setTag(const QString& text, double x, double membership, bool warns) {
  tag_ = text;
  tag_x_ = x;
  tag_membership_ = membership;
  tag_warns_ = warns;
}

void GripMarks::setUniverse(double min, double max) {
  min_ = min;
  max_ = max;
}

void GripMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

QPointF GripMarks::pixelOf(double x, double membership) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  return {area->axis(QCPAxis::atBottom)->coordToPixel(x), area->axis(QCPAxis::atLeft)->coordToPixel(membership)};
}

QRect GripMarks::clipRect() const { return mParentPlot->axisRect()->rect().adjusted(-10, -40, 10, 10); }

void GripMarks::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  QColor beyond = theme::border();
  beyond.setAlphaF(0.45F);
  const double first = pixelOf(min_, 0).x();
  const double last = pixelOf(max_, 0).x();
  if (first > area->left() + 1) {
    painter->fillRect(QRectF(QPointF(area->left(), area->top()), QPointF(first, area->bottom())), beyond);
  }
  if (last < area->right() - 1) {
    painter->fillRect(QRectF(QPointF(last, area->top()), QPointF(area->right(), area->bottom())), beyond);
  }

  painter->setPen(QPen(theme::accent(), 3));
  for (const Line& line : lines_) {
    painter->drawLine(QLineF(pixelOf(line.from_x, line.from_membership), pixelOf(line.to_x, line.to_membership)));
  }
  // What moves lies on top of what stays.
  for (const bool moves : {false, true}) {
    for (const Handle& handle : handles_) {
      if (handle.moves == moves) drawHandle(*painter, handle);
    }
  }
  if (!tag_.isEmpty()) drawTag(*painter);
}

void GripMarks::drawHandle(QCPPainter& painter, const Handle& handle) const {
  const QPointF at = pixelOf(handle.x, handle.membership);
  const double radius = handle.moves ? 7 : handle.large ? 6 : 3.5;
  if (handle.locked) {
    // A square with a bar reads as a bolt, also without color.
    const QRectF box(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
    painter.setPen(QPen(handle.moves ? theme::accent() : theme::mutedInk(), 1.5));
    painter.setBrush(theme::card());
    painter.drawRect(box);
    painter.drawLine(QLineF(box.left(), at.y(), box.right(), at.y()));
    return;
  }
  painter.setPen(QPen(handle.moves ? theme::accent() : theme::card(), handle.moves ? 2 : 1.5));
  painter.setBrush(handle.moves ? QBrush(theme::card()) : QBrush(handle.color));
  painter.drawEllipse(at, radius, radius);
}

void GripMarks::drawTag(QCPPainter& painter) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QFontMetricsF metrics(font_);
  const QPointF at = pixelOf(tag_x_, tag_membership_);
  const double width = metrics.horizontalAdvance(tag_) + 12;
  const double height = metrics.height() + 6;
  // Beside the handle, where the hand does not cover it, and never beyond the plot.
  const double left = at.x() + 14 + width <= area->right() ? at.x() + 14 : at.x() - 14 - width;
  const double top =
      std::clamp(at.y() - height / 2, area->top() + 2.0, std::max(area->top() + 2.0, area->bottom() - height - 2));
  const QRectF tag(std::max(left, area->left() + 2.0), top, width, height);
  painter.setPen(Qt::NoPen);
  painter.setBrush(tag_warns_ ? theme::warningFill() : theme::accent());
  painter.drawRoundedRect(tag, 4, 4);
  painter.setPen(tag_warns_ ? theme::warningInk() : QColor(Qt::white));
  painter.setFont(font_);
  painter.drawText(QPointF(tag.left() + 6, tag.bottom() - 3 - metrics.descent()), tag_);
}

namespace {

using Part = Grip::Part;

constexpr int kLabelRows = 2;
constexpr int kMargin = 4 * theme::kGrid;  // px left of the axis; handles at the end of the universe reach into it
constexpr double kTop = 1.12;              // membership at the upper side: room for the handles at 1
constexpr double kDragFrom = 3;            // px that tell a drag from a click

}  // namespace

MembershipEditorPlot::MembershipEditorPlot(ShownRanges& ranges, QWidget* parent)
    : QWidget(parent), ranges_(ranges), plot_(makePlot(this)), zoom_(new AxisZoom(*plot_, ranges)) {
  makeColumn(this, {plot_});
  setMinimumSize(320, 168);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Membership functions"));
  plot_->setMouseTracking(true);

  labels_ = new TermLabels(*plot_, kLabelRows);
  landmarks_ = new LandmarkMarks(*plot_, LandmarkMarks::Place::kUnder);
  marker_ = new ValueMarker(*plot_);
  // The overlay has a buffer of its own; what follows the hand is drawn without the shapes.
  marks_ = new GripMarks(*plot_, QStringLiteral("overlay"));
  plot_->xAxis->grid()->setVisible(false);
  plot_->axisRect()->setAutoMargins(QCP::msBottom);
  keepFitted(*this, [this] {
    plot_->axisRect()->setMargins(QMargins(appearance::scaled(kMargin), labels_->height() + 4, 3 * theme::kGrid, 0));
  });

  connect(zoom_, &AxisZoom::changed, this, [this] {
    fitAxis();
    drawTerms();
  });
  connect(zoom_, &AxisZoom::menuOpens, this, [this](QMenu* menu, QPointF place) { addToMenu(*menu, place); });
  connect(plot_, &QCustomPlot::mousePress, this, &MembershipEditorPlot::onPress);
  connect(plot_, &QCustomPlot::mouseMove, this, &MembershipEditorPlot::onMove);
  connect(plot_, &QCustomPlot::mouseRelease, this, &MembershipEditorPlot::onRelease);
}

void MembershipEditorPlot::setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  const bool another = variable.id != variable_.id;
  variable_ = variable;
  landmarks_->setVariable(variable);
  terms_ = terms;
  if (another || (hovered_ && !holds(terms_, *hovered_))) hovered_.reset();
  if (another || (selected_ && !holds(terms_, *selected_))) selected_.reset();
  if (another || (pressed_ && !holds(terms_, *pressed_))) pressed_.reset();
  if (!isDragging()) fitAxis();
  drawTerms();
}

void MembershipEditorPlot::setGhost(std::vector<fuzzy::Term> before) {
  if (before == before_) return;
  before_ = std::move(before);
  drawTerms();
}

void MembershipEditorPlot::drawGhost() {
  const QCPRange range = plot_->xAxis->range();
  addGhosts(*plot_, variable_, terms_, before_, range.lower, range.upper, isDragging());
}

void MembershipEditorPlot::setLocked(std::vector<std::vector<bool>> locked) {
  locked_ = std::move(locked);
  drawMarks();
}

void MembershipEditorPlot::setSumToOne(bool sum_to_one) {
  sum_to_one_ = sum_to_one;
  drawMarks();
}

void MembershipEditorPlot::setSelected(std::optional<Grip> grip) {
  if (grip && !holds(terms_, *grip)) grip.reset();
  if (grip == selected_) return;
  selected_ = grip;
  drawTerms();
}

void MembershipEditorPlot::setValue(std::optional<double> value) {
  value_ = value;
  std::vector<double> memberships;
  for (const fuzzy::Term& term : terms_) {
    const double membership = value_ ? fuzzy::MembershipFunction::of(term)(*value_) : 0;
    if (membership > 0) memberships.push_back(membership);
  }
  marker_->set(value_, std::move(memberships));
  redraw(*plot_);
}

void MembershipEditorPlot::setStopped(const QString& reason) {
  if (reason == stopped_) return;
  stopped_ = reason;
  drawMarks();
}

QPointF MembershipEditorPlot::pixelOf(double x, double membership) const {
  return frame().pixelOf(x, membership) + QPointF(plot_->pos());
}

void MembershipEditorPlot::fitAxis() {
  double low = variable_.min;
  double high = variable_.max;
  const double range = high - low;
  for (const fuzzy::Term& term : terms_) {
    const std::size_t index = static_cast<std::size_t>(&term - terms_.data());
    for (const GripHandle& handle : handlesOf(terms_, index)) {
      // A term far outside must not press the universe into a corner.
      low = std::min(low, std::max(handle.x, variable_.min - range / 2));
      high = std::max(high, std::min(handle.x, variable_.max + range / 2));
    }
  }
  styleAxis(*plot_->xAxis, variable_);
  styleAxis(*plot_->yAxis, membershipAxis(kTop));
  zoom_->setInputs(variable_);
  // All of it has room for the vertices beside the universe too.
  if (!ranges_.isPart(variable_)) plot_->xAxis->setRange(low, high);
  plot_->xAxis->setLabel(axisText(variable_));
  marks_->setUniverse(variable_.min, variable_.max);
}

void MembershipEditorPlot::drawTerms() {
  plot_->clearGraphs();
  const QCPRange range = plot_->xAxis->range();
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const TermOutline outline = outlineOf(terms_[i], range.lower, range.upper);
    const bool strong = selected_ && selected_->term == i;
    addShape(*plot_, termLine(variable_, terms_, i), strong ? 2.4 : 1.4, strong ? 0.32F : 0.14F)
        .setData(outline.x, outline.membership, true);
  }
  drawGhost();
  labels_->setTerms(variable_, terms_);
  setValue(value_);
  drawMarks();
}

std::optional<Grip> MembershipEditorPlot::shownGrip() const {
  if (pressed_) return pressed_;
  if (hovered_) return hovered_;
  return hasFocus() ? selected_ : std::nullopt;
}

bool MembershipEditorPlot::moves(std::size_t term, double x, std::size_t point) const {
  const std::optional<Grip> grip = shownGrip();
  if (!grip) return false;
  const std::vector<std::size_t> points = pointsOf(terms_, *grip);
  if (term == grip->term) return std::find(points.begin(), points.end(), point) != points.end();
  if (!sum_to_one_ || terms_[grip->term].shape == fuzzy::Shape::kGaussian) return false;
  const double same = 1e-9 * (variable_.max - variable_.min);
  return std::any_of(points.begin(), points.end(),
                     [&](std::size_t p) { return std::abs(terms_[grip->term].points[p] - x) <= same; });
}

void MembershipEditorPlot::drawMarks() {
  const std::optional<Grip> grip = shownGrip();
  std::vector<GripMarks::Handle> handles;
  std::vector<GripMarks::Line> lines;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const std::vector<GripHandle> of_term = handlesOf(terms_, t);
    for (const GripHandle& handle : of_term) {
      const std::size_t point = handle.grip.point;
      const bool locked = t < locked_.size() && point < locked_[t].size() && locked_[t][point];
      handles.push_back({handle.x, handle.membership, termLine(variable_, terms_, t), selected_ && selected_->term == t,
                         locked, moves(t, handle.x, point)});
    }
    if (!grip || grip->term != t || grip->part == Part::kVertex) continue;
    for (std::size_t i = 0; i + 1 < of_term.size(); ++i) {
      const bool first = i == 0;
      const bool last = i + 2 == of_term.size();
      if ((grip->part == Part::kLeftEdge && !first) || (grip->part == Part::kRightEdge && !last)) continue;
      if (terms_[t].shape == fuzzy::Shape::kGaussian) continue;
      lines.push_back({of_term[i].x, of_term[i].membership, of_term[i + 1].x, of_term[i + 1].membership});
    }
  }
  marks_->setHandles(std::move(handles));
  marks_->setLines(std::move(lines));
  if (grip) {
    const QString what = gripText(variable_, terms_, *grip);
    const std::vector<GripHandle> of_term = handlesOf(terms_, grip->term);
    const auto held = std::find_if(of_term.begin(), of_term.end(), [&](const auto& h) { return h.grip == *grip; });
    const auto& p = terms_[grip->term].points;
    double x = coreMiddle(variable_, terms_[grip->term]);
    double membership = 0.5;
    if (held != of_term.end()) {
      x = held->x;
      membership = held->membership;
    } else if (grip->part == Part::kLeftEdge) {
      x = (p[0] + p[1]) / 2;
    } else if (grip->part == Part::kRightEdge) {
      x = (p[p.size() - 2] + p[p.size() - 1]) / 2;
    }
    marks_->setTag(stopped_.isEmpty() ? what : tr("%1 · stopped by %2").arg(what, stopped_), x, membership,
                   !stopped_.isEmpty());
  } else {
    marks_->setTag({}, 0, 0, false);
  }
  redraw(*plot_);
}

PlotFrame MembershipEditorPlot::frame() const {
  const QCPRange range = plot_->xAxis->range();
  return {QRectF(plot_->axisRect()->rect()), range.lower, range.upper, kTop};
}

void MembershipEditorPlot::addToMenu(QMenu& menu, QPointF place) {
  const auto grip = gripAt(frame(), terms_, place, selected_ ? std::optional(selected_->term) : std::nullopt);
  if (!grip || grip->part != Part::kVertex) return;
  emit selected(grip);
  setSelected(grip);
  menu.addSeparator();
  menu.addAction(tr("Where does this vertex come from?"), this,
                 [this, grip] { emit originAsked(grip->term, grip->point); });
}

void MembershipEditorPlot::onPress(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || terms_.empty()) return;
  setFocus(Qt::MouseFocusReason);
  press_place_ = event->position();
  press_value_ = frame().valueAt(press_place_.x());
  pressed_ = gripAt(frame(), terms_, press_place_, selected_ ? std::optional(selected_->term) : std::nullopt);
  dragging_ = false;
  stopped_.clear();
  emit selected(pressed_);
  setSelected(pressed_);
  drawMarks();
}

void MembershipEditorPlot::onMove(QMouseEvent* event) {
  const QPointF place = event->position();
  if (!pressed_) {
    if (!event->buttons().testFlag(Qt::LeftButton)) hoverAt(place);
    return;
  }
  if (!dragging_) {
    if (std::abs(place.x() - press_place_.x()) < kDragFrom) return;
    dragging_ = true;
    emit moveBegun(*pressed_);
  }
  emit moved(frame().valueAt(place.x()) - press_value_);
}

void MembershipEditorPlot::onRelease(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressed_) return;
  const bool was_dragging = dragging_;
  endDrag();
  if (was_dragging) emit moveEnded();
  hoverAt(event->position());
}

void MembershipEditorPlot::endDrag() {
  pressed_.reset();
  dragging_ = false;
  stopped_.clear();
  fitAxis();
  drawTerms();
}

void MembershipEditorPlot::hoverAt(QPointF place) {
  const auto grip = gripAt(frame(), terms_, place, selected_ ? std::optional(selected_->term) : std::nullopt);
  if (grip == hovered_) return;
  hovered_ = grip;
  if (!grip) {
    plot_->unsetCursor();
  } else {
    plot_->setCursor(grip->part == Part::kTerm ? Qt::OpenHandCursor : Qt::SizeHorCursor);
  }
  drawMarks();
}

bool MembershipEditorPlot::event(QEvent* event) {
  // A shortcut of the window must not take the key that cancels a drag.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
      (isDragging() || stepping_)) {
    event->accept();
    return true;
  }
  // The lines before an edit are mixed with the ground.
  if (event->type() == QEvent::PaletteChange && labels_) drawTerms();
  return QWidget::event(event);
}

void MembershipEditorPlot::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Escape && (isDragging() || stepping_)) {
    const bool was_dragging = isDragging();
    stepping_ = false;
    if (was_dragging) endDrag();
    emit moveCancelled();
  } else if ((key == Qt::Key_Left || key == Qt::Key_Right) && selected_ && !isDragging()) {
    stepping_ = true;
    emit stepped(key == Qt::Key_Right ? 1 : -1, event->modifiers().testFlag(Qt::ShiftModifier));
  } else if ((key == Qt::Key_Up || key == Qt::Key_Down) && !isDragging() && !stepping_) {
    emit nextWanted(key == Qt::Key_Down ? 1 : -1);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void MembershipEditorPlot::keyReleaseEvent(QKeyEvent* event) {
  const int key = event->key();
  if (!stepping_ || event->isAutoRepeat() || (key != Qt::Key_Left && key != Qt::Key_Right)) {
    QWidget::keyReleaseEvent(event);
    return;
  }
  stepping_ = false;
  stopped_.clear();
  emit stepsEnded();
}

void MembershipEditorPlot::focusInEvent(QFocusEvent* event) {
  drawMarks();
  QWidget::focusInEvent(event);
}

void MembershipEditorPlot::focusOutEvent(QFocusEvent* event) {
  // Whatever takes the keyboard away ends what it was moving.
  if (std::exchange(stepping_, false)) emit stepsEnded();
  drawMarks();
  QWidget::focusOutEvent(event);
}

void MembershipEditorPlot::leaveEvent(QEvent* event) {
  hovered_.reset();
  drawMarks();
  QWidget::leaveEvent(event);
}

void MembershipEditorPlot::fillTable(PlotTable& table) const { workbench::fillTable(table, variable_, terms_); }

void MembershipEditorPlot::paintPicture(QCPPainter& painter, const QSize& size) {
  paintPlot(*plot_, painter, size, {marker_, marks_});
}

}  // namespace tactus::workbench
