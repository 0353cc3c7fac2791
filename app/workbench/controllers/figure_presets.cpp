#include "app/workbench/controllers/figure_presets.h"

#include <QCoreApplication>
#include <algorithm>

namespace tactus::workbench {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("FigurePresets", text); }

}  // namespace

std::vector<FigurePreset> figurePresets(const fuzzy::ForceModel& model) {
  for (const char* id : {"lubrication", "neck_flexion", "speed"}) {
    if (std::none_of(model.inputs.begin(), model.inputs.end(), [id](const auto& input) { return input.id == id; })) {
      return {};
    }
  }
  return {
      {tr("Fig. 9"), tr("depth and speed"), {{"lubrication", 1}, {"neck_flexion", 45}}},
      {tr("Fig. 10a"), tr("lubrication varies"), {{"neck_flexion", 90}, {"speed", 30}}},
      {tr("Fig. 10b"), tr("neck flexion varies"), {{"lubrication", 1}, {"speed", 30}}},
      {tr("Fig. 10c"), tr("speed varies"), {{"lubrication", 1}, {"neck_flexion", 90}}},
      {tr("Fig. 11"), tr("experts and mean"), {{"lubrication", 1}, {"neck_flexion", 60}, {"speed", 50}}},
  };
}

}  // namespace tactus::workbench
