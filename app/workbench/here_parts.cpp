#include "app/workbench/here_parts.h"

#include "app/workbench/shell/main_window.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/understand/here/variable_row.h"

namespace tactus::workbench {

HereParts::HereParts(MainWindow& window, SceneController& scene, Selection& selection)
    : terms_(window.addPanel(QStringLiteral("terms"), tr("Membership functions"), new VariableRow(scene))),
      rules_(window.addPanel(QStringLiteral("rules"), tr("Rules here"), new RulePanel(scene, selection))) {}

}  // namespace tactus::workbench
