#include "app/workbench/labs/data/corrections.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/settings_price.h"
#include "core/store/entries.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {
namespace {

struct InfluenceText {
  Q_DECLARE_TR_FUNCTIONS(InfluenceText)
};

constexpr double kLeastN = 0.0005;         // what is shown as 0.001 N
constexpr double kLeastNoticeable = 0.05;  // what is shown as 0.1

// Not `0 N` for what is more than nothing.
QString forceMoved(double force_n) {
  return force_n > 0 && force_n < kLeastN ? InfluenceText::tr("less than 0.001 N") : quantityText(force_n, "N", 3);
}

QString noticeableText(double noticeable) {
  return noticeable > 0 && noticeable < kLeastNoticeable ? InfluenceText::tr("less than 0.1")
                                                         : numberText(noticeable, 1);
}

}  // namespace

QString movedText(const elicitation::RecordInfluence& moved) {
  const double largest_n = moved.difference.largest_n;
  const QString force =
      largest_n > 0 && largest_n < kLeastN ? InfluenceText::tr("< 0.001 N") : quantityText(largest_n, "N", 3);
  return InfluenceText::tr("%1 (%2 JND)")
      .arg(force, moved.noticeable > 0 && moved.noticeable < kLeastNoticeable ? QStringLiteral("< 0.1")
                                                                              : numberText(moved.noticeable, 1));
}

QString influenceText(const QString& which, const base::Result<elicitation::RecordInfluence>& moved,
                      const fuzzy::ForceModel& model) {
  if (!moved)
    return InfluenceText::tr("%1: without it there is no model: %2").arg(which, text(moved.error().message()));
  const analysis::ForceDifference& found = moved->difference;
  if (found.largest_n == 0) return InfluenceText::tr("%1: without it the averaged force is the same.").arg(which);
  if (found.largest_n < kLeastN) {
    return InfluenceText::tr("%1: without it the averaged force moves by less than 0.001 N everywhere.").arg(which);
  }
  return InfluenceText::tr(
             "%1: without it the averaged force moves by at most %2 (%3 just-noticeable differences), at %4; %5 rms.")
      .arg(which, forceMoved(found.largest_n), noticeableText(moved->noticeable),
           text(elicitation::pointText(model, found.at)), forceMoved(found.rms_n));
}

namespace {

using base::Result;

const study::Entry& entryOf(const Corrections::Record& record) {
  return std::visit([](const auto& one) -> const study::Entry& { return one.entry; }, record);
}

study::Entry& entryOf(Corrections::Record& record) {
  return std::visit([](auto& one) -> study::Entry& { return one.entry; }, record);
}

/// Whether both say the same, whatever their entries are.
bool sameValues(const Corrections::Record& one, Corrections::Record other) {
  entryOf(other) = entryOf(one);
  return one == other;
}

// Runs in the thread of the study.
Result<void> appendCorrection(store::StudyFile& file, study::StrokeRecord record) {
  auto recording = store::recordingOf(file, *record.entry.supersedes);
  if (!recording) return tl::unexpected(recording.error());
  record.recording = std::move(*recording);
  return store::append(file, record);
}

template <class Other>
Result<void> appendCorrection(store::StudyFile& file, const Other& record) {
  return store::append(file, record);
}

}  // namespace

Corrections::Corrections(LabData& data, QObject* parent) : UndoSource(parent), data_(data) {
  connect(&data_.connection(), &StudyConnection::opened, this, &Corrections::forget);
  connect(&data_.connection(), &StudyConnection::closed, this, &Corrections::forget);
  connect(&data_, &LabData::settingsEdited, this, &Corrections::takeSettings);
}

void Corrections::takeSettings(const elicitation::BuildSettings& before, const elicitation::BuildSettings& after) {
  const QString what = settingsChange(before, after);
  if (restoring_ || busy_ || what.isEmpty()) return;
  const auto setting = [](const QString& change) { return change.section(QLatin1Char(' '), 0, 0); };
  steps_.resize(done_);
  Step* const last = steps_.empty() ? nullptr : &steps_.back();
  const bool together = last != nullptr && last->settings && setting(last->what) == setting(what) &&
                        last->settings->since.elapsed() < SettingsPrice::kTogetherMs;
  if (together) {
    last->settings->after = after;
    last->what = settingsChange(last->settings->before, after);
    last->settings->since.start();
    if (last->what.isEmpty()) steps_.pop_back();
  } else {
    Step step;
    step.what = what;
    step.settings = SettingsStep{before, after, {}};
    step.settings->since.start();
    steps_.push_back(std::move(step));
  }
  done_ = steps_.size();
  emit changed();
}

void Corrections::restore(const elicitation::BuildSettings& settings, std::size_t done_after) {
  restoring_ = true;
  data_.setSettings(settings);
  restoring_ = false;
  done_ = done_after;
  emit changed();
}

void Corrections::correct(Record before, Record wanted, const QString& what, const QString& reason) {
  if (busy_ || !data_.connection().takesOrders() || sameValues(before, wanted)) return;
  if (needsSignature(before)) {
    unsigned_ = [=, this] { correct(before, wanted, what, reason); };
    emit signatureAsked(what);
    return;
  }
  const study::RecordId current = entryOf(before).id;
  study::RecordId chain = current;
  for (const auto& [first, newest] : newest_) {
    if (newest == current) chain = first;
  }
  newest_[chain] = current;
  steps_.resize(done_);
  steps_.push_back({chain, before, wanted, what, reason});
  write(chain, wanted, what, reason, done_ + 1, [=, this] { correct(before, wanted, what, reason); });
}

bool Corrections::needsSignature(const Record& record) const {
  if (signed_on_ == QDate::currentDate() || !data_.study()) return false;
  const LabStudy& study = *data_.study();
  const std::string code = study.codeOf(entryOf(record).session);
  return std::any_of(study.persons.begin(), study.persons.end(),
                     [&](const study::Person& one) { return one.code == code && !one.simulated; });
}

void Corrections::sign(const QString& name, const QString& why) {
  signature_ = tr("%1: %2").arg(name.trimmed(), why.trimmed());
  signed_on_ = QDate::currentDate();
  if (const auto again = std::exchange(unsigned_, {})) again();
}

QString Corrections::signedReason(const QString& reason) const {
  if (signed_on_ != QDate::currentDate()) return reason;
  return reason.isEmpty() ? signature_ : reason + QStringLiteral("; ") + signature_;
}

void Corrections::undo() {
  if (!canUndo()) return;
  const Step& step = steps_[done_ - 1];
  if (step.settings) return restore(elicitation::BuildSettings(step.settings->before), done_ - 1);
  if (!data_.connection().takesOrders()) return;
  write(step.chain, step.before, tr("Undone: %1").arg(step.what), QStringLiteral("undo"), done_ - 1,
        [this] { undo(); });
}

void Corrections::redo() {
  if (!canRedo()) return;
  const Step step = steps_[done_];
  if (step.settings) return restore(step.settings->after, done_ + 1);
  if (!data_.connection().takesOrders()) return;
  write(step.chain, step.after, tr("Redone: %1").arg(step.what), step.reason, done_ + 1, [this, step] {
    if (steps_.size() == done_) steps_.push_back(step);
    redo();
  });
}

void Corrections::write(const study::RecordId& chain, Record record, const QString& what, const QString& reason,
                        std::size_t done_after, std::function<void()> again) {
  study::Entry& entry = entryOf(record);
  entry.id = {};
  entry.when = {
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
          .count(),
      0};
  entry.entered_by = study::EnteredBy::kResearcher;
  entry.supersedes = newest_.at(chain);
  entry.reason = signedReason(reason).toStdString();
  busy_ = true;
  const auto id = std::make_shared<std::optional<study::RecordId>>();
  const QString path = data_.connection().path();
  data_.connection().order(
      [id, record = std::move(record)](store::StudyFile& file, study::RecordIds& ids) mutable {
        if (!*id) *id = ids.next();
        entryOf(record).id = **id;
        return std::visit([&file](const auto& one) { return appendCorrection(file, one); }, record);
      },
      [this, id, chain, what, done_after, path] {
        if (path != data_.connection().path()) return;
        newest_[chain] = **id;
        done_ = done_after;
        busy_ = false;
        data_.refresh();
        emit stored(what);
        emit changed();
      },
      [this, path, what, again = std::move(again)](const QString& sentence) {
        if (path != data_.connection().path()) return;
        busy_ = false;
        steps_.resize(done_);
        emit refused(tr("Not stored: %1. %2").arg(what, sentence), {tr("Try again"), again});
        emit changed();
      });
  emit changed();
}

void Corrections::forget() {
  signed_on_ = {};
  unsigned_ = {};
  steps_.clear();
  newest_.clear();
  done_ = 0;
  busy_ = false;
  emit changed();
}

}  // namespace tactus::workbench
