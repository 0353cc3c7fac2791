#include "app/workbench/tune/rules/rule_weight.h"

#include <QCoreApplication>

namespace tactus::workbench {

NumberBox* makeWeightBox(QWidget* parent) {
  constexpr double kStep = 0.05;
  fuzzy::Variable weight;
  weight.id = "weight";
  weight.label = QCoreApplication::translate("RuleWeight", "Weight").toStdString();
  weight.unit = "1";
  auto* box = new NumberBox(weight, kStep, parent);
  box->setExact(1);
  // A wheel that passes over the box must not change a rule.
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

}  // namespace tactus::workbench
