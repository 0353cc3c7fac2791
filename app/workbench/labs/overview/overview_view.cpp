#include <QCoreApplication>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
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

class OverviewView : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(OverviewView)

 public:
  OverviewView(BuildOverview& overview, OverviewLeads leads);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showState();
  QWidget* makeCard(const BuildPart& part, double largest_n);

  BuildOverview& overview_;
  OverviewLeads leads_;
  QLabel* lead_;
  QScrollArea* scroll_;
  QVBoxLayout* cards_;
  QWidget* empty_;
  QLabel* why_;
};

constexpr int kRiver = 14;    // px, of the widest part
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

/// The part's arm of the river: as wide as its newtons.
class River : public QWidget {
 public:
  River(double share, QWidget* parent) : QWidget(parent), share_(share) { setFixedWidth(4 * theme::kGrid); }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::accent());
    const double width = std::max(1.5, share_ * kRiver);
    painter.drawRoundedRect(QRectF((this->width() - width) / 2, 0, width, height()), width / 2, width / 2);
  }

 private:
  double share_;
};

OverviewView::OverviewView(BuildOverview& overview, OverviewLeads leads)
    : overview_(overview),
      leads_(std::move(leads)),
      lead_(new QLabel(this)),
      scroll_(new QScrollArea(this)),
      cards_(nullptr),
      empty_(new Card(this)),
      why_(new QLabel(empty_)) {
  setObjectName(QStringLiteral("overview"));
  lead_->setFont(theme::titleFont());
  lead_->setWordWrap(true);
  auto* page = new QWidget(this);
  cards_ = new QVBoxLayout(page);
  cards_->setContentsMargins(0, 0, 0, 0);
  cards_->setSpacing(theme::kGrid);
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

QWidget* OverviewView::makeCard(const BuildPart& part, double largest_n) {
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
  const double share = largest_n > 0 ? part.stake_n.value_or(0) / largest_n : 0;
  makeRow(card,
          {new River(share, card),
           {name, 0, Qt::AlignTop},
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
  double largest_n = 0;
  for (const BuildPart& part : parts) largest_n = std::max(largest_n, part.stake_n.value_or(0));
  for (const BuildPart& part : parts) cards_->addWidget(makeCard(part, largest_n));
  cards_->addStretch(1);
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
