#include "app/workbench/features/features.h"

#include <QAction>

#include "app/workbench/features/bench.h"
#include "app/workbench/shell/menus.h"

namespace tactus::workbench {

void followStudy(Bench& bench, QAction* action, const std::function<bool()>& may) {
  const auto follow = [action, may] { action->setEnabled(may()); };
  follow();
  QObject::connect(&bench.collect, &CollectController::changed, &bench.features, follow);
  QObject::connect(&bench.study, &StudyConnection::changed, &bench.features, follow);
}

void addFeatures(Bench& bench) {
  addHere(bench);
  addCurves(bench);
  addMap(bench);
  addFeel(bench);
  addLink(bench);
  addRules(bench);
  addEditing(bench);
  addPull(bench);
  addFindings(bench);
  addContracts(bench);
  addStudy(bench);
  addStrokes(bench);
  addCollect(bench);
  addStart(bench);
  addLabs(bench);
  addOrigins(bench);
  addReport(bench);
  addSealing(bench);
  addStudyExport(bench);
  addNotes(bench);
  addHistory(bench);
  addDuel(bench);
  addTell(bench);
  addMarks(bench);
  addSelection(bench);
  addDeliver(bench);
  addRecovery(bench);
  addPictures(bench);
  addScreens(bench);
  (new ViewMenu(bench.window, bench.models, bench.settings))->setParent(&bench.features);
  addHelp(bench);
  addSearch(bench);
  addHelpMenu(bench.window);
}

}  // namespace tactus::workbench
