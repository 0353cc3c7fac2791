#include "app/workbench/shell/frame_status.h"

#include <QEvent>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/shell/frame_clock.h"

namespace tactus::workbench {
namespace {

constexpr int kCalmMs = 200;

QString seriesText(const FrameClock::Times& times) {
  return FrameStatus::tr("last %1 ms, median %2 ms, largest %3 ms of %n edit(s)", nullptr,
                         static_cast<int>(times.edits))
      .arg(numberText(times.last_ms, 1), numberText(times.median_ms, 1), numberText(times.largest_ms, 1));
}

}  // namespace

FrameStatus::FrameStatus(const FrameClock& clock, QWidget* parent) : QLabel(parent), clock_(clock) {
  setTextFormat(Qt::PlainText);
  setMuted(*this);
  // Numbers that change with every frame can be neither read nor had for nothing.
  calm_.setSingleShot(true);
  calm_.setInterval(kCalmMs);
  connect(&calm_, &QTimer::timeout, this, &FrameStatus::showLast);
  connect(&clock_, &FrameClock::measured, this, [this] {
    if (!calm_.isActive()) calm_.start();
  });
  hide();
}

void FrameStatus::showLast() {
  setText(tr("Plots after %1 ms").arg(qRound(clock_.painted()->last_ms)));
  setVisible(true);
}

bool FrameStatus::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) setToolTip(explanation());
  return QLabel::event(event);
}

QString FrameStatus::explanation() const {
  const auto painted = clock_.painted();
  const auto finest = clock_.finest();
  if (!painted || !finest) return {};
  return tr("From an edit until every visible plot is painted with it: %1.").arg(seriesText(*painted)) +
         QLatin1Char('\n') + tr("Until map and surface are at their finest: %1.").arg(seriesText(*finest)) +
         QLatin1Char('\n') + tr("A screen of 60 Hz shows a picture every 16.7 ms.");
}

}  // namespace tactus::workbench
