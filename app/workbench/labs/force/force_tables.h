// The numbers of the plots of the force lab.
#pragma once

#include "app/workbench/base/plot_table.h"
#include "elicitation/force/force_terms.h"

namespace tactus::workbench {

class ForceLab;

/// The words by one method; empty if it gives none.
PlotTable forceTermsTable(const ForceLab& lab, elicitation::ForceTermsFrom from);
PlotTable deliveredTable(const ForceLab& lab);

}  // namespace tactus::workbench
