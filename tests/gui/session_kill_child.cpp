// session_kill_child STUDY: does a session of the study through the proxy of the screens, or continues the latest one,
// and answers its form on and on; writes a byte to standard output for each acknowledged answer. Made to be killed.
#include <QCoreApplication>
#include <iostream>
#include <unistd.h>

#include "app/workbench/study/connection/session_proxy.h"
#include "core/store/sessions.h"

namespace {

using namespace tactus;
using workbench::SessionProxy;

session::SessionStart start() {
  session::SessionStart out;
  out.person = study::RecordIds(3).next();
  out.consent_version = "2026-1";
  out.settings.blocks = {session::Block::kForm};
  return out;
}

// Answers what is asked; at the end it goes back and corrects the last answer.
void goOn(SessionProxy& proxy, bool& replying) {
  const auto at = proxy.snapshot();
  if (!at || proxy.isSaving()) return;
  if (replying && ::write(STDOUT_FILENO, "a", 1) != 1) ::_exit(1);
  replying = at->part == session::SessionPart::kForm;
  if (at->part == session::SessionPart::kProfile) proxy.tell(at->step, {});
  if (replying) proxy.reply(at->step, {study::Answer::Status::kAnswered, "medium"}, 1);
  if (at->part == session::SessionPart::kRating) proxy.back(at->step);
}

}  // namespace

int main(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  if (argc != 2) return 2;
  workbench::StudyConnection connection;
  SessionProxy proxy(connection);
  bool replying = false;
  const auto fail = [](const QString& sentence) {
    std::cerr << sentence.toStdString() << '\n';
    ::_exit(1);
  };
  QObject::connect(&connection, &workbench::StudyConnection::failed,
                   [fail](const QString&, const QString& sentence) { fail(sentence); });
  QObject::connect(&proxy, &SessionProxy::refused, fail);
  QObject::connect(
      &proxy, &SessionProxy::changed, &proxy, [&] { goOn(proxy, replying); }, Qt::QueuedConnection);
  QObject::connect(&connection, &workbench::StudyConnection::opened, [&] {
    connection.read(proxy, [&](const store::StudyFile& file) -> workbench::StudyConnection::Deliver {
      const auto sessions = store::sessions(file);
      const auto latest =
          sessions && !sessions->empty() ? std::optional(sessions->back().id) : std::optional<study::RecordId>();
      return [&, latest] {
        if (latest) {
          proxy.resume(*latest);
        } else {
          proxy.begin(start(), study::Person{start().person, "amber-otter", false});
        }
      };
    });
  });
  connection.open(QString::fromLocal8Bit(argv[1]));
  return QCoreApplication::exec();
}
