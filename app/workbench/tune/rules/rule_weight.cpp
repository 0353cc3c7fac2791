#include "app/workbench/tune/rules/rule_weight.h"

#include <QCoreApplication>

namespace tactus::workbench {
namespace {

struct RuleWeight {
  Q_DECLARE_TR_FUNCTIONS(RuleWeight)
};

}  // namespace

NumberBox* makeWeightBox(QWidget* parent) {
  constexpr double kStep = 0.05;
  fuzzy::Variable weight;
  weight.id = "weight";
  weight.label = RuleWeight::tr("Weight").toStdString();
  weight.unit = "1";
  auto* box = new NumberBox(weight, kStep, parent);
  box->setExact(1);
  // A wheel that passes over the box must not change a rule.
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

}  // namespace tactus::workbench
