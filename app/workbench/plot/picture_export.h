// Plots as pictures for a paper, a report or the clipboard: the plot, its legend, and a caption with the settings.
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

#include "core/base/error.h"

namespace tactus::workbench {

class PlotSource;

/// Pixels of the picture per pixel of its layout: sharp on paper at 16 cm width, and on any screen.
inline constexpr double kPictureScale = 2;

/// `plot` with its legend and, below it, the lines of `caption`. The first line is the title.
QImage pictureOf(PlotSource& plot, const QStringList& caption);

/// Writes that picture to `path`, completely or not at all, as PNG, SVG or PDF by the extension of `path`. Refused:
/// another extension, a file that cannot be written.
base::Result<void> savePicture(PlotSource& plot, const QStringList& caption, const QString& path);

}  // namespace tactus::workbench
