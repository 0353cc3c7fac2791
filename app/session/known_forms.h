// The forms that answers and given rules of a study can refer to.
#pragma once

#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// The forms with items (Table A1), and the readings of published rule tables as forms without items, which say only
/// which set of depth terms their rules use.
std::vector<study::Form> knownForms();

}  // namespace tactus::session
