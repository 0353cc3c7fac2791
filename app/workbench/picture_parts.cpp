#include "app/workbench/picture_parts.h"

#include <QAction>

#include "app/workbench/model/model_controller.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/shell/main_window.h"

namespace tactus::workbench {

PictureParts::PictureParts(MainWindow& window, const ModelController& models) {
  QAction* const copy = window.menus().addAction(MenuSlot::kFilePictures, tr("&Copy picture of the plot"),
                                                 Qt::CTRL | Qt::SHIFT | Qt::Key_C);
  copy->setToolTip(tr("Copy the plot with the keyboard or under the mouse"));
  copy->setEnabled(false);
  QObject::connect(copy, &QAction::triggered, &window, [&window] {
    if (PlotMenu* plot = currentPlot(window)) plot->copyPicture();
  });
  QObject::connect(&models, &ModelController::opened, copy, [copy] { copy->setEnabled(true); });
}

}  // namespace tactus::workbench
