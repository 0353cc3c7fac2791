#include "app/workbench/views/explore_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/models/reading_model.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/curves_panel.h"
#include "app/workbench/views/model_header.h"
#include "app/workbench/views/reading_panel.h"
#include "app/workbench/views/variable_row.h"

namespace tactus::workbench {
namespace {

constexpr int kReadingWidth = 264;  // px

}  // namespace

ExploreView::ExploreView(SceneController& scene, QWidget* parent) : QWidget(parent) {
  auto* readings = new ReadingModel(scene, this);
  auto* header = new ModelHeader(scene, this);
  auto* variables = new VariableRow(scene, this);
  curves_ = new CurvesPanel(scene, *readings, this);
  auto* reading = new ReadingPanel(scene, *readings, this);
  reading->setFixedWidth(kReadingWidth);

  auto* lower = new QHBoxLayout;
  lower->setSpacing(theme::kGrid);
  lower->addWidget(curves_, 1);
  lower->addWidget(reading);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(header);
  layout->addWidget(variables, 2);
  layout->addLayout(lower, 5);

  connect(curves_, &CurvesPanel::savePictureRequested, this, &ExploreView::savePictureRequested);
}

base::Result<void> ExploreView::savePicture(const QString& path) { return curves_->savePicture(path); }

}  // namespace tactus::workbench
