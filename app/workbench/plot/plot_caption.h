// What stands below a picture of a plot and above its table: the model, what is shown, and the setting it is shown in.
#pragma once

#include <QString>
#include <span>

#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

class SceneController;

/// A table without columns for a plot of the open model: the caption `model: what`, the values of all inputs but
/// `axes` in a second line, `notes` (empty ones are left out), and a last line where the model says that data are
/// simulated. `suffix` ends the name proposed for a file: `-curves`.
PlotTable captionedTable(const SceneController& scene, const QString& what, std::span<const std::size_t> axes,
                         const QStringList& notes, const QString& suffix);

/// The same for membership functions: no setting has a part in them. `whose` says whose terms they are.
PlotTable captionedTerms(const SceneController& scene, const fuzzy::Variable& variable, const QString& whose);
/// Whose terms the scene shows: `shared terms`, `terms of S4`.
QString termsText(const SceneController& scene);

/// `Lubrication 1 · Neck flexion 60 deg`: the values of all inputs but `axes`, the place under the mouse not counted.
QString settingText(const SceneController& scene, std::span<const std::size_t> axes);

}  // namespace tactus::workbench
