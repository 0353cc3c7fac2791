#include <QCoreApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/overview/build_overview.h"

namespace tactus::workbench {
namespace {

class RiverMap;

class OverviewView : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(OverviewView)

 public:
  OverviewView(BuildOverview& overview, OverviewLeads leads);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showState();
  QWidget* makeCard(const BuildPart& part);

  BuildOverview& overview_;
  OverviewLeads leads_;
  QLabel* lead_;
  QScrollArea* scroll_;
  RiverMap* river_;
  QVBoxLayout* cards_;
  QWidget* empty_;
  QLabel* why_;
};

constexpr int kWarnings = 2;  // of a card
constexpr int kNameWidth = 12 * theme::kGrid;

QString nameOf(BuildPart::Kind kind) {
  switch (kind) {
    case BuildPart::Kind::kDepth: return OverviewView::tr("Depth");
    case BuildPart::Kind::kSpeed: return OverviewView::tr("Speed");
    case BuildPart::Kind::kForce: return OverviewView::tr("Force");
    case BuildPart::Kind::kRules: return OverviewView::tr("Rules");
    case BuildPart::Kind::kExperts: return OverviewView::tr("Experts");
  }
  return {};
}

/// What the part is made of, where the river begins.
QString sourceOf(BuildPart::Kind kind) {
  switch (kind) {
    case BuildPart::Kind::kDepth: return OverviewView::tr("Image");
    case BuildPart::Kind::kSpeed: return OverviewView::tr("Strokes");
    case BuildPart::Kind::kForce: return OverviewView::tr("Judgements");
    case BuildPart::Kind::kRules: return OverviewView::tr("Answers");
    case BuildPart::Kind::kExperts: return OverviewView::tr("Weights");
  }
  return {};
}

QString madeOf(BuildPart::Kind kind) {
  switch (kind) {
    case BuildPart::Kind::kDepth: return OverviewView::tr("depth words");
    case BuildPart::Kind::kSpeed: return OverviewView::tr("speed words");
    case BuildPart::Kind::kForce: return OverviewView::tr("force words");
    case BuildPart::Kind::kRules: return OverviewView::tr("rules");
    case BuildPart::Kind::kExperts: return OverviewView::tr("mean of the experts");
  }
  return {};
}

/// The way from the data to the force, drawn as one river: each arm is as wide as the newtons that hang on it. A click
/// on an arm opens its lab.
class RiverMap : public QWidget {
 public:
  RiverMap(std::function<void(BuildPart::Kind)> open, QWidget* parent) : QWidget(parent), open_(std::move(open)) {
    setMouseTracking(true);
    setCursor(Qt::PointingHandCursor);
  }

  void show(std::vector<BuildPart> parts) {
    std::sort(parts.begin(), parts.end(), [](const auto& one, const auto& other) { return one.kind < other.kind; });
    parts_ = std::move(parts);
    QStringList said;
    for (const BuildPart& part : parts_)
      said << OverviewView::tr("%1 become %2: %3").arg(sourceOf(part.kind), madeOf(part.kind), newtonsOf(part));
    setAccessibleName(OverviewView::tr("From the data to the force"));
    setAccessibleDescription(said.join(QStringLiteral("; ")));
    setFixedHeight(static_cast<int>(parts_.size()) * rowHeight() + 2 * kMargin);
    updateGeometry();
    update();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    if (parts_.empty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    double largest_n = 0;
    for (const BuildPart& part : parts_) largest_n = std::max(largest_n, part.stake_n.value_or(0));
    const QFontMetrics metrics(theme::smallFont());
    int source_width = 0;
    for (const BuildPart& part : parts_)
      source_width = std::max(source_width, metrics.horizontalAdvance(sourceOf(part.kind)));
    const QString mouth = OverviewView::tr("Force");
    const double left = kMargin + source_width + theme::kGrid;
    const double right = width() - kMargin - QFontMetrics(theme::headingFont()).horizontalAdvance(mouth) - theme::kGrid;
    double all = 0;
    for (const BuildPart& part : parts_) all += widthOf(part, largest_n);
    double at = height() / 2.0 - all / 2;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const double arm = widthOf(parts_[i], largest_n);
      paintArm(painter, i, {left, rowMiddle(i)}, {right, at + arm / 2}, arm);
      at += arm;
      painter.setFont(theme::smallFont());
      painter.setPen(theme::mutedInk());
      painter.drawText(QRectF(kMargin, rowMiddle(i) - rowHeight() / 2.0, source_width, rowHeight()),
                       Qt::AlignRight | Qt::AlignVCenter, sourceOf(parts_[i].kind));
    }
    painter.setFont(theme::headingFont());
    painter.setPen(theme::ink());
    painter.drawText(QRectF(right + theme::kGrid, 0, width() - right, height()), Qt::AlignLeft | Qt::AlignVCenter,
                     mouth);
  }

  void mouseMoveEvent(QMouseEvent* event) override {
    const auto row = rowAt(event->position().y());
    setToolTip(row ? harmless(parts_[*row].effect) : QString());
  }
  void mouseReleaseEvent(QMouseEvent* event) override {
    if (const auto row = rowAt(event->position().y()); row && event->button() == Qt::LeftButton)
      open_(parts_[*row].kind);
  }

 private:
  static constexpr int kMargin = theme::kGrid;
  static constexpr double kWidest = 22;   // px, of the arm with the most newtons
  static constexpr double kThinnest = 2;  // px, of one without any

  static int rowHeight() { return QFontMetrics(theme::smallFont()).height() + theme::kGrid + 2; }
  static QString newtonsOf(const BuildPart& part) {
    return part.stake_n ? quantityText(*part.stake_n, "N", 3) : OverviewView::tr("no newtons");
  }
  static double widthOf(const BuildPart& part, double largest_n) {
    return std::max(kThinnest, largest_n > 0 ? kWidest * part.stake_n.value_or(0) / largest_n : 0);
  }
  double rowMiddle(std::size_t row) const { return kMargin + (static_cast<double>(row) + 0.5) * rowHeight(); }
  std::optional<std::size_t> rowAt(double y) const {
    const double row = (y - kMargin) / rowHeight();
    if (row < 0 || row >= static_cast<double>(parts_.size())) return std::nullopt;
    return static_cast<std::size_t>(row);
  }

  void paintArm(QPainter& painter, std::size_t row, const QPointF& from, const QPointF& to, double arm) const {
    const double bend = from.x() + 0.62 * (to.x() - from.x());
    QPainterPath path(from);
    path.lineTo(bend, from.y());
    const double middle = (bend + to.x()) / 2;
    path.cubicTo(middle, from.y(), middle, to.y(), to.x(), to.y());
    QColor color = theme::accent();
    color.setAlphaF(row % 2 == 0 ? 0.75F : 0.55F);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::onCard(color), arm, Qt::SolidLine, Qt::FlatCap));
    painter.drawPath(path);
    // The words that it becomes, on the water.
    painter.setFont(theme::smallFont());
    const QFontMetrics metrics(theme::smallFont());
    const QString words = madeOf(parts_[row].kind) + QStringLiteral(" · ") + newtonsOf(parts_[row]);
    const double width = metrics.horizontalAdvance(words) + 2 * theme::kGrid;
    const QRectF pill(from.x() + 0.2 * (to.x() - from.x()), from.y() - metrics.height() / 2.0 - 1, width,
                      metrics.height() + 2);
    painter.setPen(QPen(theme::border(), 1));
    painter.setBrush(theme::card());
    painter.drawRoundedRect(pill, pill.height() / 2, pill.height() / 2);
    painter.setPen(theme::ink());
    painter.drawText(pill, Qt::AlignCenter, words);
  }

  std::function<void(BuildPart::Kind)> open_;
  std::vector<BuildPart> parts_;
};

OverviewView::OverviewView(BuildOverview& overview, OverviewLeads leads)
    : overview_(overview),
      leads_(std::move(leads)),
      lead_(new QLabel(this)),
      scroll_(new QScrollArea(this)),
      river_(nullptr),
      cards_(nullptr),
      empty_(new Card(this)),
      why_(new QLabel(empty_)) {
  setObjectName(QStringLiteral("overview"));
  lead_->setFont(theme::titleFont());
  lead_->setWordWrap(true);
  auto* page = new QWidget(this);
  auto* water = new Card(page);
  river_ = new RiverMap([this](BuildPart::Kind kind) { leads_.lab(kind); }, water);
  makeColumn(water, {river_}, 0, inset(theme::kGrid));
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(theme::kGrid);
  column->addWidget(water);
  cards_ = new QVBoxLayout;
  cards_->setSpacing(theme::kGrid);
  column->addLayout(cards_, 1);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidget(page);
  scroll_->viewport()->setAutoFillBackground(false);
  page->setAutoFillBackground(false);

  auto* title = new QLabel(tr("No answers yet"), empty_);
  title->setFont(theme::titleFont());
  title->setAlignment(Qt::AlignHCenter);
  why_->setWordWrap(true);
  why_->setAlignment(Qt::AlignHCenter);
  setMuted(*why_);
  auto* session = new QPushButton(tr("Start with the participants"), empty_);
  auto* tables = new QPushButton(tr("Import tables…"), empty_);
  auto* fill = new QPushButton(tr("Fill with simulated nurses…"), empty_);
  connect(session, &QPushButton::clicked, this, leads_.sessions);
  connect(tables, &QPushButton::clicked, this, leads_.tables);
  connect(fill, &QPushButton::clicked, this, leads_.fill);
  for (QPushButton* button : {session, tables, fill}) button->setMinimumHeight(5 * theme::kGrid);
  makeColumn(empty_, {spring(1), title, why_, makeRow({spring(1), session, tables, fill, spring(1)}), spring(1)},
             2 * theme::kGrid, inset(3 * theme::kGrid));
  makeColumn(this, {lead_, {scroll_, 1}, {empty_, 1}}, theme::kGrid, inset(theme::kGrid));
  connect(&overview_, &BuildOverview::changed, this, &OverviewView::showState);
  connect(&overview_.work(), &Computation::changed, this, &OverviewView::showState);
  showState();
}

void OverviewView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  overview_.setSeen(true);
}

void OverviewView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  overview_.setSeen(false);
}

QWidget* OverviewView::makeCard(const BuildPart& part) {
  auto* card = new Card(this);
  auto* name = new QLabel(nameOf(part.kind), card);
  name->setFont(theme::headingFont());
  name->setFixedWidth(appearance::scaled(kNameWidth));
  auto* sentence = new QLabel(harmless(part.sentence), card);
  auto* effect = new QLabel(card);
  effect->setText(part.stake_n ? tr("At most %1: %2.").arg(quantityText(*part.stake_n, "N", 3), harmless(part.effect))
                               : part.effect);
  effect->setFont(part.stake_n ? theme::headingFont() : theme::smallFont());
  QStringList shown;
  for (const QString& warning : part.warnings.mid(0, kWarnings)) shown << harmless(warning);
  if (const auto more = static_cast<int>(part.warnings.size()) - kWarnings; more > 0)
    shown << tr("and %n more, in its lab", nullptr, more);
  auto* warnings = new QLabel(shown.join(QLatin1Char('\n')), card);
  setInk(*warnings, theme::warningInk());
  warnings->setVisible(!part.warnings.isEmpty());
  for (QLabel* label : {sentence, effect, warnings}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
  }
  auto* open = new QPushButton(tr("Open"), card);
  open->setAccessibleName(tr("Open %1").arg(nameOf(part.kind)));
  open->setMinimumHeight(4 * theme::kGrid);
  open->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(open, &QPushButton::clicked, this, [this, kind = part.kind] { leads_.lab(kind); });
  makeRow(card,
          {{name, 0, Qt::AlignTop},
           makeColumn({effect, sentence, warnings}, theme::kGrid / 2),
           {open, 0, Qt::AlignVCenter}},
          2 * theme::kGrid, inset(theme::kGrid, theme::kGrid));
  return card;
}

void OverviewView::showState() {
  while (QLayoutItem* const item = cards_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  const std::vector<BuildPart> parts = overview_.parts();
  for (const BuildPart& part : parts) cards_->addWidget(makeCard(part));
  cards_->addStretch(1);
  river_->parentWidget()->setVisible(!parts.empty());
  if (!parts.empty()) river_->show(parts);
  const bool missing = parts.empty() && !overview_.failure().isEmpty();
  empty_->setVisible(missing);
  why_->setText(
      tr("A model is made of answers to the questions, of strokes and of judged forces. They come from sessions "
         "with nurses, from tables, or, for a try, from simulated nurses."));
  lead_->setVisible(!missing);
  scroll_->setVisible(!missing);
  lead_->setText(parts.empty() ? tr("The model is being built…")
                               : tr("What the model is made of, and how many newtons hang on each part"));
}

}  // namespace

QWidget* makeOverview(BuildOverview& overview, OverviewLeads leads) {
  return new OverviewView(overview, std::move(leads));
}

}  // namespace tactus::workbench
