// Where files of the user belong without a better place.
#pragma once

#include <QString>

namespace tactus::workbench {

// The file names of studies.

/// Whether `path` has the extension of a study file. A model file ends in `.json`.
inline bool isStudyPath(const QString& path) { return path.endsWith(QLatin1String(".tactus"), Qt::CaseInsensitive); }

/// The user's documents; the home folder where there are none.
QString documentsFolder();

}  // namespace tactus::workbench
