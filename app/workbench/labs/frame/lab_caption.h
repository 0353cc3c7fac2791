// The caption of a picture or table of a lab: the study, what is shown, and whose data are simulated.
#pragma once

#include <QString>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/labs/data/lab_data.h"

namespace tactus::workbench {

/// A table without columns for a plot of the open study. `suffix` ends the proposed file name: `-pulls`. `notes`:
/// further lines of the caption.
PlotTable labTable(const LabData& data, const QString& what, const QString& suffix, const QStringList& notes = {});

}  // namespace tactus::workbench
