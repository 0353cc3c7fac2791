// The record of one participant, in the order in which it was stored.
#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <map>
#include <set>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/study_overview.h"
#include "core/store/entries.h"
#include "core/store/sessions.h"
#include "core/store/words.h"
#include "experiments/force_series.h"

namespace tactus::workbench {
namespace {

using base::Result;

struct RecordWords {
  Q_DECLARE_TR_FUNCTIONS(RecordWords)
};

QString profileText(const study::ProfileRecord& profile) {
  QStringList parts;
  if (profile.years_experience)
    parts << RecordWords::tr("%1 years of experience").arg(numberText(*profile.years_experience));
  if (!profile.category.empty()) parts << spelled(profile.category);
  if (!profile.handedness.empty()) parts << RecordWords::tr("hand: %1").arg(spelled(profile.handedness));
  if (!profile.gloves.empty()) parts << RecordWords::tr("gloves: %1").arg(spelled(profile.gloves));
  if (!profile.haptic_experience.empty())
    parts << RecordWords::tr("haptic devices: %1").arg(spelled(profile.haptic_experience));
  if (!profile.comfort.empty()) parts << RecordWords::tr("comfort: %1").arg(spelled(profile.comfort));
  if (profile.weight) parts << RecordWords::tr("weight: %1").arg(numberText(*profile.weight));
  return parts.isEmpty() ? RecordWords::tr("nothing said") : parts.join(QStringLiteral(", "));
}

class Collector {
 public:
  Collector(const store::StudyFile& file, const study::RecordId& person) : file_(file), all_{person, {}, true} {}

  Result<std::vector<RecordLine>> read() {
    using Step = Result<void> (Collector::*)();
    for (const Step step :
         {&Collector::readSessions, &Collector::addStrokes, &Collector::addJudgements, &Collector::addRest}) {
      if (auto ok = (this->*step)(); !ok) return tl::unexpected(ok.error());
    }
    for (const auto& [corrected, line] : corrected_) {
      for (const std::size_t i : places_[corrected]) lines_[i].remark = RecordWords::tr("corrected later");
    }
    std::stable_sort(lines_.begin(), lines_.end(), [](const RecordLine& one, const RecordLine& other) {
      return std::pair(one.session, one.sequence) < std::pair(other.session, other.sequence);
    });
    return std::move(lines_);
  }

 private:
  Result<void> readSessions() {
    TACTUS_TRY(const auto sessions, store::sessions(file_));
    std::vector<study::SessionRecord> own;
    for (const auto& session : sessions) {
      if (session.person == *all_.person) own.push_back(session);
    }
    std::stable_sort(own.begin(), own.end(),
                     [](const auto& a, const auto& b) { return a.started.utc_ms < b.started.utc_ms; });
    for (const auto& session : own) numbers_.emplace(session.id, static_cast<int>(numbers_.size()) + 1);
    TACTUS_TRY(auto sequences, store::sequences(file_));
    sequences_ = std::move(sequences);
    return {};
  }

  void add(const study::Entry& entry, const QString& part, const QString& asked, const QString& said,
           const QString& remark = {}) {
    RecordLine line;
    const auto number = numbers_.find(entry.session);
    line.session = number == numbers_.end() ? 0 : number->second;
    line.id = entry.id;
    line.utc_ms = entry.when.utc_ms;
    line.sequence = sequences_[entry.id];
    line.part = part;
    line.asked = asked;
    line.said = said;
    line.remark = remark;
    if (entry.supersedes) {
      corrected_.emplace(*entry.supersedes, lines_.size());
      const QString why = text(entry.reason);
      line.remark = why.isEmpty() ? RecordWords::tr("a correction") : RecordWords::tr("a correction: %1").arg(why);
    }
    places_[entry.id].push_back(lines_.size());
    lines_.push_back(std::move(line));
  }

  Result<void> addStrokes() {
    TACTUS_TRY(const auto strokes, store::strokes(file_, all_, store::Recordings::kLeaveOut));
    for (const auto& one : strokes) {
      add(one.entry, RecordWords::tr("Speed"),
          one.practice ? RecordWords::tr("%1, practice %2").arg(spelled(one.level)).arg(one.number)
                       : RecordWords::tr("%1, insertion %2").arg(spelled(one.level)).arg(one.number),
          spelled(one.verdict));
    }
    return {};
  }

  Result<void> addJudgements() {
    TACTUS_TRY(const auto judgements, store::judgements(file_, all_));
    for (const auto& one : judgements) {
      const QString word =
          one.kind == study::ForceJudgement::Kind::kTerm ? spelled(one.term) : spelled(store::wordFor(one.kind));
      const QString remark = one.series == experiments::kFamiliarisation ? RecordWords::tr("practice")
                             : !one.scored                               ? RecordWords::tr("not counted")
                             : one.catch_trial                           ? RecordWords::tr("a hidden check")
                                                                         : QString();
      add(one.entry, RecordWords::tr("Forces"),
          RecordWords::tr("%1 %2: %3")
              .arg(spelled(one.series))
              .arg(one.step)
              .arg(quantityText(one.commanded_n, "N", 2)),
          word, remark);
    }
    return {};
  }

  Result<void> addRest() {
    TACTUS_TRY(const auto profiles, store::profiles(file_, all_));
    for (const auto& one : profiles) add(one.entry, RecordWords::tr("Person"), {}, profileText(one));
    TACTUS_TRY(const auto answers, store::answers(file_, all_));
    for (const auto& one : answers) {
      const QString said = one.value.empty() ? spelled(store::wordFor(one.status)) : spelled(one.value);
      add(one.entry, RecordWords::tr("Questions"), RecordWords::tr("item %1 of %2").arg(one.item).arg(text(one.form)),
          said);
    }
    TACTUS_TRY(const auto ratings, store::ratings(file_, all_));
    for (const auto& one : ratings) {
      add(one.entry, RecordWords::tr("Rating"), spelled(one.block),
          RecordWords::tr("effort %1, comfort %2, of 7").arg(one.effort).arg(one.comfort));
    }
    TACTUS_TRY(const auto events, store::events(file_, all_));
    for (const auto& one : events) {
      add(one.entry, RecordWords::tr("Log"), spelled(one.kind), text(one.detail));
      lines_.back().is_log = true;
    }
    return {};
  }

  const store::StudyFile& file_;
  store::Selection all_;
  std::map<study::RecordId, int> numbers_;
  std::map<study::RecordId, std::int64_t> sequences_;
  std::map<study::RecordId, std::vector<std::size_t>> places_;
  std::map<study::RecordId, std::size_t> corrected_;
  std::vector<RecordLine> lines_;
};

}  // namespace

Result<std::vector<RecordLine>> readParticipantRecord(const store::StudyFile& file, const study::RecordId& person) {
  return Collector(file, person).read();
}

}  // namespace tactus::workbench
