#include "app/workbench/tune/history/recovery_controller.h"

#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

namespace tactus::workbench {
namespace {

using Where = LostWork::Where;

/// The SHA-256 of the model in the file `path`, as versions have it; empty if there is none.
std::string modelSha256(const QString& path) {
  const auto read = model_io::readModel(path.toStdString());
  return read ? base::sha256(model_io::formatModel(read->model)) : std::string();
}

/// What the history at `path` has beyond the file of its document; nothing if that is up to date, or if another program
/// has the history open.
std::optional<LostWork> lostIn(const QString& path) {
  const auto work = HistoryFile::read(path, false);
  if (!work || work->kept.versions.empty()) return std::nullopt;
  const auto& versions = work->kept.versions;
  LostWork out{Where::kHistoryFile, path, work->document, 0, QDateTime::fromMSecsSinceEpoch(versions.back().utc_ms)};
  const std::string in_file = isStudyPath(work->document) ? std::string() : modelSha256(work->document);
  const auto same =
      std::find_if(versions.rbegin(), versions.rend(), [&](const auto& version) { return version.sha256 == in_file; });
  if (same == versions.rbegin()) return std::nullopt;
  const auto later = static_cast<std::size_t>(same - versions.rbegin());
  out.edits =
      static_cast<int>(editing::editsIn(std::span(versions).last(later))) + (editing::isDrag(versions.back()) ? 1 : 0);
  return out;
}

/// All that crashes left below `root`, newest first. `own`: the history file of this program.
std::vector<LostWork> scanned(const QString& root, const QString& own) {
  std::vector<LostWork> out;
  for (const QString& path : HistoryFile::leftByCrash(root)) {
    if (path == own) continue;
    if (auto work = lostIn(path)) out.push_back(std::move(*work));
  }
  std::sort(out.begin(), out.end(), [](const LostWork& a, const LostWork& b) { return a.last > b.last; });
  return out;
}

}  // namespace

RecoveryController::RecoveryController(ModelController& models, EditController& edits, AutosaveController& autosave,
                                       QString root, QObject* parent)
    : QObject(parent), models_(models), edits_(edits), autosave_(autosave), root_(std::move(root)) {
  connect(&models_, &ModelController::opened, this, &RecoveryController::onOpened);
  connect(&autosave_, &AutosaveController::lookedUp, this, &RecoveryController::onLookedUp);
  connect(&autosave_, &AutosaveController::written, this, &RecoveryController::onWritten);
  // A document that was left before its autosave was written: the files keep what it had, free for the next scan.
  connect(&edits_, &EditController::modelReset, this, [this] { replaced_.clear(); });
  scan();
}

// The worker answers to this.
RecoveryController::~RecoveryController() { autosave_.wait(); }

std::optional<LostWork> RecoveryController::offered() const {
  return offered_.empty() ? std::nullopt : std::optional(offered_.front());
}

void RecoveryController::scan() {
  autosave_.post([this, root = root_](const HistoryFile& own) {
    answers_.post([this, found = scanned(root, own.path())] { show(found); });
  });
}

void RecoveryController::show(std::vector<LostWork> found) {
  if (busy_) return;
  offered_ = std::move(found);
  const auto open = models_.current();
  const auto is_open = [&](const LostWork& work) { return open && work.document == open->path; };
  // The history of the open model file is that of AutosaveController.
  std::erase_if(offered_, [&](const LostWork& work) {
    const auto postponed = [&](const LostWork& other) { return other.source == work.source; };
    return std::any_of(put_off_.begin(), put_off_.end(), postponed) ||
           (is_open(work) && !open->in_study && work.where == Where::kHistoryFile);
  });
  std::stable_partition(offered_.begin(), offered_.end(), is_open);
  if (const auto& lost = autosave_.lost()) {
    offered_.insert(offered_.begin(), {Where::kOpenDocument, open->path, open->path, lost->edits,
                                       QDateTime::fromMSecsSinceEpoch(lost->last_utc_ms)});
  }
  emit offerChanged();
}

void RecoveryController::onOpened() {
  if (busy_) return;
  const auto open = models_.current();
  std::erase_if(put_off_, [&](const LostWork& work) { return work.document == open->path; });
  scan();
  // The history of the study follows the model.
  if (open->in_study && wanted_ && wanted_->document == open->path) {
    QTimer::singleShot(0, this, [this, work = *std::exchange(wanted_, std::nullopt)] { restoreWork(work); });
  }
}

void RecoveryController::onLookedUp(const QString& document) {
  if (busy_) return;
  scan();
  if (!wanted_ || wanted_->document != document) return;
  const LostWork work = *std::exchange(wanted_, std::nullopt);
  if (autosave_.lost()) {
    restoreOpen(work);
  } else {
    emit notRestored(
        tr("The edits of %1 were not restored, because another window has them.").arg(shownFileName(work.document)),
        work);
  }
}

void RecoveryController::restore() {
  if (offered_.empty()) return;
  const LostWork work = offered_.front();
  restoreWork(work);
}

void RecoveryController::restoreWork(const LostWork& work) {
  if (busy_) return;
  wanted_.reset();
  if (work.where == Where::kOpenDocument) return restoreOpen(work);
  // A study file keeps the history of its models itself.
  const bool in_study = isStudyPath(work.document);
  const bool is_open = models_.current() && models_.current()->path == work.document;
  if (in_study && !is_open) {
    wanted_ = work;
    emit studyNeeded(work.document);
    return;
  }
  if (!in_study && work.where == Where::kHistoryFile) {
    if (auto open = readOpenModel(work.document)) {
      wanted_ = work;
      models_.openRead(std::move(*open));
      return;
    }
  }
  busy_ = true;
  emit offerChanged();
  autosave_.post([this, work, stamp = edits_.stamp()](HistoryFile&) {
    const auto found = std::make_shared<base::Result<Found>>(read(work, stamp));
    answers_.post([this, work, found] { adopt(work, std::move(*found)); });
  });
}

void RecoveryController::restoreOpen(const LostWork& work) {
  if (!autosave_.lost()) return drop(work);
  const LostEdits lost = *autosave_.lost();
  edits_.returnTo(lost.state);
  if (lost.drag) edits_.apply(editing::finished(lost.drag->model, recoveredLabel(*lost.drag)));
  autosave_.settleLost();
  drop(work);
  say(work);
}

base::Result<RecoveryController::Found> RecoveryController::read(const LostWork& work, const editing::Stamp& stamp) {
  TACTUS_TRY(auto kept, HistoryFile::read(work.source, true));
  Found out{std::move(kept.kept), {}};
  if (isStudyPath(work.document)) return out;
  TACTUS_TRY(auto history, editing::wholeHistory(out.kept, study::RecordIds(), stamp));
  out.history = std::move(history);
  return out;
}

void RecoveryController::adopt(const LostWork& work, base::Result<Found> found) {
  busy_ = false;
  if (!found) {
    put_off_.push_back(work);
    drop(work);
    emit notRestored(tr("The edits of %1 were not restored. Their files stay in place. %2")
                         .arg(shownFileName(work.document), text(found.error().message())),
                     work);
    return;
  }
  if (found->history) {
    begin(work, std::move(*found->history));
  } else if (const auto gone_on = goOn(found->kept); !gone_on) {
    put_off_.push_back(work);
    drop(work);
    emit notRestored(tr("The edits of %1 were not restored. Their files stay in place. %2")
                         .arg(shownFileName(work.document), text(gone_on.error().message())),
                     work);
    return;
  }
  replaced_.push_back({work, autosave_.flush()});
  drop(work);
  say(work);
}

void RecoveryController::begin(const LostWork& work, editing::EditHistory history) {
  if (!models_.current() || models_.current()->path != work.document) {
    if (auto open = readOpenModel(work.document)) {
      models_.openRead(std::move(*open));
    } else {
      // The file is gone or damaged; the history has every state of it.
      OpenModel from_history(history.ready());
      from_history.path = work.document;
      from_history.simulated = saysSimulated(from_history.model);
      models_.openUnsaved(std::move(from_history));
    }
  }
  edits_.adopt(std::move(history));
}

// The study has everything but the last moments, which follow as edits of what it has.
base::Result<void> RecoveryController::goOn(const editing::KeptVersions& kept) {
  const auto show = [&](const fuzzy::ForceModel& model, const std::string& label) {
    if (!editing::sameBits(model, edits_.model())) edits_.apply(editing::finished(model, label));
  };
  const auto known = edits_.history().events();
  struct Missing {
    const study::ModelVersion* version;
    fuzzy::ForceModel model;
  };
  // All of them are read before the first is shown: a newer Tactus may have written them.
  std::vector<Missing> missing;
  for (const study::ModelVersion& version : kept.versions) {
    const bool stored =
        std::any_of(known.begin(), known.end(), [&](const editing::Event& event) { return event.id == version.id; });
    if (stored) continue;
    TACTUS_TRY(auto read, model_io::parseModel(version.text, "autosave"));
    missing.push_back({&version, std::move(read.model)});
  }
  for (const auto& [one, model] : missing) {
    const study::ModelVersion& version = *one;
    const auto colon = version.label.find(": ");
    const std::string kind = version.label.substr(0, colon);
    const std::string label = colon == std::string::npos ? version.label : version.label.substr(colon + 2);
    show(model, label);
    if (kind == editing::name(editing::EventKind::kSnapshot)) edits_.snapshot(text(label));
    if (kind == editing::name(editing::EventKind::kSignOff)) edits_.repeatSignOff(text(version.author), label);
  }
  if (kept.unfinished) show(kept.unfinished->model, recoveredLabel(*kept.unfinished));
  return {};
}

// An autosave that was begun before the work was restored does not hold it.
void RecoveryController::onWritten(quint64 number) {
  for (const Replaced& replaced : replaced_) {
    if (replaced.number > number) continue;
    if (isStudyPath(replaced.work.document)) {
      autosave_.post([path = replaced.work.source](HistoryFile&) { HistoryFile::discard(path); });
    }
  }
  std::erase_if(replaced_, [number](const Replaced& replaced) { return replaced.number <= number; });
}

void RecoveryController::discard() {
  if (offered_.empty()) return;
  const LostWork work = offered_.front();
  discardWork(work);
}

void RecoveryController::discardWork(const LostWork& work) {
  if (busy_) return;
  drop(work);
  if (work.where == Where::kOpenDocument) return autosave_.settleLost();
  const auto fail = [this, work](const base::Error& error) {
    answers_.post([this, work, sentence = text(error.message())] {
      emit notDiscarded(tr("The edits of %1 were not discarded. %2").arg(shownFileName(work.document), sentence), work);
    });
  };
  autosave_.post([work, fail, stamp = edits_.stamp()](HistoryFile&) {
    if (isStudyPath(work.document) || !QFileInfo::exists(work.document)) {
      HistoryFile::discard(work.source);
    } else if (const auto settled = HistoryFile::settle(work.source, modelSha256(work.document), stamp); !settled) {
      fail(settled.error());
    }
  });
}

void RecoveryController::later() {
  if (busy_ || offered_.empty()) return;
  const LostWork work = offered_.front();
  put_off_.push_back(work);
  drop(work);
}

void RecoveryController::drop(const LostWork& work) {
  std::erase_if(offered_, [&](const LostWork& other) { return other.source == work.source || other == work; });
  emit offerChanged();
}

std::string RecoveryController::recoveredLabel(const editing::Unfinished& drag) {
  return tr("%1 (recovered)").arg(text(drag.label)).toStdString();
}

void RecoveryController::say(const LostWork& work) {
  emit restored(tr("Restored: %1, edits: %2, with their history.").arg(shownFileName(work.document)).arg(work.edits));
}

}  // namespace tactus::workbench
