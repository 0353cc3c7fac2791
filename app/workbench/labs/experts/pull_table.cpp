#include "app/workbench/labs/experts/pull_table.h"

#include <QCoreApplication>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/frame/lab_caption.h"

namespace tactus::workbench {
namespace {

struct PullTable {
  Q_DECLARE_TR_FUNCTIONS(PullTable)
};

// Enough to compute the plot again.
QString settingOf(const ExpertsLab& lab) {
  QStringList parts;
  const auto& inputs = lab.built()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (i == lab.xInput()) continue;
    parts << labelOf(inputs[i]) + QLatin1Char(' ') + exactText(lab.values()[i], inputs[i].unit);
  }
  return parts.join(QStringLiteral(" · "));
}

}  // namespace

PlotTable pullTable(const ExpertsLab& lab) {
  const fuzzy::ForceModel& model = lab.built()->model;
  PlotTable table = labTable(lab.data(), PullTable::tr("averaged force and the experts' distances from it"),
                             QStringLiteral("-pulls"), {settingOf(lab)});
  table.columns = {columnName(model.inputs[lab.xInput()]), columnName(model.output)};
  for (const fuzzy::Expert& expert : model.experts) {
    table.columns.push_back(columnName("from_mean_" + expert.id, model.output.unit));
  }
  const auto pulls = pullsOf(lab.curves());
  for (std::size_t i = 0; i < lab.curves().x.size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.push_back(lab.curves().x[i]);
    row.push_back(forceCell(lab.curves().mean[i]));
    for (const auto& pull : pulls) row.push_back(std::isnan(pull[i]) ? PlotTable::Cell() : PlotTable::Cell(pull[i]));
  }
  return table;
}

}  // namespace tactus::workbench
