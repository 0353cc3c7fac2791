#include "app/workbench/understand/curves/reading_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/quiet_table.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/understand/curves/reading_model.h"

namespace tactus::workbench {

ReadingPanel::ReadingPanel(const SceneController& scene, ReadingModel& readings, QWidget* parent)
    : Card(parent),
      scene_(scene),
      place_(new QLabel(this)),
      table_(makeQuietTable(readings, tr("Forces at the place that is read"), this)),
      hint_(new QLabel(
          tr("Move over the curves to read them. Click to keep the place, Shift+click to measure from it."), this)) {
  place_->setFont(theme::headingFont());
  place_->setTextFormat(Qt::PlainText);
  place_->setWordWrap(true);
  hint_->setWordWrap(true);
  setMuted(*hint_);

  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
  table_->horizontalHeader()->hide();
  // The width fits what is in sight; measuring hundreds of experts after each edit would take longer than a frame.
  table_->horizontalHeader()->setResizeContentsPrecision(0);
  table_->horizontalHeader()->setSectionResizeMode(ReadingModel::kWho, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(ReadingModel::kForce, QHeaderView::ResizeToContents);
  // As high as there is room; the height it would like to have would make the panel scroll.
  table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  table_->setMinimumHeight(2 * table_->verticalHeader()->defaultSectionSize());

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid + 4, theme::kGrid + 4, theme::kGrid + 4);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(place_);
  layout->addWidget(table_, 1);
  layout->addWidget(hint_);

  connect(&scene_, &SceneController::modelChanged, this, &ReadingPanel::showPlace);
  auto* refresh = new Refresh(this, [this, &readings] {
    readings.announceReading();
    showPlace();
  });
  connect(&scene_, &SceneController::readingChanged, refresh, &Refresh::request);
}

void ReadingPanel::showPlace() {
  const fuzzy::Variable& x = scene_.xVariable();
  place_->setText(tr("%1 %2").arg(labelOf(x), placeText(x, scene_.readingX())));
}

}  // namespace tactus::workbench
