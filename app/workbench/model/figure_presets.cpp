#include "app/workbench/model/figure_presets.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

namespace tactus::workbench {
namespace {

struct FigurePresets {
  Q_DECLARE_TR_FUNCTIONS(FigurePresets)
};

}  // namespace

std::vector<FigurePreset> figurePresets(const fuzzy::ForceModel& model) {
  for (const char* id : {"lubrication", "neck_flexion", "speed"}) {
    if (std::none_of(model.inputs.begin(), model.inputs.end(), [id](const auto& input) { return input.id == id; })) {
      return {};
    }
  }
  FigurePreset surface{
      FigurePresets::tr("Fig. 9"), FigurePresets::tr("map and surface"), {{"lubrication", 1}, {"neck_flexion", 45}}};
  surface.map_x = "depth";
  surface.map_y = "speed";
  const auto family = [](const QString& figure, const QString& shows, std::vector<FigurePreset::Setting> settings,
                         std::string varied, std::vector<double> values) {
    FigurePreset preset{figure, shows, std::move(settings)};
    preset.varied = std::move(varied);
    preset.values = std::move(values);
    return preset;
  };
  return {surface,
          family(FigurePresets::tr("Fig. 10a"), FigurePresets::tr("lubrication varies"),
                 {{"neck_flexion", 90}, {"speed", 30}}, "lubrication", {0, 0.25, 0.5, 1}),
          family(FigurePresets::tr("Fig. 10b"), FigurePresets::tr("neck flexion varies"),
                 {{"lubrication", 1}, {"speed", 30}}, "neck_flexion", {0, 30, 60, 90}),
          family(FigurePresets::tr("Fig. 10c"), FigurePresets::tr("speed varies"),
                 {{"lubrication", 1}, {"neck_flexion", 90}}, "speed", {30, 80, 110, 200}),
          {FigurePresets::tr("Fig. 11"),
           FigurePresets::tr("experts and mean"),
           {{"lubrication", 1}, {"neck_flexion", 60}, {"speed", 50}}}};
}

}  // namespace tactus::workbench
