// What a record moves, in a sentence or for a table.
#pragma once

#include <QString>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/model/record_influence.h"

namespace tactus::workbench {

/// `S1 at 0.4 N: without it the averaged force moves by at most 0.025 N (0.3 just-noticeable differences), at
/// lubrication 0.5, depth 120 mm; 0.004 N rms.` `which`: the record. `model`: whose inputs have the place.
QString influenceText(const QString& which, const base::Result<elicitation::RecordInfluence>& moved,
                      const fuzzy::ForceModel& model);

/// The same for a cell of a table: `0.025 N (0.3 JND)`; what is more than nothing never reads `0`.
QString movedText(const elicitation::RecordInfluence& moved);

}  // namespace tactus::workbench
