#include "app/workbench/collect/collect_controller.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/version.h"
#include "app/webform/answers.h"
#include "app/workbench/base/display_text.h"
#include "core/base/error.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"

namespace tactus::workbench {

using base::Result;

CollectController::CollectController(StudyConnection& study, QObject* parent) : QObject(parent), study_(study) {
  connect(&study_, &StudyConnection::opened, this, &CollectController::refresh);
  connect(&study_, &StudyConnection::contentsChanged, this, &CollectController::refresh);
  connect(&study_, &StudyConnection::closed, this, [this] {
    stale_ = filling_ = false;
    setup_.reset();
    setOverview({});
  });
}

const ParticipantRow* CollectController::row(const study::RecordId& person) const {
  const auto found = std::find_if(overview_.rows.begin(), overview_.rows.end(),
                                  [&](const ParticipantRow& one) { return one.person == person; });
  return found == overview_.rows.end() ? nullptr : &*found;
}

const session::SetupCertificate* CollectController::setup() const {
  const auto& read = overview_.setup;
  const auto& latest = setup_ && (!read || setup_->utc_ms > read->utc_ms) ? setup_ : read;
  return latest && session::holds(*latest, latest->device, utcNowMs()) ? &*latest : nullptr;
}

void CollectController::setSetup(const session::SetupCertificate& setup) {
  setup_ = setup;
  emit changed();
}

void CollectController::setSessionRunning(bool runs) {
  if (runs == runs_) return;
  runs_ = runs;
  if (!runs_) refresh();
  emit changed();
}

// Several requests while one is on its way become one more.
void CollectController::refresh() {
  if (!study_.isOpen()) return;
  stale_ = true;
  if (runs_ || reading_) return;
  reading_ = true;
  stale_ = false;
  study_.read(*this, [this, path = study_.path()](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto read = std::make_shared<Result<StudyOverview>>(readOverview(file));
    return [this, path, read] {
      reading_ = false;
      if (path == study_.path()) {
        if (*read) {
          setOverview(std::move(**read));
        } else {
          emit refused(
              tr("The participants of %1 were not read. %2").arg(study_.fileName(), text(read->error().message())),
              {tr("Read them again"), [this] { refresh(); }});
        }
      }
      if (stale_) refresh();
    };
  });
}

void CollectController::setOverview(StudyOverview overview) {
  overview_ = std::move(overview);
  emit changed();
}

void CollectController::addParticipant() {
  if (!study_.takesOrders()) return;
  const auto person = std::make_shared<study::Person>();
  study_.order(
      [person](store::StudyFile& file, study::RecordIds& ids) -> Result<void> {
        store::PersonCodes codes;
        TACTUS_TRY(const auto code, store::unusedCode(file, codes));
        *person = {ids.next(), code, false};
        return store::append(file, *person);
      },
      [this, person] {
        study_.refresh();
        emit added(person->id, text(person->code));
      },
      [this](const QString& sentence) {
        emit refused(tr("No participant was added. %1").arg(sentence), {tr("Try again"), [this] { addParticipant(); }});
      });
}

void CollectController::fillWithSimulated(const session::SimulatedGroup& group) {
  if (filling_ || runs_ || !study_.takesOrders()) return;
  filling_ = true;
  emit changed();
  const auto added = std::make_shared<int>(0);
  study_.order(
      [added, group](store::StudyFile& file, study::RecordIds& /*ids*/) -> Result<void> {
        TACTUS_TRY(const auto codes, session::addSimulatedNurses(file, group, utcNowMs(), std::string(kGenerator)));
        *added = static_cast<int>(codes.size());
        return {};
      },
      [this, added] {
        filling_ = false;
        study_.refresh();
        emit filled(*added);
        emit changed();
      },
      [this, group](const QString& sentence) {
        filling_ = false;
        emit changed();
        emit refused(tr("No simulated nurses were added. %1").arg(sentence),
                     {tr("Try again"), [this, group] { fillWithSimulated(group); }});
      });
}

void CollectController::importAnswers(const QStringList& paths) {
  if (paths.isEmpty() || !study_.takesOrders()) return;
  std::vector<std::string> files;
  for (const QString& path : paths) files.push_back(path.toStdString());
  const auto imported = std::make_shared<webform::AnswerImport>();
  study_.order(
      [imported, files](store::StudyFile& file, study::RecordIds& /*ids*/) -> Result<void> {
        TACTUS_TRY(*imported, webform::importAnswers(file, files, utcNowMs()));
        return {};
      },
      [this, imported] {
        study_.refresh();
        const auto added =
            std::count_if(imported->files.begin(), imported->files.end(), [](const auto& one) { return one.added; });
        QStringList notes;
        for (const std::string& note : imported->notes) notes << text(note);
        emit answersImported(static_cast<int>(imported->files.size()), static_cast<int>(added),
                             notes.join(QLatin1Char(' ')));
      },
      [this, paths](const QString& sentence) {
        emit refused(tr("No answers were imported. %1").arg(sentence),
                     {tr("Try again"), [this, paths] { importAnswers(paths); }});
      });
}

void CollectController::previewWithdrawal(const study::RecordId& person) {
  study_.read(*this, [this, person](const store::StudyFile& file) -> StudyConnection::Deliver {
    const auto preview = store::previewWithdrawal(file, person);
    return [this, person, preview] {
      if (preview) {
        emit previewed(person, *preview);
      } else {
        emit withdrawalRefused(person,
                               tr("What would be deleted was not counted. %1").arg(text(preview.error().message())));
      }
    };
  });
}

void CollectController::withdraw(const study::RecordId& person) {
  const ParticipantRow* const found = row(person);
  if (found == nullptr || withdrawing_ || !study_.takesOrders()) return;
  withdrawing_ = true;
  emit changed();
  const auto end = [this] {
    withdrawing_ = false;
    emit changed();
  };
  study_.withdraw(
      person,
      [this, end, code = found->code] {
        end();
        emit withdrawn(code);
      },
      [this, end, person, code = found->code](const QString& sentence) {
        end();
        emit withdrawalRefused(person, tr("%1 was not withdrawn. %2").arg(code, sentence));
      });
}

}  // namespace tactus::workbench
