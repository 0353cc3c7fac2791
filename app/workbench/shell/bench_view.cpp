#include "app/workbench/shell/bench_view.h"

#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/panel_area.h"

namespace tactus::workbench {

BenchView::BenchView(SceneController& scene, QSettings& settings, QWidget* parent)
    : QWidget(parent), header_(new ModelHeader(scene, this)), panels_(new PanelArea(settings, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(header_);
  layout->addWidget(panels_, 1);
}

}  // namespace tactus::workbench
