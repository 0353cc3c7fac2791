#include "app/workbench/rule_parts.h"

#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_editor.h"

namespace tactus::workbench {

RuleParts::RuleParts(MainWindow& window, RuleController& rules)
    : editor_(new RuleEditor(rules)), panel_(window.addPanel(QStringLiteral("rule_editor"), tr("Rules"), editor_)) {
  panel_.setFocusProxy(editor_);
}

}  // namespace tactus::workbench
