#include "app/session/study_view.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/recoding.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "experiments/stroke.h"
#include "experiments/stroke_speeds.h"

namespace tactus::session {
namespace {

using base::Result;
using study::RecordId;

/// Which participant a session is of; sessions that elicitation does not read are absent.
using CodeOfSession = std::map<RecordId, std::string>;

/// Of each block (what `block` calls a participant's part of a kind) the records of the latest session, participant
/// after participant by code. The records come session after session.
template <class Record, class Block>
std::vector<Record> ofLatestSession(std::vector<Record> records, const CodeOfSession& codes, Block block,
                                    std::vector<std::string>& notes) {
  std::map<std::pair<std::string, std::string>, RecordId> latest;
  std::set<std::pair<std::string, std::string>> repeated;
  const auto key = [&](const Record& record) { return std::pair(codes.at(record.entry.session), block(record)); };
  std::erase_if(records, [&](const Record& record) { return !codes.contains(record.entry.session); });
  for (const auto& record : records) {
    const auto [it, is_new] = latest.try_emplace(key(record), record.entry.session);
    if (!is_new && it->second != record.entry.session) repeated.insert(it->first);
    it->second = record.entry.session;
  }
  std::erase_if(records, [&](const Record& record) { return latest.at(key(record)) != record.entry.session; });
  std::stable_sort(records.begin(), records.end(), [&](const Record& a, const Record& b) {
    return codes.at(a.entry.session) < codes.at(b.entry.session);
  });
  for (const auto& [participant, what] : repeated) {
    notes.push_back(participant + " did " + what + " in more than one session; the latest counts.");
  }
  return records;
}

class Reader {
 public:
  explicit Reader(const store::StudyFile& file) : file_(file) {}

  Result<StudyView> read() {
    if (auto distinct = store::requireDistinctCodes(file_); !distinct) return tl::unexpected(distinct.error());
    const auto info = store::studyInfo(file_);
    if (!info) return tl::unexpected(info.error());
    view_.study.name = info->name;
    using Step = Result<void> (Reader::*)();
    for (const Step step : {&Reader::addParticipants, &Reader::addSpeeds, &Reader::addJudgements, &Reader::addAnswers,
                            &Reader::addRules}) {
      if (auto ok = (this->*step)(); !ok) return tl::unexpected(base::inFile(ok.error(), file_.path()));
    }
    return std::move(view_);
  }

 private:
  Result<void> addParticipants() {
    const auto persons = store::persons(file_);
    if (!persons) return tl::unexpected(persons.error());
    const auto sessions = store::sessions(file_);
    if (!sessions) return tl::unexpected(sessions.error());
    const auto profiles = store::profiles(file_);
    if (!profiles) return tl::unexpected(profiles.error());

    // Who only felt models, such as the researcher, is no participant of the elicitation.
    std::map<RecordId, bool> only_felt;
    for (const auto& session : *sessions) {
      const bool felt = session.kind == study::SessionKind::kUsability;
      const auto [it, is_new] = only_felt.try_emplace(session.person, felt);
      it->second = it->second && felt;
    }
    std::map<RecordId, std::size_t> place_of;
    for (const auto& person : *persons) {
      if (const auto it = only_felt.find(person.id); it != only_felt.end() && it->second) continue;
      place_of[person.id] = view_.study.participants.size();
      study::Participant participant;
      participant.code = person.code;
      participant.simulated = person.simulated;
      view_.study.participants.push_back(std::move(participant));
    }
    std::map<RecordId, std::size_t> participant_of_session;
    for (const auto& session : *sessions) {
      if (!place_of.contains(session.person)) continue;
      const std::size_t place = place_of.at(session.person);
      participant_of_session[session.id] = place;
      if (session.kind != study::SessionKind::kUsability) codes_[session.id] = view_.study.participants[place].code;
    }
    for (const auto& profile : *profiles) {  // the latest holds
      if (!participant_of_session.contains(profile.entry.session)) continue;
      auto& participant = view_.study.participants[participant_of_session.at(profile.entry.session)];
      participant.years_experience = profile.years_experience;
      participant.category = profile.category;
      participant.handedness = profile.handedness;
      participant.weight = profile.weight;
    }
    return {};
  }

  Result<void> addSpeeds() {
    auto strokes = store::strokes(file_, {}, store::Recordings::kLeaveOut);
    if (!strokes) return tl::unexpected(strokes.error());
    std::erase_if(*strokes, [](const study::StrokeRecord& stroke) {
      return stroke.practice || stroke.verdict != name(experiments::StrokeVerdict::kAccepted);
    });
    const auto level = [](const study::StrokeRecord& stroke) { return "the speed " + base::quoted(stroke.level); };
    for (auto& stroke : ofLatestSession(std::move(*strokes), codes_, level, view_.notes)) {
      auto recording = store::recordingOf(file_, stroke.entry.id);
      if (!recording) return tl::unexpected(recording.error());
      stroke.recording = std::move(*recording);
      const auto samples = speedSamples(stroke, codes_.at(stroke.entry.session));
      if (!samples) return tl::unexpected(samples.error());
      view_.study.speeds.insert(view_.study.speeds.end(), samples->begin(), samples->end());
    }
    return {};
  }

  Result<void> addJudgements() {
    auto judgements = store::judgements(file_);
    if (!judgements) return tl::unexpected(judgements.error());
    std::erase_if(*judgements,
                  [](const study::JudgementRecord& judgement) { return !judgement.scored || judgement.catch_trial; });
    const auto series = [](const study::JudgementRecord& judgement) {
      return "the series " + base::quoted(judgement.series);
    };
    for (auto& judgement : ofLatestSession(std::move(*judgements), codes_, series, view_.notes)) {
      study::ForceJudgement out;
      out.participant = codes_.at(judgement.entry.session);
      out.series = judgement.series;
      out.step = judgement.step;
      out.force_n = judgement.commanded_n;
      out.kind = judgement.kind;
      out.term = std::move(judgement.term);
      view_.study.judgements.push_back(std::move(out));
    }
    return {};
  }

  Result<void> addAnswers() {
    auto answers = store::answers(file_);
    if (!answers) return tl::unexpected(answers.error());
    const auto form = [](const study::AnswerRecord& answer) { return "the form " + base::quoted(answer.form); };
    for (auto& answer : ofLatestSession(std::move(*answers), codes_, form, view_.notes)) {
      study::Answer out;
      out.participant = codes_.at(answer.entry.session);
      out.form = std::move(answer.form);
      out.item = answer.item;
      out.term = std::move(answer.value);
      out.status = answer.status;
      view_.study.answers.push_back(std::move(out));
    }
    return {};
  }

  Result<void> addRules() {
    auto rules = store::rules(file_);
    if (!rules) return tl::unexpected(rules.error());
    const auto all = [](const study::RuleRecord&) { return std::string("the rules"); };
    for (auto& record : ofLatestSession(std::move(*rules), codes_, all, view_.notes)) {
      record.rule.participant = codes_.at(record.entry.session);
      view_.study.rules.push_back(std::move(record.rule));
    }
    return {};
  }

  const store::StudyFile& file_;
  CodeOfSession codes_;
  StudyView view_;
};

}  // namespace

Result<std::vector<study::SpeedSample>> speedSamples(const study::StrokeRecord& stroke,
                                                     const std::string& participant) {
  const auto motion = experiments::strokeMotion(stroke);
  if (!motion) {
    auto error = motion.error();
    error.place = participant + ", " + error.place;
    return tl::unexpected(std::move(error));
  }
  std::vector<study::SpeedSample> samples;
  samples.reserve(motion->size());
  for (const auto& at : *motion) {
    samples.push_back({participant, stroke.level, stroke.number, at.time_s, at.depth_mm, at.speed_mm_s});
  }
  return samples;
}

Result<StudyView> studyForElicitation(const store::StudyFile& file) { return Reader(file).read(); }

}  // namespace tactus::session
