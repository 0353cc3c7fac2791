#include "app/workbench/labs/method/method_curves_table.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/frame/lab_caption.h"
#include "app/workbench/labs/method/method_lab.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {
namespace {

struct MethodCurvesTable {
  Q_DECLARE_TR_FUNCTIONS(MethodCurvesTable)
};

}  // namespace

PlotTable methodCurvesTable(const MethodLab& lab) {
  PlotTable table = labTable(lab.data(), MethodCurvesTable::tr("the averaged force with another choice of the method"),
                             QStringLiteral("-method"));
  const MethodCurves* const curves = lab.curves();
  if (curves == nullptr) return table;
  const auto& variant = lab.found()->variants[curves->variant];
  table.caption << QStringLiteral("%1: %2").arg(text(elicitation::factorTitle(variant.factor)), text(variant.value));
  table.caption << placeOfCurves(lab.model(), *curves);
  const auto& depth = lab.model().inputs[curves->x_input];
  table.columns = {"curve", columnName(depth), columnName(lab.model().output)};
  const auto add = [&](const std::string& name, const figures::ForceCurves& one) {
    for (std::size_t i = 0; i < one.x.size(); ++i) table.rows.push_back({name, one.x[i], forceCell(one.mean[i])});
  };
  add("as_it_is", curves->now);
  add(variant.factor + " " + variant.value, curves->other);
  return table;
}

}  // namespace tactus::workbench
