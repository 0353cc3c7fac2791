#include "app/workbench/plot/plot_caption.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <numeric>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {
namespace {

struct PlotCaption {
  Q_DECLARE_TR_FUNCTIONS(PlotCaption)
};

}  // namespace

QString settingText(const SceneController& scene, std::span<const std::size_t> axes) {
  const fuzzy::ForceModel& model = scene.model()->model;
  QStringList parts;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (std::find(axes.begin(), axes.end(), i) != axes.end()) continue;
    // In full: a caption has to be enough to compute the plot again.
    parts << labelOf(model.inputs[i]) + QLatin1Char(' ') + exactText(scene.value(i), model.inputs[i].unit);
  }
  return parts.join(QStringLiteral(" · "));
}

PlotTable captionedTable(const SceneController& scene, const QString& what, std::span<const std::size_t> axes,
                         const QStringList& notes, const QString& suffix) {
  const OpenModel& open = *scene.model();
  PlotTable table;
  const QFileInfo file(open.path);
  table.file = file.absolutePath() + QLatin1Char('/') + file.baseName() + suffix;
  table.caption << PlotCaption::tr("%1: %2").arg(text(open.model.name), what);
  table.caption << settingText(scene, axes);
  table.caption << notes;
  if (open.simulated) table.caption << PlotCaption::tr("Contains simulated data");
  table.caption.removeAll(QString());
  return table;
}

PlotTable captionedTerms(const SceneController& scene, const fuzzy::Variable& variable, const QString& whose) {
  std::vector<std::size_t> all(scene.model()->model.inputs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return captionedTable(scene, PlotCaption::tr("membership functions of %1, %2").arg(labelOf(variable), whose), all, {},
                        QLatin1Char('-') + text(variable.id));
}

QString termsText(const SceneController& scene) {
  const auto expert = scene.termsOf();
  return expert ? PlotCaption::tr("terms of %1").arg(labelOf(scene.model()->model.experts[*expert]))
                : PlotCaption::tr("shared terms");
}

}  // namespace tactus::workbench
