// Every screen of the nurse in each of its states, with its longest values: for pictures and for the test of the texts.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

struct SampleScreen {
  QString name;  ///< `question_neck`
  std::function<std::unique_ptr<QWidget>(const Look&)> make;
};

/// Of the procedure and the form of `look`, which outlives them.
std::vector<SampleScreen> sampleScreens(const Look& look);
/// Whether a device is armed on the screens of this name, so that the red button stands in their corner.
bool isWithDevice(const QString& name);

}  // namespace tactus::workbench::nurse
