#include "app/workbench/labs/force/force_tables.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/force/delivered_plot.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/force/vote_words.h"
#include "app/workbench/labs/frame/lab_caption.h"
#include "app/workbench/plot/term_outline.h"

namespace tactus::workbench {
namespace {

struct ForceTables {
  Q_DECLARE_TR_FUNCTIONS(ForceTables)
};

PlotTable::Cell cellOf(const std::optional<double>& value) {
  return value ? PlotTable::Cell(*value) : PlotTable::Cell();
}

}  // namespace

PlotTable forceTermsTable(const ForceLab& lab, elicitation::ForceTermsFrom from) {
  PlotTable table = labTable(lab.data(), ForceTables::tr("words of the force, %1").arg(methodName(from)),
                             QStringLiteral("-force-words"), {methodRule(from)});
  for (const ForceMethod& method : lab.votes().methods) {
    if (method.from == from && method.terms) fillTable(table, method.terms->output, method.terms->output.terms);
  }
  return table;
}

PlotTable deliveredTable(const ForceLab& lab) {
  PlotTable table =
      labTable(lab.data(), ForceTables::tr("delivered against commanded force"), QStringLiteral("-delivered-forces"));
  table.columns = {"participant", "commanded_n", "least_n", "felt_n"};
  const DeliveredForces forces = deliveredForces(lab.judgements());
  for (const DeliveredForce& one : forces.forces) {
    table.rows.push_back(
        {forces.participants[one.participant], one.commanded_n, cellOf(one.least_n), cellOf(one.felt_n)});
  }
  return table;
}

}  // namespace tactus::workbench
