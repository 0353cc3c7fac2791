#include "app/workbench/deliver/readiness_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/deliver/readiness.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"

namespace tactus::workbench {
namespace {

constexpr int kSize = 20;  // px; the pictures are drawn on a square of this size

struct SignLook {
  QColor ink;
  QColor fill;
  QPainterPath lines;
};

QPainterPath polyline(std::initializer_list<QPointF> points) {
  QPainterPath path(*points.begin());
  for (const QPointF& point : points) path.lineTo(point);
  return path;
}

SignLook lookOf(Readiness state) {
  switch (state) {
    case Readiness::kReady: return {theme::accent(), theme::window(), polyline({{6, 10.5}, {9, 13.5}, {14, 7}})};
    case Readiness::kLook: {
      QPainterPath mark = polyline({{10, 5.5}, {10, 11}});
      mark.addPath(polyline({{10, 14}, {10, 14.2}}));
      return {theme::warningInk(), theme::warningFill(), mark};
    }
    case Readiness::kBlocks: {
      QPainterPath cross = polyline({{6.8, 6.8}, {13.2, 13.2}});
      cross.addPath(polyline({{13.2, 6.8}, {6.8, 13.2}}));
      return {theme::errorInk(), theme::errorFill(), cross};
    }
    case Readiness::kUnknown: break;
  }
  QPainterPath dots;
  for (const double x : {6.5, 10.0, 13.5}) dots.addPath(polyline({{x, 10}, {x, 10.1}}));
  return {theme::mutedInk(), theme::window(), dots};
}

}  // namespace

ReadinessSign::ReadinessSign(QWidget* parent) : QWidget(parent) {
  setFixedSize(kSize, kSize);
  setState(Readiness::kUnknown);
}

void ReadinessSign::setState(Readiness state) {
  state_ = state;
  setToolTip(readinessName(state));
  setAccessibleName(readinessName(state));
  update();
}

void ReadinessSign::paintEvent(QPaintEvent* /*event*/) {
  const SignLook look = lookOf(state_);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(look.fill);
  painter.drawEllipse(rect());
  painter.setPen(QPen(look.ink, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(look.lines);
}

namespace {

constexpr std::size_t kMostHoles = 12;        // with a button each; more are fixed faster in the findings
constexpr int kActWidth = 17 * theme::kGrid;  // px at 100 %, so that the buttons of all lines end and begin together

QLabel* plainLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  return label;
}

}  // namespace

ReadinessRow::ReadinessRow(QWidget* parent)
    : QFrame(parent),
      sign_(new ReadinessSign(this)),
      name_(plainLabel(this)),
      sentence_(plainLabel(this)),
      act_(new QPushButton(this)),
      holes_(new QWidget(this)),
      hole_lines_(new QVBoxLayout(holes_)) {
  name_->setFont(theme::headingFont());
  keepFitted(*act_, [this] { act_->setFixedWidth(appearance::scaled(kActWidth)); });
  hole_lines_->setContentsMargins(0, theme::kGrid / 2, 0, 0);
  hole_lines_->setSpacing(theme::kGrid / 2);
  holes_->hide();

  auto* words = makeColumn({name_, sentence_}, 2);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, theme::kGrid, 0, theme::kGrid);
  layout->setHorizontalSpacing(theme::kGrid + theme::kGrid / 2);
  layout->setVerticalSpacing(0);
  layout->setColumnStretch(1, 1);
  layout->addWidget(sign_, 0, 0, Qt::AlignTop);
  layout->addLayout(words, 0, 1);
  layout->addWidget(act_, 0, 2, Qt::AlignVCenter);
  layout->addWidget(holes_, 1, 1, 1, 2);
  connect(act_, &QPushButton::clicked, this, &ReadinessRow::acted);
}

void ReadinessRow::setLine(const ReadinessLine& line) {
  sign_->setState(line.state);
  name_->setText(line.name);
  sentence_->setText(line.sentence);
  act_->setText(line.act);
  act_->setAccessibleName(line.name + QStringLiteral(": ") + line.act);
}

void ReadinessRow::showHoles(const std::vector<DeliverFindings::Hole>& holes) {
  if (holes == shown_holes_) return;
  shown_holes_ = holes;
  while (QLayoutItem* item = hole_lines_->takeAt(0)) {
    // A button whose click led here must outlive it.
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t i = 0; i < std::min(holes.size(), kMostHoles); ++i) {
    auto* line = new QWidget(holes_);
    auto* words = new ElidedLabel(line);
    words->setFullText(holes[i].words);
    auto* accept = new QPushButton(tr("Accept"), line);
    keepFitted(*accept, [accept] { accept->setFixedWidth(appearance::scaled(kActWidth)); });
    accept->setAccessibleName(tr("Accept the hole %1").arg(holes[i].words));
    accept->setToolTip(tr("Accept that there is no force here; the model keeps the name of the hole (undo: Ctrl+Z)"));
    connect(accept, &QPushButton::clicked, this, [this, name = holes[i].name] { emit holeAccepted(name); });
    makeRow(line, {{words, 1}, accept}, kStyleGap);
    hole_lines_->addWidget(line);
  }
  if (holes.size() > kMostHoles) {
    auto* more =
        new QLabel(tr("and %n more, in the findings", nullptr, static_cast<int>(holes.size() - kMostHoles)), holes_);
    setMuted(*more);
    hole_lines_->addWidget(more);
  }
  holes_->setVisible(!holes.empty());
}

ReadinessPanel::ReadinessPanel(ReadinessController& readiness, QWidget* parent)
    : Card(parent), readiness_(readiness), summary_(new QLabel(this)) {
  summary_->setFont(theme::titleFont());
  summary_->setTextFormat(Qt::PlainText);
  auto* list = new QWidget;
  auto* lines = makeColumn(list, {}, 0, {0, 0, theme::kGrid, 0});
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = new ReadinessRow(list);
    lines->addWidget(rows_[i]);
    connect(rows_[i], &ReadinessRow::acted, this, [this, i] { emit asked(static_cast<ReadinessTopic>(i)); });
  }
  lines->addStretch(1);
  connect(rows_.front(), &ReadinessRow::holeAccepted, &readiness_, &ReadinessController::acceptHole);
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(list);
  for (QWidget* surface : {scroll->viewport(), list}) surface->setAutoFillBackground(false);
  makeColumn(this, {summary_, {scroll, 1}}, theme::kGrid,
             {2 * theme::kGrid, 2 * theme::kGrid, theme::kGrid, theme::kGrid});

  auto* refresh = new Refresh(this, [this] { showLines(); });
  connect(&readiness_, &ReadinessController::changed, refresh, &Refresh::request);
  refresh->request();
}

void ReadinessPanel::showLines() {
  const auto& lines = readiness_.lines();
  summary_->setText(lines.empty() ? QString() : readinessSummary(lines));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i]->setVisible(i < lines.size());
    if (i < lines.size()) rows_[i]->setLine(lines[i]);
  }
  std::vector<DeliverFindings::Hole> open;
  const DeliverFindings& found = readiness_.findings();
  if (found.current) {
    std::copy_if(found.holes.begin(), found.holes.end(), std::back_inserter(open),
                 [](const DeliverFindings::Hole& hole) { return !hole.accepted; });
  }
  rows_.front()->showHoles(open);
}

}  // namespace tactus::workbench
