// Every screen of the nurse in each of its states, with its longest values: for pictures and for the test of the texts.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench::nurse {

struct SampleScreen {
  QString name;                             ///< `question_neck`
  std::optional<ParticipantScreen> screen;  ///< nothing: a panel over another screen
  bool armed = false;                       ///< a device is, so that the red button stands in the corner
  std::function<std::unique_ptr<QWidget>(const Look&)> make;
};

/// Of the procedure and the form of `look`, which outlives them.
std::vector<SampleScreen> sampleScreens(const Look& look);

}  // namespace tactus::workbench::nurse
