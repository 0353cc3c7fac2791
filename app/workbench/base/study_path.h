// The file names of studies.
#pragma once

#include <QString>

namespace tactus::workbench {

/// Whether `path` has the extension of a study file. A model file ends in `.json`.
inline bool isStudyPath(const QString& path) { return path.endsWith(QLatin1String(".tactus"), Qt::CaseInsensitive); }

}  // namespace tactus::workbench
