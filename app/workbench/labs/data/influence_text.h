// What a record moves, in a sentence.
#pragma once

#include <QString>

#include "core/base/error.h"
#include "elicitation/model/record_influence.h"

namespace tactus::workbench {

/// `S1 at 0.4 N: without it the averaged force moves by at most 0.025 N (0.3 just-noticeable differences).` `which`:
/// the record.
QString influenceText(const QString& which, const base::Result<elicitation::RecordInfluence>& moved);

}  // namespace tactus::workbench
