#include "app/workbench/shell/stage.h"

#include <QCoreApplication>

namespace tactus::workbench {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Stage", text); }

}  // namespace

QString stageId(Stage stage) {
  switch (stage) {
    case Stage::kCollect:
      return QStringLiteral("collect");
    case Stage::kUnderstand:
      return QStringLiteral("understand");
    case Stage::kTune:
      return QStringLiteral("tune");
    case Stage::kAgree:
      return QStringLiteral("agree");
    case Stage::kDeliver:
      return QStringLiteral("deliver");
  }
  return {};
}

QString stageName(Stage stage) {
  switch (stage) {
    case Stage::kCollect:
      return tr("Collect");
    case Stage::kUnderstand:
      return tr("Understand");
    case Stage::kTune:
      return tr("Tune");
    case Stage::kAgree:
      return tr("Agree");
    case Stage::kDeliver:
      return tr("Deliver");
  }
  return {};
}

QString stageHint(Stage stage) {
  switch (stage) {
    case Stage::kCollect:
      return tr("later: sessions with nurses");
    case Stage::kUnderstand:
      return tr("maps, curves and rules");
    case Stage::kTune:
      return tr("terms and their force");
    case Stage::kAgree:
      return tr("later: experts side by side");
    case Stage::kDeliver:
      return tr("later: export and report");
  }
  return {};
}

bool isReady(Stage stage) { return stage == Stage::kUnderstand || stage == Stage::kTune; }

}  // namespace tactus::workbench
