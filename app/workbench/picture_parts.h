// Adds to the window the copy of a picture of the plot in use, whichever panel it belongs to.
#pragma once

#include <QCoreApplication>

namespace tactus::workbench {

class MainWindow;
class ModelController;

class PictureParts {
  Q_DECLARE_TR_FUNCTIONS(PictureParts)

 public:
  PictureParts(MainWindow& window, const ModelController& models);
};

}  // namespace tactus::workbench
