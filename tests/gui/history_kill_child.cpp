// history_kill_child MODEL AUTOSAVES: opens the model alone in the controllers of the workbench and edits it on and on;
// says the id of the last version on standard output once it is in the history file. Made to be killed.
#include <QCoreApplication>
#include <QTimer>
#include <iostream>
#include <unistd.h>

#include "app/editing/membership_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"

int main(int argc, char** argv) {
  using namespace tactus;
  QCoreApplication application(argc, argv);
  if (argc != 3) return 2;
  workbench::ModelController models;
  workbench::EditController edits(models);
  workbench::AutosaveController autosave(models, edits, QString::fromLocal8Bit(argv[2]));
  double place = 0;
  QTimer next;
  QObject::connect(&autosave, &workbench::AutosaveController::failed, [](const QString& sentence) {
    std::cerr << sentence.toStdString() << '\n';
    ::_exit(1);
  });
  QObject::connect(&autosave, &workbench::AutosaveController::lookedUp, &next, [&next] { next.start(0); });
  // Each edit waits for its write, so that the last event is on the disk.
  QObject::connect(&autosave, &workbench::AutosaveController::written, [&edits] {
    const study::RecordId id = edits.history().events().back().id;
    if (::write(STDOUT_FILENO, id.bytes.data(), id.bytes.size()) != 16) ::_exit(1);
  });
  QObject::connect(&next, &QTimer::timeout, [&] {
    place = place > 3 ? 1 : place + 0.01;
    edits.apply(editing::moveVertex(edits.model(), {{"depth", ""}, "near", 2}, place));
    autosave.flush();
  });
  models.open(QString::fromLocal8Bit(argv[1]));
  return QCoreApplication::exec();
}
