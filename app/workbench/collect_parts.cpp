#include "app/workbench/collect_parts.h"

#include "app/workbench/collect/collect_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/author_name.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/study_parts.h"

namespace tactus::workbench {

CollectParts::CollectParts(MainWindow& window, StudyParts& study_parts, StudyConnection& study,
                           StudyModels& study_models, DeviceSession& device, const AuthorName& author)
    : window_(window),
      study_parts_(study_parts),
      study_(study),
      study_models_(study_models),
      collect_(study),
      protocol_(study),
      view_(new CollectView(collect_, protocol_, [&author] { return author.name(); })),
      run_(window, study, device) {
  window_.addScreen(Stage::kCollect, view_, MainWindow::Needs::kStudy);
  connectAll();
}

void CollectParts::connectAll() {
  connect(&study_, &StudyConnection::opened, this, &CollectParts::onOpened);
  connect(&study_, &StudyConnection::closed, this, [this] {
    // A window that was closed leads nowhere any more.
    if (window_.isVisible()) window_.setStudyOpen(false);
  });
  connect(&study_models_, &StudyModels::notesChanged, this, [this] { view_->home().showData(study_models_.notes()); });
  connect(&view_->home(), &StudyHome::startAsked, &run_, &SessionRun::start);
  connect(&view_->home(), &StudyHome::usabilityAsked, &run_, &SessionRun::startUsability);
  connect(&run_, &SessionRun::changed, this, [this] { collect_.setSessionRunning(run_.isRunning()); });
  connect(&run_, &SessionRun::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The session did not begin. %1").arg(sentence),
                                {tr("Try again"), [this] { run_.startAgain(); }});
  });
  connect(&run_, &SessionRun::refused, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The session did not begin. %1").arg(sentence),
                                {tr("Edit the protocol"), [this] { showProtocol(); }});
  });
  connectErrors();
  connect(&protocol_, &ProtocolController::stored, this, [this](int version) {
    window_.say(tr("Version %1 of the protocol is stored in %2.").arg(version).arg(study_.fileName()));
  });
  connect(&protocol_, &ProtocolController::keyStored, this, [this](bool is_set) {
    window_.say(is_set ? tr("The research key is set.") : tr("The research key is removed."));
  });
  connect(&collect_, &CollectController::withdrawn, this, [this](const QString& code) {
    window_.banner().showNote(
        tr("Everything of %1 is deleted from %2. Backups and exports made before can still hold the data.")
            .arg(code, study_.fileName()));
  });
}

void CollectParts::showProtocol() {
  window_.enter(Stage::kCollect);
  view_->showProtocol();
}

void CollectParts::connectErrors() {
  const auto show = [this](const QString& sentence, const MessageAct& act) {
    window_.banner().showRemedy(sentence, act);
  };
  connect(&protocol_, &ProtocolController::refused, this, [this, show](const QString& sentence) {
    show(sentence, {tr("Edit the protocol"), [this] { showProtocol(); }});
  });
  connect(&protocol_, &ProtocolController::notRead, this, [this, show](const QString& sentence) {
    show(sentence, {tr("Read it again"), [this] { protocol_.read(); }});
  });
  connect(&protocol_, &ProtocolController::keyRefused, this, [this, show](const QString& sentence) {
    show(sentence, {tr("Enter the key again"), [this] {
                      window_.enter(Stage::kCollect);
                      view_->showKey();
                    }});
  });
  connect(&collect_, &CollectController::refused, this, show);
  connect(&collect_, &CollectController::withdrawalRefused, this,
          [this, show](const study::RecordId& person, const QString& sentence) {
            show(sentence, {tr("Withdraw again…"), [this, person] { view_->askWithdrawal(person); }});
          });
}

void CollectParts::makeStudy() { study_parts_.chooseNew(); }

// A study without a model has nothing else to show, unless an open model is recorded into it.
void CollectParts::onOpened() {
  window_.setStudyOpen(true);
  if (!study_models_.hasModel() && !study_parts_.isToRecord()) window_.enter(Stage::kCollect);
}

}  // namespace tactus::workbench
