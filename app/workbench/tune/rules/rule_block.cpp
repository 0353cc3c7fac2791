#include "app/workbench/tune/rules/rule_block.h"

#include <QCoreApplication>
#include <algorithm>
#include <vector>

#include "app/editing/rule_edits.h"
#include "app/editing/rule_grid.h"
#include "app/editing/term_list.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/selection.h"

namespace tactus::workbench {
namespace {

struct RuleBlock {
  Q_DECLARE_TR_FUNCTIONS(RuleBlock)
};

}  // namespace

QString copiedRules(const EditController& edits, const Selection& selection) {
  if (!edits.isOpen()) return {};
  const auto expert = editing::findExpert(edits.model(), selection.expert());
  return expert ? text(editing::rulesAsText(edits.model(), **expert, selection.rules())) : QString();
}

void pasteRules(EditController& edits, Selection& selection, const QString& lines) {
  if (!edits.isOpen()) return;
  const auto expert = editing::findExpert(edits.model(), selection.expert());
  if (!expert) return;
  const auto rules = editing::rulesFromText(edits.model(), **expert, lines.toStdString());
  if (!rules) {
    edits.refuse(RuleBlock::tr("Nothing was pasted: %1").arg(text(rules.error().message())));
    return;
  }
  if (!edits.apply(editing::putRules(edits.model(), selection.expert(), *rules))) return;
  const std::vector<fuzzy::Rule>& all = (*editing::findExpert(edits.model(), selection.expert()))->rules;
  std::vector<std::size_t> put;
  for (std::size_t r = 0; r < all.size(); ++r) {
    const bool is_one = std::any_of(rules->begin(), rules->end(), [&](const fuzzy::Rule& one) {
      return one.then == all[r].then && editing::sameConditions(one, all[r]);
    });
    if (is_one) put.push_back(r);
  }
  selection.pointAtRules(selection.expert(), std::move(put));
}

}  // namespace tactus::workbench
