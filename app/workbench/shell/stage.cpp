#include "app/workbench/shell/stage.h"

#include <QCoreApplication>

namespace tactus::workbench {
namespace {

struct StageText {
  Q_DECLARE_TR_FUNCTIONS(StageText)
};

}  // namespace

QString stageId(Stage stage) {
  switch (stage) {
    case Stage::kCollect: return QStringLiteral("collect");
    case Stage::kUnderstand: return QStringLiteral("understand");
    case Stage::kTune: return QStringLiteral("tune");
    case Stage::kBuild: return QStringLiteral("build");
    case Stage::kDeliver: return QStringLiteral("deliver");
  }
  return {};
}

QString stageName(Stage stage) {
  switch (stage) {
    case Stage::kCollect: return StageText::tr("Collect");
    case Stage::kUnderstand: return StageText::tr("Understand");
    case Stage::kTune: return StageText::tr("Tune");
    case Stage::kBuild: return StageText::tr("Build");
    case Stage::kDeliver: return StageText::tr("Deliver");
  }
  return {};
}

QString stageHint(Stage stage) {
  switch (stage) {
    case Stage::kCollect: return StageText::tr("sessions with nurses");
    case Stage::kUnderstand: return StageText::tr("maps, curves and rules");
    case Stage::kTune: return StageText::tr("terms and their force");
    case Stage::kBuild: return StageText::tr("a model from the answers");
    case Stage::kDeliver: return StageText::tr("a bundle for a simulator");
  }
  return {};
}

}  // namespace tactus::workbench
