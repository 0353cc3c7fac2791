// The initials of a name, for places where the name does not fit.
#pragma once

#include <QString>

namespace tactus::workbench {

/// `VS` for `Very Small`.
QString initialsOf(const QString& words);

}  // namespace tactus::workbench
