// How the file of a study is named.
#pragma once

#include <QString>

namespace tactus::workbench {

/// Whether `path` is named like a study file; a model file ends in `.json`.
inline bool isStudyPath(const QString& path) { return path.endsWith(QLatin1String(".tactus"), Qt::CaseInsensitive); }

}  // namespace tactus::workbench
