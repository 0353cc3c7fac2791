#include "app/workbench/labs/frame/lab_caption.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

struct LabCaption {
  Q_DECLARE_TR_FUNCTIONS(LabCaption)
};

QString simulatedText(const std::vector<study::Participant>& participants) {
  QStringList simulated;
  for (const study::Participant& one : participants) {
    if (one.simulated) simulated << harmless(text(one.code));
  }
  if (simulated.isEmpty()) return {};
  return LabCaption::tr("SIMULATED: data of %1").arg(simulated.join(QStringLiteral(", ")));
}

}  // namespace

PlotTable labTable(const LabData& data, const QString& what, const QString& suffix, const QStringList& notes) {
  const QFileInfo study(data.connection().path());
  PlotTable table;
  table.file = study.absolutePath() + QLatin1Char('/') + study.completeBaseName() + suffix;
  table.caption << QStringLiteral("%1: %2").arg(data.connection().fileName(), what);
  table.caption << notes;
  const QString simulated = data.study() == nullptr ? QString() : simulatedText(data.study()->study.participants);
  if (!simulated.isEmpty()) table.caption << simulated;
  return table;
}

}  // namespace tactus::workbench
