// Every screen of the nurse in each of its states, with its longest values: for the test of the texts and for looking.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::tests {

struct SampleScreen {
  QString name;  ///< `question_neck`
  std::function<std::unique_ptr<QWidget>(const nurse::Look&)> make;
};

std::vector<SampleScreen> sampleScreens();

}  // namespace tactus::workbench::tests
