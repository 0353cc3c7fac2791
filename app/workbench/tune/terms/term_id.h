// The id of a new term, from the label that a person typed.
#pragma once

#include <QString>
#include <string>

namespace tactus::workbench {

/// `Upper esophagus` becomes `upper_esophagus`; letters and digits of ASCII stay, at most 48 bytes; `term` if none is
/// left.
std::string termIdFrom(const QString& label);

}  // namespace tactus::workbench
