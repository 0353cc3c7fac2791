#include "app/workbench/study/study_models.h"

#include <QFileInfo>
#include <algorithm>
#include <memory>
#include <utility>

#include "app/editing/history_versions.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/model/open_model.h"
#include "core/base/check.h"
#include "core/store/model_versions.h"

namespace tactus::workbench {
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
    auto read = readModel(file);
    if (!read) return tl::unexpected(read.error());
    return [this, model = std::make_shared<ModelInStudy>(std::move(*read))] {
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
  const QString name = harmless(text(edits_.history().labelOf(before)));
  if (!edits_.apply(editing::finished(built, label))) return false;
  if (edits_.history().current() == before) {
    emit said(tr("%1 It is the model that is open already.").arg(sentence));
    return true;
  }
  emit backOffered(tr("%1 What was open before stays in the history.").arg(sentence),
                   {tr("Back to %1").arg(elided(name)), [this, before] { edits_.returnTo(before); }});
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
