// The caption below a picture of a plot and above its table: the model, the subject of the plot, and its setting.
#pragma once

#include <QString>
#include <span>

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class SceneController;

/// A table without columns for a plot of the open model. Its caption has the line `model: what`, a line with the values
/// of all inputs but `axes`, the non-empty `notes`, and a last line if the model says that data are simulated. `suffix`
/// ends the proposed file name: `-curves`.
PlotTable captionedTable(const SceneController& scene, const QString& what, std::span<const std::size_t> axes,
                         const QStringList& notes, const QString& suffix);

/// The same for membership functions, which have no setting. `whose` names the owner of the terms.
PlotTable captionedTerms(const SceneController& scene, const fuzzy::Variable& variable, const QString& whose);
/// The owner of the terms that the scene shows: `shared terms`, `terms of S4`.
QString termsText(const SceneController& scene);

/// `Lubrication 1 · Neck flexion 60 deg`: the values of all inputs but `axes`, without the place under the mouse.
QString settingText(const SceneController& scene, std::span<const std::size_t> axes);

}  // namespace tactus::workbench
