#include "app/workbench/finding_parts.h"

#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/findings/findings_panel.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::workbench {

FindingParts::FindingParts(MainWindow& window, FindingsController& findings, TermController& terms,
                           RuleController& rules)
    : panel_(window.addPanel(QStringLiteral("findings"), tr("Findings"), new FindingsPanel(findings))) {
  // The tab says what the last edit added, also while another panel lies on top.
  QObject::connect(&findings, &FindingsController::changed, &panel_, [panel = &panel_, &findings] {
    const QString title = findings.added() == 0 ? tr("Findings") : tr("Findings (+%1)").arg(findings.added());
    if (findings.isCurrent() && title != panel->windowTitle()) panel->setWindowTitle(title);
  });
  // The editors behind the findings then stand at what the finding is about.
  QObject::connect(&findings, &FindingsController::lookedAt, &terms,
                   [&terms, &rules](const QString& expert, const QString& input) {
                     if (!terms.isOpen()) return;
                     if (!expert.isEmpty()) rules.setExpert(expert.toStdString());
                     terms.setExpert(expert.toStdString());
                     if (!input.isEmpty()) terms.setVariable(input.toStdString());
                   });
}

}  // namespace tactus::workbench
