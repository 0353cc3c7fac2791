#include "app/workbench/views/finding_parts.h"

#include <QCoreApplication>

#include "app/workbench/controllers/findings_controller.h"
#include "app/workbench/controllers/term_controller.h"
#include "app/workbench/views/findings_panel.h"
#include "app/workbench/views/main_window.h"
#include "app/workbench/views/panel_area.h"

namespace tactus::workbench {

FindingParts::FindingParts(MainWindow& window, FindingsController& findings, TermController& terms) {
  window.panels().addPanel(QStringLiteral("findings"), QCoreApplication::translate("FindingParts", "Findings"),
                           new FindingsPanel(findings));
  // The editor behind the findings then stands at the list that the finding is about.
  QObject::connect(&findings, &FindingsController::lookedAt, &terms,
                   [&terms](const QString& expert, const QString& input) {
                     if (!terms.isOpen()) return;
                     terms.setExpert(expert.toStdString());
                     if (!input.isEmpty()) terms.setVariable(input.toStdString());
                   });
}

}  // namespace tactus::workbench
