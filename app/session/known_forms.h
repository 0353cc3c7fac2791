// The forms to which answers and given rules of a study can refer.
#pragma once

#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// The forms with items (Table A1), and the readings of published rule tables as forms without items. A form without
/// items only gives the set of depth terms that its rules use.
std::vector<study::Form> knownForms();

}  // namespace tactus::session
