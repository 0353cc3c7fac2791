#include "app/workbench/understand/curves/reference_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/model/shown_impact.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/understand/curves/curve_looks.h"
#include "app/workbench/understand/curves/reference_controller.h"

namespace tactus::workbench {

ReferenceBar::ReferenceBar(ReferenceController& references, const SceneController& scene, QWidget* parent)
    : QWidget(parent), references_(references), scene_(scene), against_(new QComboBox(this)) {
  against_->setAccessibleName(tr("Which curve the references are compared with"));
  against_->setToolTip(tr("Choose the curve that the references are compared with"));
  against_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(theme::kGrid);
  layout->setVerticalSpacing(2);
  layout->addWidget(against_, 0, 1, Qt::AlignTop);
  layout->setColumnStretch(0, 1);
  connect(against_, &QComboBox::activated, this, [this](int row) {
    references_.setExpert(row == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row) - 1));
  });
  connect(&references_, &ReferenceController::changed, this, &ReferenceBar::build);
  build();
}

void ReferenceBar::build() {
  delete rows_;
  names_.clear();
  texts_.clear();
  rows_ = new QWidget(this);
  static_cast<QGridLayout*>(layout())->addWidget(rows_, 0, 0);
  auto* grid = new QGridLayout(rows_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(0);
  grid->setColumnStretch(1, 1);
  const std::vector<ReferenceCurve> shown = references_.shown();
  for (const ReferenceCurve& reference : shown) {
    const int row = grid->rowCount();
    auto* name = new QLabel(QStringLiteral("● ") + reference.name, rows_);
    name->setTextFormat(Qt::PlainText);
    name->setToolTip(explained(Statistic::kRms));
    names_ << name;
    auto* difference = new ElidedLabel(rows_);
    auto* remove = new QToolButton(rows_);
    remove->setText(QStringLiteral("✕"));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Take %1 away").arg(reference.name));
    remove->setAccessibleName(remove->toolTip());
    for (QWidget* part :
         {static_cast<QWidget*>(name), static_cast<QWidget*>(difference), static_cast<QWidget*>(remove)})
      part->setFont(theme::smallFont());
    grid->addWidget(name, row, 0);
    grid->addWidget(difference, row, 1);
    grid->addWidget(remove, row, 2);
    texts_ << difference;
    // Queued, because taking it away rebuilds the rows and with them the button.
    connect(
        remove, &QToolButton::clicked, this, [this, name = reference.name] { references_.remove(name); },
        Qt::QueuedConnection);
  }
  colorNames();
  listExperts();
  setVisible(!shown.empty());
  showDifferences();
}

void ReferenceBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorNames();
}

void ReferenceBar::colorNames() {
  const std::vector<ReferenceCurve> shown = references_.shown();
  for (std::size_t i = 0; i < shown.size() && i < static_cast<std::size_t>(names_.size()); ++i) {
    QPalette colors;
    colors.setColor(QPalette::WindowText, referencePen(shown[i].color).color());
    names_[static_cast<qsizetype>(i)]->setPalette(colors);
  }
}

void ReferenceBar::listExperts() {
  const QSignalBlocker no_signal(against_);
  against_->clear();
  if (!scene_.model()) return;
  against_->addItem(tr("Mean"));
  for (const fuzzy::Expert& expert : scene_.model()->model.experts) against_->addItem(labelOf(expert));
  against_->setCurrentIndex(references_.expert() ? static_cast<int>(*references_.expert()) + 1 : 0);
}

void ReferenceBar::showDifferences() {
  if (texts_.isEmpty() || !isVisible()) return;
  const auto& differences = references_.differences();
  for (qsizetype i = 0; i < texts_.size(); ++i) {
    texts_[i]->setFullText(references_.differenceText(differences[static_cast<std::size_t>(i)]));
  }
}

}  // namespace tactus::workbench
