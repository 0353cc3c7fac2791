// The strip of recorded strokes: small traces with the force before and the present one, the worst first, and one line
// that says how many would feel different.
#include <QComboBox>
#include <QCoreApplication>
#include <QFocusEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/strokes/strokes_controller.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

using State = StrokesController::State;
using Against = StrokesController::Against;

constexpr int kNarrowest = 172;  // px of a trace, at 100 % of text size
constexpr int kCurve = 48;       // px of height
constexpr int kInsideStrip = theme::kGrid / 2;

int traceHeight() { return 2 * QFontMetrics(theme::smallFont()).height() + kCurve + 3 * kInsideStrip; }

/// One trace for each stroke, in rows. A click goes to the place of the largest difference; the arrows choose, Return
/// goes there.
class StrokeTraces : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(StrokeTraces)

 public:
  StrokeTraces(StrokesController& strokes, QWidget* parent);

  /// The place of a trace, px.
  QRect placeOf(std::size_t place) const;
  /// Called where the keyboard chose a trace that may be out of sight.
  std::function<void(const QRect& place)> sought;

  QSize minimumSizeHint() const override;
  int heightForWidth(int width) const override;
  bool hasHeightForWidth() const override { return true; }

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  void adopt();
  std::size_t count() const;
  int columns(int width) const;
  std::optional<std::size_t> placeAt(const QPoint& at) const;
  void paintTrace(QPainter& painter, const QRectF& area, std::size_t place) const;

  StrokesController& strokes_;
  double most_n_ = 0;  ///< the largest force of all traces
};

class StrokesPanel : public Card {
  Q_DECLARE_TR_FUNCTIONS(StrokesPanel)

 public:
  explicit StrokesPanel(StrokesController& strokes);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showState();
  void showChosen();
  void showEmpty();

  StrokesController& strokes_;
  QLabel* headline_;
  QComboBox* against_;
  QLabel* caption_;
  StrokeTraces* traces_;
  QScrollArea* scroll_;
  ElidedLabel* left_out_;
  ElidedLabel* legend_;
  QPushButton* replay_;
  QLabel* empty_;
  QPushButton* way_out_;
  PageStack* body_;
};

StrokeTraces::StrokeTraces(StrokesController& strokes, QWidget* parent) : QWidget(parent), strokes_(strokes) {
  setObjectName(QStringLiteral("stroke_traces"));
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Recorded strokes, the largest difference first"));
  setCursor(Qt::PointingHandCursor);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  connect(&strokes_, &StrokesController::changed, this, &StrokeTraces::adopt);
  connect(&strokes_, &StrokesController::chosenChanged, this, [this] {
    const auto chosen = strokes_.chosen();
    setAccessibleDescription(chosen ? strokes_.numbersOf(*chosen) : QString());
    update();
  });
}

std::size_t StrokeTraces::count() const {
  return strokes_.state() == State::kShown ? strokes_.comparison().strokes.size() : 0;
}

void StrokeTraces::adopt() {
  most_n_ = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    const auto& numbers = strokes_.comparison().strokes[i].numbers;
    if (numbers) most_n_ = std::max({most_n_, numbers->peak_n[0], numbers->peak_n[1]});
  }
  updateGeometry();
  update();
}

int StrokeTraces::columns(int width) const {
  return std::max(1, (width + theme::kGrid) / (appearance::scaled(kNarrowest) + theme::kGrid));
}

QRect StrokeTraces::placeOf(std::size_t place) const {
  const int across = columns(width());
  const int one = (width() - (across - 1) * theme::kGrid) / across;
  const int row = static_cast<int>(place) / across;
  const int column = static_cast<int>(place) % across;
  return {column * (one + theme::kGrid), row * (traceHeight() + theme::kGrid), one, traceHeight()};
}

std::optional<std::size_t> StrokeTraces::placeAt(const QPoint& at) const {
  for (std::size_t i = 0; i < count(); ++i) {
    if (placeOf(i).contains(at)) return i;
  }
  return std::nullopt;
}

QSize StrokeTraces::minimumSizeHint() const { return {appearance::scaled(kNarrowest), traceHeight()}; }

int StrokeTraces::heightForWidth(int width) const {
  const int rows = (static_cast<int>(count()) + columns(width) - 1) / columns(width);
  return std::max(1, rows) * (traceHeight() + theme::kGrid) - theme::kGrid;
}

bool StrokeTraces::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto place = placeAt(help->pos());
    QToolTip::showText(help->globalPos(), place ? strokes_.numbersOf(*place) : QString(), this);
    return true;
  }
  return QWidget::event(event);
}

void StrokeTraces::mouseReleaseEvent(QMouseEvent* event) {
  const auto place = placeAt(event->pos());
  if (event->button() == Qt::LeftButton && place) strokes_.goTo(*place);
}

void StrokeTraces::keyPressEvent(QKeyEvent* event) {
  if (count() == 0) return QWidget::keyPressEvent(event);
  const auto chosen = strokes_.chosen();
  const int at = chosen ? static_cast<int>(*chosen) : -1;
  const int across = columns(width());
  const auto go = [&](int to) {
    const auto place = static_cast<std::size_t>(std::clamp(to, 0, static_cast<int>(count()) - 1));
    strokes_.choose(place);
    sought(placeOf(place));
  };
  switch (event->key()) {
    case Qt::Key_Right: return go(at + 1);
    case Qt::Key_Left: return go(at - 1);
    case Qt::Key_Down: return go(at < 0 ? 0 : at + across);
    case Qt::Key_Up: return go(at - across);
    case Qt::Key_Home: return go(0);
    case Qt::Key_End: return go(static_cast<int>(count()) - 1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (chosen) strokes_.goTo(*chosen);
      return;
    default: QWidget::keyPressEvent(event);
  }
}

// The keyboard is to be seen.
void StrokeTraces::focusInEvent(QFocusEvent* event) {
  const bool by_key = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  if (by_key && count() > 0 && !strokes_.chosen()) strokes_.choose(0);
  QWidget::focusInEvent(event);
}

void StrokeTraces::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  for (std::size_t i = 0; i < count(); ++i) {
    if (placeOf(i).intersects(event->rect())) paintTrace(painter, placeOf(i), i);
  }
}

void StrokeTraces::paintTrace(QPainter& painter, const QRectF& area, std::size_t place) const {
  const replay::ComparedStroke& compared = strokes_.comparison().strokes[place];
  const bool chosen = strokes_.chosen() == place;
  painter.setPen(QPen(chosen ? theme::accent() : theme::border(), chosen ? 2 : 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(area.adjusted(1, 1, -1, -1), 4, 4);
  const QFontMetricsF metrics(theme::smallFont());
  const QRectF inside = area.adjusted(2 * kInsideStrip, kInsideStrip, -2 * kInsideStrip, -kInsideStrip);
  const QRectF first(inside.left(), inside.top(), inside.width(), metrics.height());
  const QRectF second = first.translated(0, metrics.height());
  painter.setPen(theme::mutedInk());
  painter.drawText(first, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(strokes_.nameOf(place), Qt::ElideRight, first.width()));
  const bool felt = !compared.numbers || compared.numbers->noticeable >= 1;
  painter.setPen(felt ? theme::warningInk() : theme::ink());
  painter.drawText(second, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(strokes_.verdictOf(place), Qt::ElideRight, second.width()));
  const QRectF plot(inside.left(), second.bottom() + kInsideStrip, inside.width(), kCurve - kInsideStrip);
  const replay::StrokeRun& run = *strokes_.baseline().runs[compared.stroke];
  const std::size_t size = run.force_n.size();
  const double scale = most_n_ > 0 ? plot.height() / most_n_ : 0;
  const auto pointOf = [&](std::size_t i, double force_n) {
    const double along = static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, size - 1));
    return QPointF(plot.left() + along * plot.width(), plot.bottom() - std::max(0.0, force_n) * scale);
  };
  // One point per px is all that can be seen.
  const std::size_t step = std::max<std::size_t>(1, size / static_cast<std::size_t>(std::max(1.0, plot.width())));
  QPolygonF lines[2];
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::warningFill());
  for (std::size_t i = 0; i < size; i += step) {
    const QPointF before = pointOf(i, run.force_n[i]);
    const double difference_n = std::abs(compared.after_n[i] - run.force_n[i]);
    if (compared.numbers && difference_n > elicitation::justNoticeableDifference(std::abs(run.force_n[i]))) {
      const double next =
          std::min(plot.right(), before.x() + plot.width() * static_cast<double>(step) / static_cast<double>(size));
      painter.drawRect(QRectF(QPointF(before.x(), plot.top()), QPointF(next, plot.bottom())));
    }
    lines[0] << before;
    lines[1] << pointOf(i, compared.after_n[i]);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme::border(), 1));
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  painter.setPen(QPen(theme::mutedInk(), 1, Qt::DashLine));
  painter.drawPolyline(lines[0]);
  if (compared.hole_mm[1]) return;  // the last force would only be held
  painter.setPen(QPen(theme::mean(), 1.5));
  painter.drawPolyline(lines[1]);
}

StrokesPanel::StrokesPanel(StrokesController& strokes)
    : strokes_(strokes),
      headline_(new QLabel(this)),
      against_(new QComboBox(this)),
      caption_(new QLabel(this)),
      traces_(new StrokeTraces(strokes, this)),
      scroll_(new QScrollArea(this)),
      left_out_(new ElidedLabel(this)),
      legend_(new ElidedLabel(this)),
      replay_(new QPushButton(tr("Replay the recording"), this)),
      empty_(new QLabel(this)),
      way_out_(new QPushButton(this)),
      body_(new PageStack(this)) {
  headline_->setObjectName(QStringLiteral("strokes_headline"));
  way_out_->setObjectName(QStringLiteral("strokes_way_out"));
  replay_->setObjectName(QStringLiteral("strokes_replay"));
  against_->setAccessibleName(tr("What the strokes are compared with"));
  against_->setToolTip(tr("Choose the model that the strokes are compared with"));
  against_->addItem(tr("before the edit"));
  against_->addItem(tr("last sign-off"));
  for (QLabel* sentence : {headline_, caption_}) {
    sentence->setWordWrap(true);
    sentence->setTextFormat(Qt::PlainText);
  }
  setMuted(*caption_);
  setMuted(*left_out_);
  setMuted(*legend_);
  empty_->setWordWrap(true);
  empty_->setTextFormat(Qt::PlainText);
  empty_->setAlignment(Qt::AlignCenter);
  setMuted(*empty_);
  replay_->setFocusPolicy(Qt::TabFocus);
  replay_->setToolTip(
      tr("Let the recorded hand of the chosen stroke move the tool through the present model, by calculation"));
  legend_->setFullText(tr("dashed: before · line: now · shaded: felt, more than one just-noticeable difference (JND)"),
                       tr("dashed: before · line: now · shaded: felt"));
  scroll_->setWidget(traces_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->viewport()->setAutoFillBackground(false);
  traces_->setAutoFillBackground(false);

  auto* const shown = new QWidget(this);
  makeColumn(shown,
             {makeRow({{headline_, 1}, against_}), caption_, {scroll_, 1}, left_out_, makeRow({{legend_, 1}, replay_})},
             theme::kGrid / 2);
  auto* const other = new QWidget(this);
  makeColumn(other, {spring(1), empty_, makeRow({spring(1), way_out_, spring(1)}), spring(1)});
  body_->addWidget(shown);
  body_->addWidget(other);
  makeColumn(this, {{body_, 1}}, theme::kGrid, inset(theme::kGrid));

  traces_->sought = [this](const QRect& place) {
    scroll_->ensureVisible(place.center().x(), place.center().y(), 0, place.height());
  };
  connect(against_, &QComboBox::activated, this,
          [this](int row) { strokes_.setAgainst(row == 0 ? Against::kGhost : Against::kSignOff); });
  connect(replay_, &QPushButton::clicked, &strokes_, &StrokesController::replayChosen);
  connect(way_out_, &QPushButton::clicked, this,
          [this] { strokes_.state() == State::kGhostOff ? strokes_.showGhost() : emit strokes_.recordRequested(); });
  connect(&strokes_, &StrokesController::changed, this, &StrokesPanel::showState);
  connect(&strokes_, &StrokesController::chosenChanged, this, &StrokesPanel::showChosen);
  showState();
}

void StrokesPanel::showEvent(QShowEvent* event) {
  strokes_.setSeen(true);
  Card::showEvent(event);
}

void StrokesPanel::hideEvent(QHideEvent* event) {
  strokes_.setSeen(false);
  Card::hideEvent(event);
}

void StrokesPanel::showState() {
  const bool shown = strokes_.state() == State::kShown;
  body_->setCurrentIndex(shown ? 0 : 1);
  if (!shown) return showEmpty();
  headline_->setText(strokes_.headline());
  headline_->setEnabled(!strokes_.isOld());
  QStandardItem* const signed_off = qobject_cast<QStandardItemModel*>(against_->model())->item(1);
  signed_off->setEnabled(strokes_.isSignedOff());
  signed_off->setToolTip(strokes_.isSignedOff() ? QString() : tr("Nobody has signed off a version of this model yet."));
  const QSignalBlocker quiet(against_);
  against_->setCurrentIndex(strokes_.against() == Against::kSignOff ? 1 : 0);
  caption_->setText(strokes_.caption());
  const QStringList left_out = strokes_.leftOut();
  left_out_->setVisible(!left_out.isEmpty());
  left_out_->setFullText(left_out.join(QLatin1Char(' ')));
  showChosen();
}

void StrokesPanel::showChosen() { replay_->setEnabled(strokes_.chosenRecording().has_value()); }

void StrokesPanel::showEmpty() {
  QString sentence;
  QString way_out;
  switch (strokes_.state()) {
    case State::kNoModel: sentence = tr("No model is open."); break;
    case State::kNoStudy:
      sentence = tr("No study is open, so there is no recorded stroke to run through the model.");
      way_out = tr("Record a stroke…");
      break;
    case State::kNoStroke:
      sentence = tr("No stroke is recorded yet. Recorded while the model is felt, strokes show after each edit what "
                    "would feel different.") +
                 QLatin1Char('\n') + strokes_.leftOut().join(QLatin1Char(' '));
      way_out = tr("Record a stroke…");
      break;
    case State::kGhostOff:
      sentence = tr("The model before is switched off, so there is nothing to compare with.");
      way_out = tr("Show the model before");
      break;
    case State::kWaiting: sentence = tr("Running the recorded strokes through the model…"); break;
    case State::kUnreadable: sentence = tr("The recorded strokes were not read. %1").arg(strokes_.failure()); break;
    case State::kNothing:
      sentence =
          tr("No recorded stroke can be compared.") + QLatin1Char('\n') + strokes_.leftOut().join(QLatin1Char(' '));
      way_out = tr("Record a stroke…");
      break;
    case State::kShown: break;
  }
  empty_->setText(sentence.trimmed());
  // A study that may not be changed takes no recording.
  if (strokes_.state() != State::kGhostOff && !strokes_.mayRecord()) way_out.clear();
  way_out_->setText(way_out);
  way_out_->setVisible(!way_out.isEmpty());
}

}  // namespace

QWidget* makeStrokesPanel(StrokesController& strokes) { return new StrokesPanel(strokes); }

}  // namespace tactus::workbench
