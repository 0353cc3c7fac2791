#include "app/workbench/collect/monitor_window.h"

#include <QCloseEvent>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/monitor_controller.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"

namespace tactus::workbench {
namespace {

constexpr double kLeastTop = 1;  // N: a small force is not blown up

}  // namespace

ForcePlot::ForcePlot(const ForceTrace& trace, QWidget* parent) : QWidget(parent), trace_(trace) {
  setAccessibleName(tr("Force of the last seconds"));
}

void ForcePlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  const QFontMetrics metrics(painter.font());
  const int left = metrics.horizontalAdvance(QStringLiteral("0.0 N")) + theme::kGrid;
  const QRectF area = QRectF(rect()).adjusted(left, theme::kGrid, -4, -metrics.height() - 4);

  double highest = kLeastTop;
  for (const ForceTrace::Point& point : trace_.points()) {
    highest = std::max({highest, point.commanded_n, point.delivered_n});
  }
  const double top = std::ceil(highest * 2 - 1e-9) / 2;  // whole halves of a newton
  const auto y = [&](double force_n) { return area.bottom() - std::clamp(force_n / top, -0.05, 1.05) * area.height(); };
  for (int tick = 0; tick <= 2; ++tick) {
    const double force_n = top * tick / 2;
    painter.setPen(QPen(theme::grid(), 1));
    painter.drawLine(QPointF(area.left(), y(force_n)), QPointF(area.right(), y(force_n)));
    painter.setPen(theme::mutedInk());
    painter.drawText(QRectF(0, y(force_n) - 10, left - theme::kGrid, 20), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(force_n) + QStringLiteral(" N"));
  }
  painter.setPen(theme::mutedInk());
  painter.drawText(QRectF(area.left(), area.bottom() + 2, area.width(), metrics.height() + 2), Qt::AlignRight,
                   tr("the last %1 s").arg(ForceTrace::kSeconds));
  if (trace_.newest() == nullptr) {
    painter.drawText(area, Qt::AlignCenter, tr("No device is in use."));
    return;
  }
  const std::int64_t end_ns = trace_.newest()->time_ns;
  const auto x = [&](std::int64_t time_ns) {
    return area.right() - static_cast<double>(end_ns - time_ns) * 1e-9 / ForceTrace::kSeconds * area.width();
  };
  QPainterPath commanded;
  QPainterPath delivered;
  bool first = true;
  for (const ForceTrace::Point& point : trace_.points()) {
    const double at = x(point.time_ns);
    if (first) {
      commanded.moveTo(at, y(0));
      delivered.moveTo(at, y(point.delivered_n));
    } else {
      delivered.lineTo(at, y(point.delivered_n));
    }
    commanded.lineTo(at, y(point.commanded_n));
    first = false;
  }
  commanded.lineTo(area.right(), y(0));
  QColor band = theme::accent();
  band.setAlphaF(0.22F);
  painter.fillPath(commanded, theme::onCard(band));
  painter.setPen(QPen(theme::accent(), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(delivered);
}

namespace {

constexpr int kSideWidth = 46 * theme::kGrid;  // px
constexpr int kForceMs = 50;                   // a number that changes faster cannot be read

QVBoxLayout* columnIn(QWidget& card) {
  auto* column = new QVBoxLayout(&card);
  column->setContentsMargins(2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid);
  column->setSpacing(theme::kGrid);
  return column;
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(theme::headingFont());
  setInk(*label, theme::mutedInk());
  return label;
}

// A mark before the words, so that no kind is told by color alone.
QString marked(const MonitorLine& line) {
  using Kind = MonitorLine::Kind;
  const char* const mark = line.kind == Kind::kAnswer     ? "✓"
                           : line.kind == Kind::kUnscored ? "↻"
                           : line.kind == Kind::kNote     ? "✎"
                           : line.kind == Kind::kCall     ? "!"
                                                          : "—";
  const QString time = QDateTime::fromMSecsSinceEpoch(line.utc_ms).toString(QStringLiteral("HH:mm:ss"));
  return QStringLiteral("%1  %2  %3").arg(time, QString::fromUtf8(mark), harmless(line.text));
}

}  // namespace

MonitorWindow::MonitorWindow(MonitorController& monitor, QWidget* parent)
    : QWidget(parent, Qt::Window),
      monitor_(monitor),
      code_(new QLabel(this)),
      mark_(new Card(this)),
      mark_text_(new QLabel(mark_)),
      call_(new Card(this)),
      call_text_(new QLabel(call_)),
      coming_(new QPushButton(tr("I have seen it and am &coming"), call_)),
      screen_(new QLabel(this)),
      now_(new QLabel(this)),
      device_(new QLabel(this)),
      reading_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      share_(new QLabel(this)),
      pause_(new PrimaryButton({}, this)),
      note_(new QLineEdit(this)),
      store_note_(new QPushButton(tr("Add the note"), this)),
      note_hint_(new QLabel(this)),
      plot_(new ForcePlot(monitor.trace(), this)),
      force_(new QLabel(this)),
      course_(new QListWidget(this)),
      calm_(new QTimer(this)) {
  setWindowTitle(tr("Session – Tactus"));
  setAttribute(Qt::WA_ShowWithoutActivating);
  setWindowFlag(Qt::WindowDoesNotAcceptFocus);
  setMinimumSize(880, 560);
  calm_->setSingleShot(true);
  calm_->setInterval(kForceMs);

  auto* side = new QVBoxLayout;
  side->setSpacing(theme::kGrid + 4);
  side->addWidget(call_);
  side->addWidget(makeState());
  side->addWidget(makeNotes());
  side->addStretch(1);
  auto* right = new QVBoxLayout;
  right->setSpacing(theme::kGrid + 4);
  right->addWidget(makeForce(), 2);
  right->addWidget(makeCourse(), 3);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid);
  layout->setSpacing(theme::kGrid + 4);
  auto* left = new QWidget(this);
  left->setFixedWidth(kSideWidth);
  left->setLayout(side);
  side->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(left);
  layout->addLayout(right, 1);

  call_->setColors(theme::errorFill(), theme::errorInk());
  call_text_->setFont(theme::headingFont());
  call_text_->setWordWrap(true);
  setInk(*call_text_, theme::errorInk());
  QVBoxLayout* const call = columnIn(*call_);
  call->addWidget(call_text_);
  call->addWidget(coming_);
  connect(coming_, &QPushButton::clicked, &monitor_, &MonitorController::answerCall);

  connect(&monitor_, &MonitorController::changed, this, &MonitorWindow::refreshState);
  connect(&monitor_, &MonitorController::lineAdded, this, &MonitorWindow::addLines);
  connect(&monitor_, &MonitorController::traced, this, [this] {
    if (!calm_->isActive()) calm_->start();
  });
  connect(calm_, &QTimer::timeout, this, &MonitorWindow::followForce);
  connect(pause_, &QPushButton::clicked, this, [this] { monitor_.isPaused() ? monitor_.goOn() : monitor_.pause(); });
  connect(note_, &QLineEdit::returnPressed, this, &MonitorWindow::storeNote);
  connect(note_, &QLineEdit::textChanged, this, &MonitorWindow::refreshState);
  connect(store_note_, &QPushButton::clicked, this, &MonitorWindow::storeNote);
  refreshState();
  followForce();
  addLines();
}

QWidget* MonitorWindow::makeState() {
  auto* card = new Card(this);
  QVBoxLayout* const column = columnIn(*card);
  code_->setFont(theme::titleFont());
  code_->setTextFormat(Qt::PlainText);
  mark_text_->setFont(theme::smallFont());
  setInk(*mark_text_, theme::warningInk());
  mark_->setColors(theme::warningFill(), theme::warningFill());
  auto* badge_row = new QHBoxLayout(mark_);
  badge_row->setContentsMargins(theme::kGrid, 2, theme::kGrid, 2);
  badge_row->addWidget(mark_text_);
  auto* head = new QHBoxLayout;
  head->addWidget(code_, 1);
  head->addWidget(mark_);
  QFont big = theme::titleFont();
  big.setPointSizeF(big.pointSizeF() + 5);
  screen_->setFont(big);
  for (QLabel* label : {screen_, now_, device_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
  }
  setInk(*now_, theme::mutedInk());
  progress_->setTextVisible(false);
  progress_->setFixedHeight(theme::kGrid);
  progress_->setAccessibleName(tr("Progress of this part"));
  setMuted(*share_);
  auto* progress = new QHBoxLayout;
  progress->setSpacing(theme::kGrid);
  progress->addWidget(progress_, 1);
  progress->addWidget(share_);
  column->addLayout(head);
  column->addWidget(screen_);
  column->addWidget(now_);
  column->addLayout(progress);
  setMuted(*reading_);
  reading_->setWordWrap(true);
  column->addWidget(reading_);
  column->addSpacing(theme::kGrid / 2);
  column->addWidget(heading(tr("Device"), card));
  column->addWidget(device_);
  column->addSpacing(theme::kGrid / 2);
  column->addWidget(pause_);
  return card;
}

QWidget* MonitorWindow::makeNotes() {
  auto* card = new Card(this);
  QVBoxLayout* const column = columnIn(*card);
  column->addWidget(heading(tr("Notes"), card));
  auto* quick = new QHBoxLayout;
  quick->setSpacing(theme::kGrid);
  for (const QString& words : {tr("Interrupted"), tr("Talked"), tr("Grip changed")}) {
    auto* button = new QPushButton(words, card);
    button->setMinimumHeight(4 * theme::kGrid);
    button->setToolTip(tr("Adds this note with the time"));
    connect(button, &QPushButton::clicked, this, [this, words] { monitor_.note(words); });
    quick->addWidget(button);
  }
  column->addLayout(quick);
  note_->setPlaceholderText(tr("Another note"));
  note_->setAccessibleName(tr("Another note"));
  note_->setMinimumHeight(4 * theme::kGrid);
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kGrid);
  row->addWidget(note_, 1);
  row->addWidget(store_note_);
  column->addLayout(row);
  note_hint_->setText(tr("Pause the session to type: the keyboard is the participant's."));
  note_hint_->setWordWrap(true);
  setMuted(*note_hint_);
  column->addWidget(note_hint_);
  return card;
}

QWidget* MonitorWindow::makeForce() {
  auto* card = new Card(this);
  QVBoxLayout* const column = columnIn(*card);
  auto* head = new QHBoxLayout;
  head->addWidget(heading(tr("Force: commanded (filled) and delivered (line)"), card));
  head->addStretch(1);
  force_->setTextFormat(Qt::PlainText);
  head->addWidget(force_);
  column->addLayout(head);
  column->addWidget(plot_, 1);
  return card;
}

QWidget* MonitorWindow::makeCourse() {
  auto* card = new Card(this);
  QVBoxLayout* const column = columnIn(*card);
  column->addWidget(heading(tr("Course of the session"), card));
  course_->setFrameShape(QFrame::NoFrame);
  course_->setSelectionMode(QAbstractItemView::NoSelection);
  course_->setWordWrap(true);
  course_->setAccessibleName(tr("Course of the session"));
  column->addWidget(course_, 1);
  return card;
}

void MonitorWindow::refreshState() {
  const NurseView& nurse = monitor_.nurse();
  const bool paused = monitor_.isPaused();
  code_->setText(nurse.code.isEmpty() ? tr("No participant yet") : harmless(nurse.code));
  mark_->setVisible(nurse.simulated || nurse.setup_unchecked);
  mark_text_->setText(nurse.simulated ? tr("SIMULATED") : tr("SET-UP NOT CHECKED"));
  const QString failure = monitor_.failure();
  const bool calls = nurse.called && !nurse.call_seen;
  call_->setVisible(calls || nurse.device_trouble || nurse.stuck || nurse.discomfort || !failure.isEmpty());
  coming_->setVisible(calls);
  call_text_->setText(calls                  ? tr("The participant calls you. The force is off.")
                      : nurse.stuck          ? tr("The device has waited 20 s for a hand. Show her how to hold it.")
                      : nurse.device_trouble ? tr("The device has stopped. Nothing is lost.")
                      : nurse.discomfort ? tr("Her hand or arm does not feel well today. Ask whether she wants to go "
                                              "on; the questions need no device.")
                                         : tr("Not stored, and tried again every few seconds: %1").arg(failure));
  screen_->setText(paused ? tr("Paused: %1").arg(nurse.screen) : nurse.screen);
  now_->setText(nurse.force_off ? tr("The participant has switched the force off.") : nurse.now);
  now_->setVisible(!now_->text().isEmpty());
  device_->setText(nurse.device);
  const auto minutes = monitor_.minutes();
  reading_->setText(minutes ? tr("%1 · %n minute(s)", nullptr, *minutes).arg(nurse.reading) : nurse.reading);
  const session::Share share = monitor_.share();
  progress_->setVisible(share.wanted > 0);
  share_->setVisible(share.wanted > 0);
  progress_->setRange(0, std::max(1, share.wanted));
  progress_->setValue(share.done);
  share_->setText(tr("%1 of %2").arg(share.done).arg(share.wanted));
  pause_->setText(paused ? tr("&Continue") : tr("&Pause"));
  pause_->setEnabled(paused || monitor_.canPause());
  typeNotes(paused);
}

// The keyboard is the participant's, except in a pause.
void MonitorWindow::typeNotes(bool typing) {
  note_hint_->setVisible(!typing);
  store_note_->setEnabled(typing && !note_->text().trimmed().isEmpty());
  if (note_->isEnabled() == typing) return;
  note_->setEnabled(typing);
  const bool visible = isVisible();
  setWindowFlag(Qt::WindowDoesNotAcceptFocus, !typing);
  setAttribute(Qt::WA_ShowWithoutActivating, !typing);
  if (!visible) return;
  show();  // the flags of a window are those of its last showing
  if (typing) {
    activateWindow();
    note_->setFocus();
  }
}

void MonitorWindow::storeNote() {
  monitor_.note(note_->text());
  note_->clear();
}

void MonitorWindow::followForce() {
  plot_->update();
  const ForceTrace::Point* const now = monitor_.trace().newest();
  const bool cut = monitor_.trace().isCut();
  force_->setText(now == nullptr ? QString()
                  : cut          ? tr("%1 of %2 N: cut by a limit")
                              .arg(QString::number(now->delivered_n, 'f', 2), QString::number(now->commanded_n, 'f', 2))
                        : tr("%1 N").arg(QString::number(now->delivered_n, 'f', 2)));
  setInk(*force_, cut ? theme::warningInk() : theme::ink());
}

void MonitorWindow::addLines() {
  const auto& lines = monitor_.lines();
  for (; shown_lines_ < static_cast<int>(lines.size()); ++shown_lines_) {
    const MonitorLine& line = lines[static_cast<std::size_t>(shown_lines_)];
    auto* item = new QListWidgetItem(marked(line), course_);
    const bool warns = line.kind == MonitorLine::Kind::kUnscored || line.kind == MonitorLine::Kind::kCall;
    item->setForeground(line.kind == MonitorLine::Kind::kStage ? theme::mutedInk()
                        : warns                                ? theme::warningInk()
                                                               : theme::ink());
  }
  course_->scrollToBottom();
}

// The session ends on the participant's screens.
void MonitorWindow::closeEvent(QCloseEvent* event) { event->ignore(); }

}  // namespace tactus::workbench
