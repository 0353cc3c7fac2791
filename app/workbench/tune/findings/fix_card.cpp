#include "app/workbench/tune/findings/fix_card.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/findings/findings_controller.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kMostRules = 6;  // buttons that fit beside the others

// A button may be the one whose click led here.
void clear(QLayout& layout) {
  while (QLayoutItem* const item = layout.takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
}

}  // namespace

FixCard::FixCard(FindingsController& findings, QWidget* parent)
    : QFrame(parent),
      findings_(findings),
      sentence_(new QLabel(this)),
      here_(new QToolButton(this)),
      other_end_(new QToolButton(this)),
      rules_(new QHBoxLayout),
      note_(new QLabel(this)),
      fixes_(new QWidget(this)),
      grid_(new QGridLayout(fixes_)) {
  sentence_->setWordWrap(true);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  here_->setToolTip(tr("Move the operating point to the place of this force"));
  other_end_->setText(tr("Go to start"));
  other_end_->setToolTip(tr("Move the operating point to the start of the change of force"));
  rules_->setSpacing(theme::kGrid / 2);
  note_->setWordWrap(true);
  setMuted(*note_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(theme::kGrid);
  grid_->setVerticalSpacing(theme::kGrid / 2);
  grid_->setColumnStretch(1, 1);

  auto* places = new QHBoxLayout;
  places->setSpacing(theme::kGrid / 2);
  places->addWidget(other_end_);
  places->addWidget(here_);
  places->addLayout(rules_);
  places->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, theme::kGrid / 2, 0, 0);
  layout->setSpacing(theme::kGrid / 2);
  layout->addWidget(sentence_);
  layout->addLayout(places);
  layout->addWidget(note_);
  layout->addWidget(fixes_);

  connect(here_, &QToolButton::clicked, this, [this] { findings_.goTo(false); });
  connect(other_end_, &QToolButton::clicked, this, [this] { findings_.goTo(true); });
  connect(&findings_, &FindingsController::chosenChanged, this, &FixCard::showFinding);
  connect(&findings_, &FindingsController::fixesChanged, this, &FixCard::showFixes);
  showFinding();
}

FixCard::~FixCard() = default;

void FixCard::showFinding() {
  const auto chosen = findings_.chosen();
  setVisible(chosen.has_value());
  if (!chosen) return;
  const ShownFinding& shown = findings_.findings()[*chosen];
  sentence_->setText(shown.who + QStringLiteral(" · ") + shown.sentence);
  here_->setVisible(!shown.at.empty());
  here_->setText(shown.other_end.empty() ? tr("Go there") : tr("Go to end"));
  other_end_->setVisible(!shown.other_end.empty());
  showRules();
  showFixes();
}

void FixCard::showRules() {
  clear(*rules_);
  QList<QWidget*> places{other_end_, here_};
  const auto& named = findings_.findings()[*findings_.chosen()].rules;
  const bool one_expert = std::all_of(named.begin(), named.end(),
                                      [&](const RuleOfExpert& rule) { return rule.expert == named.front().expert; });
  for (std::size_t r = 0; r < std::min(named.size(), kMostRules); ++r) {
    auto* button = new QToolButton(this);
    button->setText(one_expert ? tr("Rule %1").arg(named[r].rule + 1)
                               : tr("Rule %1 of %2").arg(named[r].rule + 1).arg(text(named[r].expert)));
    button->setToolTip(tr("Select this rule in the rule editor"));
    button->setObjectName(QStringLiteral("rule_%1").arg(r));
    rules_->addWidget(button);
    places << button;
    connect(button, &QToolButton::clicked, this, [this, r] { findings_.pointAt(r); });
  }
  places_stop_ = std::make_unique<RowStop>(places, nullptr);
}

void FixCard::showFixes() {
  if (!findings_.chosen()) return;
  clear(*grid_);
  const auto& fixes = findings_.fixes();
  QList<QWidget*> buttons;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    // An ampersand of a label is no shortcut.
    auto* button = new QPushButton(QString(fixes[i].text).replace(QLatin1Char('&'), QLatin1String("&&")), fixes_);
    button->setToolTip(fixes[i].what);
    button->setObjectName(QStringLiteral("fix_%1").arg(i));
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    keepFitted(*button, [button] {
      button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) + 3 * theme::kGrid);
    });
    auto* effect = new ElidedLabel(fixes_);
    effect->setFullText(fixes[i].effect);
    setMuted(*effect);
    effect->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid_->addWidget(button, static_cast<int>(i), 0);
    grid_->addWidget(effect, static_cast<int>(i), 1);
    connect(button, &QPushButton::clicked, this, [this, i] { findings_.apply(i); });
    buttons << button;
  }
  fixes_stop_ = std::make_unique<RowStop>(buttons, nullptr, Qt::Vertical);
  fixes_->setVisible(!fixes.empty());
  note_->setVisible(fixes.empty());
  if (!findings_.isCurrent()) {
    note_->setText(tr("The model changed: looking again…"));
  } else if (findings_.isLookingForFixes()) {
    note_->setText(tr("Looking for what would settle it…"));
  } else {
    note_->setText(tr("No edit settles this by itself: look at the rules together with the expert."));
  }
}

}  // namespace tactus::workbench
