#include "app/workbench/labs/speed/speed_lab_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/speed/cluster_page.h"
#include "app/workbench/labs/speed/number_page.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/labs/speed/speed_settings.h"
#include "app/workbench/labs/speed/stroke_page.h"

namespace tactus::workbench {
namespace {

constexpr int kSettingsWidth = 29 * theme::kGrid;  // px at 100 %

}  // namespace

SpeedLabView::SpeedLabView(SpeedLab& lab, LabModel& model, Corrections& corrections, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      terms_(nullptr),
      strokes_(new StrokePage(lab, model, corrections, this)),
      pages_(new QTabWidget(this)),
      back_(new QToolButton(this)),
      on_(new QToolButton(this)),
      place_(new QLabel(this)),
      nothing_(new QLabel(this)) {
  setObjectName(QStringLiteral("speed"));
  setWindowTitle(tr("Speed"));
  auto* settings = new SpeedSettingsPanel(lab, this);
  keepFitted(*settings, [settings] { settings->setFixedWidth(appearance::scaled(kSettingsWidth)); });
  new TabLook(*pages_->tabBar());
  pages_->setDocumentMode(true);
  auto* const numbers = new NumberPage(lab, this);
  strokes_->setObjectName(QStringLiteral("strokes"));
  numbers->setObjectName(QStringLiteral("table"));
  auto* const clusters = new ClusterPage(lab, this);
  terms_ = &clusters->terms();
  pages_->addTab(clusters, tr("Clusters and terms"));
  pages_->addTab(strokes_, tr("Strokes"));
  pages_->addTab(numbers, tr("Table 1 and warnings"));
  pages_->setCornerWidget(makePager(), Qt::TopRightCorner);
  setMuted(*nothing_);
  nothing_->setAlignment(Qt::AlignCenter);
  nothing_->setWordWrap(true);
  nothing_->hide();
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(settings);
  layout->addWidget(pages_, 1);
  layout->addWidget(nothing_, 1);
  connect(&lab_, &SpeedLab::resultChanged, this, &SpeedLabView::follow);
  connect(&lab_, &SpeedLab::pageChanged, this, &SpeedLabView::follow);
  follow();
}

QWidget* SpeedLabView::makePager() {
  auto* pager = new QWidget(this);
  back_->setArrowType(Qt::LeftArrow);
  back_->setAccessibleName(tr("Earlier participants"));
  on_->setArrowType(Qt::RightArrow);
  on_->setAccessibleName(tr("Further participants"));
  setMuted(*place_);
  auto* row = new QHBoxLayout(pager);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(theme::kGrid / 2);
  row->addWidget(back_);
  row->addWidget(place_);
  row->addWidget(on_);
  connect(back_, &QToolButton::clicked, this, [this] { lab_.setPage(lab_.page() - 1); });
  connect(on_, &QToolButton::clicked, this, [this] { lab_.setPage(lab_.page() + 1); });
  return pager;
}

void SpeedLabView::showStroke(const elicitation::StrokeKey& stroke) {
  pages_->setCurrentWidget(strokes_);
  strokes_->showStroke(stroke);
}

void SpeedLabView::follow() {
  const auto& result = lab_.result();
  const bool empty = result && result->subjects.empty();
  nothing_->setText(
      tr("There are no accepted strokes in this study. The speed has its default terms; the speed "
         "experiment begins in Collect."));
  nothing_->setVisible(empty);
  pages_->setVisible(!empty);
  const auto [first, last] = lab_.shown();
  for (QWidget* part : {static_cast<QWidget*>(back_), static_cast<QWidget*>(on_), static_cast<QWidget*>(place_)}) {
    part->setVisible(lab_.pages() > 1);
  }
  place_->setText(tr("%1 to %2 of %3").arg(first + 1).arg(last).arg(result ? result->subjects.size() : 0));
  back_->setEnabled(lab_.page() > 0);
  on_->setEnabled(lab_.page() + 1 < lab_.pages());
}

void SpeedLabView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  lab_.setSeen(true);
}

void SpeedLabView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  lab_.setSeen(false);
}

}  // namespace tactus::workbench
