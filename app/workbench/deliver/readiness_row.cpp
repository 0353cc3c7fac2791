#include "app/workbench/deliver/readiness_row.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/deliver/readiness_sign.h"
#include "app/workbench/kit/labels.h"

namespace tactus::workbench {
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

  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  words->addWidget(name_);
  words->addWidget(sentence_);
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
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(words, 1);
    layout->addWidget(accept);
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

}  // namespace tactus::workbench
