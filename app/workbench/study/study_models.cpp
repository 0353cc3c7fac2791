#include "app/workbench/study/study_models.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "app/editing/history_versions.h"
#include "app/session/data_checks.h"
#include "app/session/session_notes.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/model/open_model.h"
#include "core/base/check.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/store/model_versions.h"
#include "core/store/study_info.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/published_settings.h"

namespace tactus::workbench {
namespace {

using base::Result;

struct ModelInStudyText {
  Q_DECLARE_TR_FUNCTIONS(ModelInStudyText)
};

// `3 experts, 1 of them simulated`.
QString expertsText(const fuzzy::ForceModel& model, const std::vector<study::Participant>& participants) {
  const auto simulated = std::count_if(model.experts.begin(), model.experts.end(), [&](const fuzzy::Expert& expert) {
    return std::any_of(participants.begin(), participants.end(), [&](const study::Participant& participant) {
      return participant.code == expert.id && participant.simulated;
    });
  });
  const auto experts = static_cast<qlonglong>(model.experts.size());
  const QString all = ModelInStudyText::tr("%n expert(s)", nullptr, static_cast<int>(experts));
  if (simulated == 0) return all;
  return simulated == experts ? ModelInStudyText::tr("%1, SIMULATED").arg(all)
                              : ModelInStudyText::tr("%1, %2 of them SIMULATED").arg(all).arg(simulated);
}

Result<void> addVersions(const store::StudyFile& file, ModelInStudy& out) {
  TACTUS_TRY(auto versions, store::modelVersions(file));
  // What participants felt of their own answers is no state of the researcher's model.
  std::erase_if(versions, [](const study::ModelVersion& version) { return version.label == session::kOwnModelLabel; });
  out.versions = versions;
  if (versions.empty()) return {};
  TACTUS_TRY(auto last, store::modelVersion(file, versions.back().id));
  versions.back() = std::move(last);
  auto history = editing::historyFrom(versions, study::RecordIds());
  if (!history) return base::inFile(history.error(), file.path());
  out.history = std::move(*history);
  return {};
}

bool hasAnswers(const store::StudyInfo& info) {
  return std::any_of(info.counts.begin(), info.counts.end(), [](const store::TableCount& count) {
    return (count.table == "answer" || count.table == "rule") && count.rows > 0;
  });
}

}  // namespace

Result<BuiltFromStudy> buildFromStudy(const store::StudyFile& file, const editing::Stamp& stamp,
                                      elicitation::BuildSettings settings) {
  TACTUS_TRY(const auto view, session::studyForElicitation(file));
  const auto data = session::dataFindings(view.study);
  if (auto ok = study::refuseData(data); !ok) return base::inFile(ok.error(), file.path());
  settings.created_utc =
      base::formatUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(stamp.utc_ms)));
  settings.generator = kGenerator;
  const auto forms = session::knownForms(procedure::of(view.study));
  auto built = elicitation::buildModel(view.study, forms, settings);
  if (!built) return base::inFile(built.error(), file.path());
  elicitation::noteUnlikePublished(*built, view.study, forms, settings);
  const QString experts = expertsText(built->model, view.study.participants);
  TACTUS_TRY(auto history,
             editing::EditHistory::open(built->model,
                                        ModelInStudyText::tr("Built from the study: %1").arg(experts).toStdString(),
                                        stamp, study::RecordIds()));
  BuiltFromStudy out{
      std::move(history),
      ModelInStudyText::tr("Built from the answers in %1: %2.").arg(shownFileName(text(file.path())), experts),
      {}};
  out.notes = {dataNotes(data, procedure::of(view.study)), notesOf(view.notes, *built)};
  const std::size_t count = out.notes.data.size() + out.notes.build.size();
  if (count > 0) {
    out.sentence += QLatin1Char(' ') + ModelInStudyText::tr("There are %n note(s) about it beside the heading.",
                                                            nullptr, static_cast<int>(count));
  }
  return out;
}

Result<ModelInStudy> readModel(const store::StudyFile& file) {
  ModelInStudy out;
  TACTUS_TRY(const auto info, store::studyInfo(file));
  if (auto ok = addVersions(file, out); !ok) return tl::unexpected(ok.error());
  out.has_answers = hasAnswers(info);
  return out;
}

namespace {

constexpr std::size_t kAtOnce = 20;  // few, so that edits are stored in between

}  // namespace

VersionTexts::VersionTexts(StudyConnection& study, QObject* parent)
    : QObject(parent), study_(study), shelf_(std::make_shared<Shelf>()) {}

void VersionTexts::begin(const std::vector<study::ModelVersion>& versions, std::size_t most_ahead_bytes) {
  shelf_ = std::make_shared<Shelf>();
  shelf_->most_bytes = most_ahead_bytes;
  for (auto version = versions.rbegin(); version != versions.rend(); ++version) shelf_->ahead.push_back(version->id);
  readAhead(0);
}

EditController::VersionReader VersionTexts::reader() {
  return [texts = QPointer(this), shelf = shelf_](const study::RecordId& id) -> Read {
    const auto found = shelf->read.find(id);
    if (found != shelf->read.end()) return found->second;
    if (texts && texts->shelf_ == shelf) texts->ask(id);
    return base::fail(base::ErrorCode::kIo, "model version " + study::toText(id), "not read from the study yet",
                      "another try in a moment");
  };
}

void VersionTexts::ask(const study::RecordId& id) {
  if (shelf_->asked.insert(id).second) read({id}, [] {});
}

void VersionTexts::readAhead(std::size_t next) {
  const auto& ahead = shelf_->ahead;
  if (next >= ahead.size() || shelf_->bytes >= shelf_->most_bytes) return;
  const std::size_t end = std::min(next + kAtOnce, ahead.size());
  read({ahead.begin() + static_cast<std::ptrdiff_t>(next), ahead.begin() + static_cast<std::ptrdiff_t>(end)},
       [this, end] { readAhead(end); });
}

void VersionTexts::read(std::vector<study::RecordId> wanted, std::function<void()> then) {
  study_.read(*this,
              [this, wanted = std::move(wanted), then = std::move(then),
               shelf = shelf_](const store::StudyFile& file) -> StudyConnection::Deliver {
                std::vector<std::pair<study::RecordId, Read>> found;
                for (const study::RecordId& id : wanted) found.emplace_back(id, store::modelVersion(file, id));
                return [this, then, shelf, found = std::move(found)] {
                  if (shelf != shelf_) return;
                  bool wanted_now = false;
                  for (const auto& [id, version] : found) {
                    if (version && shelf->read.emplace(id, version).second) shelf->bytes += version->text.size();
                    if (!version) shelf->read.emplace(id, version);
                    wanted_now |= shelf->asked.erase(id) > 0;
                  }
                  if (wanted_now) emit arrived();
                  then();
                };
              });
}

namespace {

// The text of the version that `version` was made of by edits.
std::optional<std::string> firstText(const store::StudyFile& file, const study::RecordId& version) {
  const auto before = store::modelAncestors(file, version);
  if (!before) return std::nullopt;
  const auto first = store::modelVersion(file, before->empty() ? version : before->back().id);
  return first ? std::optional(first->text) : std::nullopt;
}

}  // namespace

StudyReview::StudyReview(StudyConnection& study, QObject* parent) : QObject(parent), study_(study) {}

void StudyReview::begin(const std::optional<study::RecordId>& model) {
  clear();
  busy_ = true;
  const auto closed = [this, number = newest_] {
    if (number == newest_) setNotes({});
  };
  const auto read = [this, number = newest_, model](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto view = session::studyForElicitation(file);
    if (!view) {
      // Two persons with one code, or a record that is damaged: no build is possible.
      return [this, number, sentence = text(view.error().message())] {
        if (number == newest_) setNotes({{{sentence, {}}}, {}});
      };
    }
    const auto study = std::make_shared<const ReadStudy>(ReadStudy{std::move(view->study), std::move(view->notes)});
    return [this, number, study, first = model ? firstText(file, *model) : std::nullopt] {
      if (number != newest_) return;
      background_.run([this, study, first](const std::stop_token&) -> Background::Deliver {
        return [this, notes = reviewed(*study, first)] { setNotes(notes); };
      });
    };
  };
  study_.read(*this, read, closed);
}

void StudyReview::set(BuildNotes notes) {
  ++newest_;
  background_.drop();
  setNotes(std::move(notes));
}

void StudyReview::setNotes(BuildNotes notes) {
  busy_ = false;
  if (notes == notes_) return;
  notes_ = std::move(notes);
  emit changed();
}

namespace {

using base::Result;

// Appends one version. One that is there already was written by an attempt whose answer got lost.
Result<void> storeVersion(store::StudyFile& file, const editing::Event& event, const fuzzy::ForceModel& model) {
  const study::ModelVersion version = editing::versionOf(event, model);
  auto stored = store::append(file, version);
  if (stored) return stored;
  const auto there = store::modelVersion(file, version.id);
  if (there && there->sha256 == version.sha256) return {};
  return stored;
}

// The model of a state for the other thread; the current one is shared.
std::shared_ptr<const fuzzy::ForceModel> modelOf(const editing::EditHistory& history, editing::StateId state) {
  if (state == history.current()) {
    const editing::SharedModel ready = *history.readyOf(state);
    return {ready, &ready->model};
  }
  auto model = history.modelOf(state);
  TACTUS_CHECK(model.has_value());  // a state leaves the memory only once it is stored
  return std::make_shared<const fuzzy::ForceModel>(std::move(*model));
}

// For a button.
QString elided(const QString& name) {
  constexpr qsizetype kMost = 32;
  return name.size() <= kMost ? name : name.first(kMost - 1) + QChar(0x2026);
}

// Beside the study where that can be written to.
QString unusedModelPath(const QString& study, bool read_only) {
  const QFileInfo info(study);
  const QString folder = read_only ? documentsFolder() : info.absolutePath();
  return freshModelPath(folder + QLatin1Char('/') + info.completeBaseName());
}

}  // namespace

StudyModels::StudyModels(StudyConnection& study, ModelController& models, EditController& edits, QObject* parent)
    : QObject(parent), study_(study), models_(models), edits_(edits) {
  study_.attach(*this);
  connect(&study_, &StudyConnection::changed, this, &StudyModels::savedChanged);
  connect(&study_, &StudyConnection::openedAgain, this, &StudyModels::openModel);
  // Rules of a participant who withdrew were removed from versions on the screen.
  connect(&study_, &StudyConnection::modelsErased, this, [this] {
    if (keepsModel()) openModel();
  });
  connect(&review_, &StudyReview::changed, this, &StudyModels::notesChanged);
  connect(&texts_, &VersionTexts::arrived, &edits_, &EditController::historyChanged);
  connect(&edits_, &EditController::historyChanged, this, &StudyModels::storeEvents);
  connect(&models_, &ModelController::opened, this, &StudyModels::savedChanged);
  connect(&models_, &ModelController::storeNow, this, &StudyModels::storeNow);
  connect(&models_, &ModelController::reopenFromStudy, this, &StudyModels::openModel);
  connect(&models_, &ModelController::copied, this, [this](const QString& copy) {
    emit said(tr("A copy was written to %1; edits go on into %2.").arg(shownFileName(copy), study_.fileName()));
  });
}

StudyModels::~StudyModels() {
  orderRest();
  study_.detach();
}

bool StudyModels::keepsModel() const { return study_.isOpen() && models_.current() && models_.current()->in_study; }

QString StudyModels::savedText() const {
  if (!keepsModel()) return {};
  if (!study_.failure().isEmpty()) return tr("● Not stored in %1").arg(study_.fileName());
  return (study_.isSlow() ? tr("Saving in %1…") : tr("Stored in %1")).arg(study_.fileName());
}

std::optional<study::RecordId> StudyModels::modelVersion() const {
  if (!keepsModel()) return std::nullopt;
  // While versions are compared, another one than the open one may be looked at.
  if (models_.shown() != models_.current() && models_.shown()->version) return models_.shown()->version;
  return edits_.history().versionOf(edits_.history().current());
}

void StudyModels::openModel() {
  study_.readAlone(*this, [this]() -> StudyConnection::Read {
    const std::size_t known = edits_.isOpen() ? edits_.history().events().size() : 0;
    return [this, known](const store::StudyFile& file) -> StudyConnection::Deliver {
      auto read = readModel(file);
      const QString sentence = read ? QString() : text(read.error().message());
      const auto model = read ? std::make_shared<ModelInStudy>(std::move(*read)) : nullptr;
      return [this, known, model, sentence] {
        if (!model) {
          emit failed(study_.path(), tr("The model in %1 was not opened. %2").arg(study_.fileName(), sentence),
                      {tr("Build the averaged model"), [this] { buildModel(); }});
        } else if (keepsModel() && edits_.history().events().size() != known) {
          openModel();  // what was edited meanwhile has to be read too
        } else {
          adopt(*model);
          study_.refresh();
        }
      };
    };
  });
}

void StudyModels::buildModelWith(const elicitation::BuildSettings& settings) {
  study_.readAlone(*this, [this, settings]() -> StudyConnection::Read {
    return [this, settings, stamp = edits_.stamp()](const store::StudyFile& file) -> StudyConnection::Deliver {
      const auto made = std::make_shared<Result<BuiltFromStudy>>(buildFromStudy(file, stamp, settings));
      return [this, made] {
        if (*made) {
          const editing::EditHistory& built = (*made)->history;
          const bool beside = putBeside(built.model(), built.labelOf(built.current()), (*made)->sentence);
          if (!beside) show(std::move((*made)->history));
          review_.set(std::move((*made)->notes));
          if (!beside) emit said((*made)->sentence);
        } else {
          review_.begin(modelVersion());  // what is in the way stands there too
          emit failed(study_.path(), tr("No model was built. %1").arg(text(made->error().message())), {});
        }
      };
    };
  });
}

void StudyModels::putModel() {
  if (!study_.takesOrders() || study_.isOpening() || !models_.current() || keepsModel()) return;
  edits_.commit();
  const QString from = shownFileName(models_.current()->path);
  events_ordered_ = 0;
  models_.moveIntoStudy(study_.path());
  has_model_ = true;
  storeEvents();
  review_.begin(modelVersion());
  emit savedChanged();
  emit said(tr("%1 is a model of %2 now, with everything that was done to it.").arg(from, study_.fileName()));
}

StudyKeeper::ReadShare StudyModels::reader() {
  return [this](const store::StudyFile& file) -> Result<Take> {
    TACTUS_TRY(auto read, readModel(file));
    return [this, model = std::make_shared<ModelInStudy>(std::move(read))] {
      if (keepsModel() && !model->history) moveOut();
      adopt(*model);
    };
  };
}

void StudyModels::orderRest() {
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
}

void StudyModels::orderAgain() {
  if (refused_.isEmpty()) return;
  refused_.clear();
  events_ordered_ = 0;
  storeEvents();
}

void StudyModels::leave() {
  if (keepsModel()) moveOut();
  refused_.clear();
  review_.clear();
  has_model_ = false;
}

void StudyModels::storeNow() {
  study_.storeNow();
  if (!study_.isBusy() && keepsModel()) emit said(tr("Everything is stored in %1.").arg(study_.fileName()));
}

void StudyModels::adopt(ModelInStudy& model) {
  refused_.clear();
  has_model_ = model.history.has_value();
  texts_.begin(model.versions);
  if (model.history) show(std::move(*model.history));
  review_.begin(model.versions.empty() ? std::nullopt : std::optional(model.versions.back().id));
  if (has_model_) return;
  if (model.has_answers) {
    emit buildOffered(tr("%1 holds answers, but no model yet.").arg(study_.fileName()));
  } else {
    emit said(tr("%1 holds neither a model nor answers of experts. Sessions begin in Collect; or open a model and put "
                 "it into the study with Study, or read tables into it with tactus study import.")
                  .arg(study_.fileName()));
  }
}

void StudyModels::show(editing::EditHistory history) {
  OpenModel open(history.ready());
  // A study that is open for reading keeps no edits: they go on with a history of their own, and can be saved as a
  // file.
  open.in_study = !study_.isReadOnly();
  open.path = open.in_study ? study_.path() : unusedModelPath(study_.path(), true);
  open.simulated = saysSimulated(open.model);
  adopting_ = true;
  models_.openRead(std::move(open));
  edits_.adopt(std::move(history), texts_.reader());
  adopting_ = false;
  has_model_ = true;
  events_ordered_ = 0;
  storeEvents();
  emit savedChanged();
}

// A study has one history: a model that is built anew is its next state, and what was tuned stays in sight. Returns
// false where there is no history to put it into, or one of other inputs.
bool StudyModels::putBeside(const fuzzy::ForceModel& built, const std::string& label, const QString& sentence) {
  if (!keepsModel() || !edits_.isOpen()) return false;
  const auto& inputs = edits_.model().inputs;
  const bool same = std::equal(inputs.begin(), inputs.end(), built.inputs.begin(), built.inputs.end(),
                               [](const fuzzy::Variable& a, const fuzzy::Variable& b) { return a.id == b.id; });
  if (!same) return false;
  edits_.commit();
  const editing::StateId before = edits_.history().current();
  const QString name = harmless(text(edits_.history().nameOf(before)));
  if (!edits_.apply(editing::finished(built, label))) return false;
  if (edits_.history().current() == before) {
    emit said(tr("%1 It is the model that is open already.").arg(sentence));
    return true;
  }
  emit backOffered(sentence, {tr("Back to %1").arg(elided(name)), [this, before] { edits_.returnTo(before); }});
  return true;
}

void StudyModels::storeEvents() {
  if (adopting_ || !keepsModel()) return;
  const editing::EditHistory& history = edits_.history();
  for (; events_ordered_ < history.events().size(); ++events_ordered_) {
    const editing::Event& event = history.events()[events_ordered_];
    if (event.stored) continue;
    study_.order([event, model = modelOf(history, event.state)](
                     store::StudyFile& file, study::RecordIds&) { return storeVersion(file, event, *model); },
                 [this, id = event.id] { edits_.markStored(id); },
                 [this](const QString& sentence) {
                   refused_ = sentence;
                   emit failed(study_.path(), sentence, {});
                 });
  }
}

// The study keeps what was done to its model until now. Beside it the model goes on with a history of its own, so that
// all of it can be kept elsewhere: as a file, after a crash, in another study.
void StudyModels::moveOut() {
  // Its own path: the study that is open may be the next one already.
  const QString study = models_.current()->path;
  models_.moveOutOfStudy(unusedModelPath(study, false));
  edits_.adopt(editing::EditHistory::open(edits_.history().ready(),
                                          tr("Left in %1").arg(shownFileName(study)).toStdString(), edits_.stamp(),
                                          study::RecordIds()));
}

}  // namespace tactus::workbench
