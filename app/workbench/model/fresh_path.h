// Names for model files that do not exist yet.
#pragma once

#include <QString>

namespace tactus::workbench {

/// `pump.tactus.json` for the stem `pump`; `pump-2.tactus.json` where that exists, and so on.
QString freshModelPath(const QString& stem);

}  // namespace tactus::workbench
