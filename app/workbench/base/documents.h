// Where files of the user belong without a better place.
#pragma once

#include <QString>

namespace tactus::workbench {

/// The user's documents; the home folder where there are none.
QString documentsFolder();

}  // namespace tactus::workbench
