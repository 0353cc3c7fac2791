#include "app/workbench/views/rule_parts.h"

#include <QCoreApplication>

#include "app/workbench/controllers/rule_controller.h"
#include "app/workbench/views/main_window.h"
#include "app/workbench/views/panel_area.h"
#include "app/workbench/views/rule_editor.h"

namespace tactus::workbench {

RuleParts::RuleParts(MainWindow& window, RuleController& rules) {
  window.panels().addPanel(QStringLiteral("rule_editor"), QCoreApplication::translate("RuleParts", "Rules"),
                           new RuleEditor(rules));
}

}  // namespace tactus::workbench
