#include "app/workbench/labs/speed/trace_row.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "experiments/stroke.h"

namespace tactus::workbench {

StrokePreview::StrokePreview(LabData& lab_data, QWidget* parent)
    : QWidget(parent), traces_(lab_data), row_(new TraceRow(this)) {
  makeColumn(this, {row_});
  row_->setReadOnly();
  connect(&traces_, &StrokeTraces::arrived, this, &StrokePreview::refreshState);
}

void StrokePreview::showStroke(const elicitation::StrokeKey& stroke) {
  stroke_ = stroke;
  refreshState();
}

void StrokePreview::refreshState() {
  if (!stroke_) return;
  const auto set = traces_.strokes(stroke_->participant, stroke_->level);
  const QString title =
      QStringLiteral("%1 · %2").arg(harmless(text(stroke_->participant)), harmless(text(stroke_->level)));
  row_->show(title, theme::accent(), set, TraceRow::topOf(TraceRow::highestOf(set.get())));
  row_->setChosen(stroke_->stroke);
}

namespace {

constexpr double kTraceReach = 7;   // px: how far from a mark the mouse takes hold of it
constexpr double kBetween = 18;     // px between two recordings
constexpr std::size_t kLeast = 20;  // samples that a stroke keeps: less says nothing about a speed

bool isCounted(const study::StrokeRecord& stroke) {
  return stroke.verdict == name(experiments::StrokeVerdict::kAccepted);
}

}  // namespace

TraceRow::TraceRow(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

double TraceRow::highestOf(const StrokeSet* set) {
  float highest = 0;
  if (set != nullptr) {
    for (const StrokeTrace& stroke : set->strokes) {
      for (const float speed : stroke.speed_mm_s) highest = std::max(highest, speed);
    }
  }
  return highest;
}

double TraceRow::topOf(double highest_mm_s) { return std::max(50.0, std::ceil(highest_mm_s / 50) * 50); }

void TraceRow::setChosen(std::optional<int> number) {
  if (number == chosen_) return;
  chosen_ = number;
  update();
}

void TraceRow::show(const QString& title, const QColor& color, std::shared_ptr<const StrokeSet> set, double top_mm_s) {
  if (set != set_) {
    held_.reset();
    moved_.reset();
  }
  title_ = title;
  color_ = color;
  set_ = std::move(set);
  top_mm_s_ = top_mm_s;
  setAccessibleName(tr("Strokes of %1").arg(title));
  update();
}

QRectF TraceRow::area() const {
  const QFontMetrics metrics(theme::smallFont());
  const double left = metrics.horizontalAdvance(QStringLiteral("0000")) + theme::kGrid;
  return QRectF(rect()).adjusted(left, metrics.height() + 6, -theme::kGrid, -metrics.height() - 4);
}

double TraceRow::scale() const {
  double seconds = 0;
  for (const StrokeTrace& stroke : set_->strokes) seconds += stroke.durationS();
  const double gaps = kBetween * static_cast<double>(set_->strokes.size() - 1);
  return seconds > 0 ? std::max(1.0, area().width() - gaps) / seconds : 1;
}

double TraceRow::left(std::size_t stroke) const {
  double x = area().left();
  for (std::size_t i = 0; i < stroke; ++i) x += set_->strokes[i].durationS() * scale() + kBetween;
  return x;
}

double TraceRow::y(double speed_mm_s) const {
  const QRectF place = area();
  return place.bottom() - std::clamp(speed_mm_s / top_mm_s_, -0.05, 1.03) * place.height();
}

QPointF TraceRow::markPlace(std::size_t index, bool begin) const {
  const StrokeTrace& stroke = set_->strokes[index];
  const study::StrokeRecord& record = shownRecord(index);
  const double at_s = stroke.timeOf(begin ? record.first : record.last - 1);
  return {left(index) + at_s * scale(), area().center().y()};
}

const study::StrokeRecord& TraceRow::shownRecord(std::size_t stroke) const {
  return moved_ && held_ && held_->stroke == stroke ? *moved_ : set_->strokes[stroke].record;
}

std::optional<TraceRow::Mark> TraceRow::markAt(const QPointF& place) const {
  std::optional<Mark> best;
  double nearest = kTraceReach;
  for (std::size_t i = 0; set_ && i < set_->strokes.size(); ++i) {
    if (set_->strokes[i].time_s.empty()) continue;
    for (const bool begin : {true, false}) {
      const double distance = std::abs(markPlace(i, begin).x() - place.x());
      if (distance > nearest) continue;
      nearest = distance;
      best = Mark{i, begin};
    }
  }
  return best;
}

std::optional<std::size_t> TraceRow::strokeAt(const QPointF& place) const {
  for (std::size_t i = 0; set_ && i < set_->strokes.size(); ++i) {
    const double from = left(i);
    if (place.x() >= from && place.x() <= from + set_->strokes[i].durationS() * scale()) return i;
  }
  return std::nullopt;
}

study::StrokeRecord TraceRow::movedTo(const Mark& mark, double place) const {
  const StrokeTrace& stroke = set_->strokes[mark.stroke];
  study::StrokeRecord wanted = stroke.record;
  const std::size_t sample = stroke.sampleAt((place - left(mark.stroke)) / scale());
  if (mark.begin) {
    wanted.first = std::min(sample, wanted.last > kLeast ? wanted.last - kLeast : 0);
  } else {
    wanted.last = std::min(std::max(sample + 1, wanted.first + kLeast), stroke.time_s.size());
  }
  return wanted;
}

void TraceRow::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  paintAxis(painter);
  const QRectF place = area();
  painter.setPen(theme::readableText(color_));
  painter.setFont(theme::headingFont());
  painter.drawText(QRectF(place.left(), 0, place.width(), place.top() - 2), Qt::AlignLeft | Qt::AlignVCenter, title_);
  painter.setFont(theme::smallFont());
  if (!set_ || set_->strokes.empty()) {
    painter.setPen(theme::mutedInk());
    painter.drawText(place, Qt::AlignCenter, set_ ? tr("No strokes at this level.") : tr("Reading the recordings…"));
    return;
  }
  for (std::size_t i = 0; i < set_->strokes.size(); ++i) paintStroke(painter, i);
}

void TraceRow::paintAxis(QPainter& painter) const {
  const QRectF place = area();
  const QFontMetrics metrics(painter.font());
  for (const double share : {0.0, 0.5, 1.0}) {
    const double at = y(share * top_mm_s_);
    painter.setPen(QPen(theme::grid(), 1));
    painter.drawLine(QPointF(place.left(), at), QPointF(place.right(), at));
    painter.setPen(theme::mutedInk());
    painter.drawText(QRectF(0, at - 10, place.left() - 6, 20), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(share * top_mm_s_, 0));
  }
  painter.drawText(QRectF(place.left(), 0, place.width(), place.top() - 2), Qt::AlignRight | Qt::AlignVCenter,
                   tr("mm/s"));
}

void TraceRow::paintStroke(QPainter& painter, std::size_t index) const {
  const StrokeTrace& stroke = set_->strokes[index];
  const study::StrokeRecord& record = shownRecord(index);
  const QRectF place = area();
  const double from = left(index);
  const double width = stroke.durationS() * scale();
  const bool counted = isCounted(record);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::window());
  painter.drawRect(QRectF(from, place.top(), width, place.height()));
  const double begin = markPlace(index, true).x();
  const double end = markPlace(index, false).x();
  if (counted) {
    QColor inside = color_;
    inside.setAlphaF(0.12F);
    painter.setBrush(theme::onCard(inside));
    painter.drawRect(QRectF(begin, place.top(), end - begin, place.height()));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(counted ? color_ : theme::mutedInk(), 1.6));
  paintTrace(painter, index);
  if (chosen_ == record.number) {
    painter.setPen(QPen(theme::accent(), 2));
    painter.drawRoundedRect(QRectF(from - 2, place.top() - 2, width + 4, place.height() + 4), 3, 3);
  }
  for (const bool first : {true, false}) {
    const double at = first ? begin : end;
    const bool held = held_ && *held_ == Mark{index, first};
    painter.setPen(QPen(held ? theme::accent() : theme::ink(), held ? 2 : 1.2));
    painter.drawLine(QPointF(at, place.top()), QPointF(at, place.bottom()));
    painter.setBrush(held ? theme::accent() : theme::ink());
    painter.setPen(Qt::NoPen);
    painter.drawRoundedRect(QRectF(at - 3, place.top() - 1, 6, 10), 2, 2);
  }
  painter.setPen(counted ? theme::mutedInk() : theme::warningInk());
  const QString number = counted ? tr("%1 · %2 s")
                                       .arg(record.number)
                                       .arg(numberText(stroke.timeOf(record.last - 1) - stroke.timeOf(record.first)))
                                 : tr("%1 · left out").arg(record.number);
  painter.drawText(QRectF(from, place.bottom() + 1, std::max(width, 20.0) + kBetween, 20), Qt::AlignLeft | Qt::AlignTop,
                   painter.fontMetrics().elidedText(number, Qt::ElideRight, static_cast<int>(width + kBetween)));
}

// Each column of pixels shows the lowest and the highest of its samples, so that no peak is lost.
void TraceRow::paintTrace(QPainter& painter, std::size_t index) const {
  const StrokeTrace& stroke = set_->strokes[index];
  const double from = left(index);
  const double px_per_s = scale();
  QPolygonF line;
  for (std::size_t i = 0; i < stroke.speed_mm_s.size();) {
    const double column = std::floor(from + stroke.speed_time_s[i] * px_per_s);
    std::size_t low = i;
    std::size_t high = i;
    std::size_t end = i;
    for (; end < stroke.speed_mm_s.size() && from + stroke.speed_time_s[end] * px_per_s < column + 1; ++end) {
      if (stroke.speed_mm_s[end] < stroke.speed_mm_s[low]) low = end;
      if (stroke.speed_mm_s[end] > stroke.speed_mm_s[high]) high = end;
    }
    end = std::max(end, i + 1);
    for (const std::size_t at : {std::min(low, high), std::max(low, high)}) {
      line << QPointF(from + stroke.speed_time_s[at] * px_per_s, y(stroke.speed_mm_s[at]));
      if (low == high) break;
    }
    i = end;
  }
  painter.drawPolyline(line);
}

void TraceRow::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || read_only_) return;
  held_ = markAt(event->position());
  moved_.reset();
  update();
}

void TraceRow::mouseMoveEvent(QMouseEvent* event) {
  if (read_only_) return;
  if (held_ && event->buttons().testFlag(Qt::LeftButton)) {
    moved_ = movedTo(*held_, event->position().x());
    update();
    return;
  }
  setCursor(markAt(event->position()) ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

void TraceRow::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || read_only_) return;
  if (!moved_) {
    if (const auto stroke = strokeAt(event->position())) emit strokeChosen(set_->strokes[*stroke].record);
  }
  if (!held_) return;
  // The moved marks stay on the screen until the corrected record has come.
  if (moved_) emit marked(set_->strokes[held_->stroke].record, *moved_);
  if (!moved_) held_.reset();
  update();
}

// Esc lets a mark go where it was.
void TraceRow::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !held_) {
    QWidget::keyPressEvent(event);
    return;
  }
  held_.reset();
  moved_.reset();
  update();
}

void TraceRow::contextMenuEvent(QContextMenuEvent* event) {
  const auto stroke = strokeAt(event->pos());
  if (!stroke || read_only_) return;
  const study::StrokeRecord before = set_->strokes[*stroke].record;
  study::StrokeRecord wanted = before;
  const bool counted = isCounted(before);
  wanted.verdict = name(counted ? experiments::StrokeVerdict::kRejected : experiments::StrokeVerdict::kAccepted);
  QMenu menu(this);
  menu.addAction(
      counted ? tr("&Leave stroke %1 out").arg(before.number) : tr("&Count stroke %1 again").arg(before.number), this,
      [this, before, wanted] { emit judged(before, wanted); });
  menu.exec(event->globalPos());
}

bool TraceRow::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* const help = static_cast<QHelpEvent*>(event);
    const auto stroke = strokeAt(help->pos());
    if (!stroke || read_only_) {
      QToolTip::hideText();
      return true;
    }
    const StrokeTrace& trace = set_->strokes[*stroke];
    QString said = trace.failure.empty()
                       ? tr("Stroke %1: counts from %2 s to %3 s of its recording. Drag a mark to correct it; "
                            "right-click to leave the stroke out.")
                             .arg(trace.record.number)
                             .arg(numberText(trace.timeOf(trace.record.first), 3),
                                  numberText(trace.timeOf(trace.record.last - 1), 3))
                       : text(trace.failure);
    if (trace.record.entry.supersedes) {
      said += QLatin1Char('\n') + tr("Corrected; the earlier record is still in the file.");
    }
    QToolTip::showText(help->globalPos(), said, this);
    return true;
  }
  return QWidget::event(event);
}

}  // namespace tactus::workbench
