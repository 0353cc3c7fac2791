// study_kill_child STUDY: opens the study in the controllers of the workbench and edits its model on and on; says the
// id of each version on standard output once it is acknowledged. Made to be killed.
#include <QCoreApplication>
#include <QTimer>
#include <iostream>
#include <unistd.h>

#include "app/editing/membership_edits.h"
#include "app/workbench/study/study_models.h"

int main(int argc, char** argv) {
  using namespace tactus;
  QCoreApplication application(argc, argv);
  if (argc != 2) return 2;
  workbench::ModelController models;
  workbench::EditController edits(models);
  workbench::StudyConnection study;
  const workbench::StudyModels kept(study, models, edits);
  std::size_t told = 0;
  double place = 0;
  QTimer next;
  QObject::connect(&study, &workbench::StudyConnection::failed, [](const QString&, const QString& sentence) {
    std::cerr << sentence.toStdString() << '\n';
    ::_exit(1);
  });
  QObject::connect(&study, &workbench::StudyConnection::opened, &next, [&next] { next.start(0); });
  QObject::connect(&edits, &workbench::EditController::stored, [&] {
    const auto& events = edits.history().events();
    for (; told < events.size() && events[told].stored; ++told) {
      if (::write(STDOUT_FILENO, events[told].id.bytes.data(), events[told].id.bytes.size()) != 16) ::_exit(1);
    }
  });
  QObject::connect(&next, &QTimer::timeout, [&] {
    place = place > 3 ? 1 : place + 0.01;
    edits.apply(editing::moveVertex(edits.model(), {{"depth", ""}, "near", 2}, place));
  });
  study.open(QString::fromLocal8Bit(argv[1]));
  return QCoreApplication::exec();
}
