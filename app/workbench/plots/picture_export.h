// Writes a plot as a picture for a paper or a report. Only files of plots/ include this.
#pragma once

#include <QString>

#include "core/base/error.h"

class QCustomPlot;

namespace tactus::workbench {

/// Writes `plot` with `title` and `note` above it and a legend of the visible lines below it to `path`, whole or not at
/// all: 1000 x 600 px, PNG at twice the resolution, SVG or PDF, by the ending of `path`.
base::Result<void> savePicture(QCustomPlot& plot, const QString& path, const QString& title, const QString& note);

}  // namespace tactus::workbench
