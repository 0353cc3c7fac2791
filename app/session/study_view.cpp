#include "app/session/study_view.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/session/judged_forces.h"
#include "app/session/session_settings.h"
#include "app/session/session_state.h"
#include "app/session/setup_certificate.h"
#include "app/session/study_procedure.h"
#include "core/base/check.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_file.h"
#include "core/store/study_info.h"
#include "core/study/session_records.h"
#include "experiments/force_protocol.h"
#include "experiments/stroke.h"
#include "experiments/stroke_speeds.h"
#include "questionnaires/questionnaire.h"

namespace tactus::session {

// Decides which session counts if a participant did a block of the elicitation more than once.
// A block is a part of the elicitation that is compared between sessions as a whole:
//   S1 did the speed level `slow` in session 1 (complete) and session 2 (aborted): session 1 counts.

/// One block: a speed level, a force series, a form, or the rules.
struct ElicitedBlock {
  enum class Kind { kSpeedLevel, kForceSeries, kForm, kRules };
  Kind kind = Kind::kRules;
  std::string id;  ///< of the level, series or form; empty for rules

  auto operator<=>(const ElicitedBlock&) const = default;
};

/// `the speed 'slow'`, `the rules`.
std::string text(const ElicitedBlock& block);

/// The records of a block in one session.
struct BlockInSession {
  study::SessionRecord session;
  std::size_t scored = 0;  ///< number of records that elicitation uses: accepted strokes, scored judgements, answers,
                           ///< rules
  bool complete = false;
};

/// Whether `scored` records are all that the session planned for the block: the strokes of the level; the steps of the
/// series up to its end; a reply to each item of the form. Imported tables and rules are always complete. False for a
/// session with an unreadable plan. Errors: of reading the file.
base::Result<bool> isComplete(const store::StudyFile& file, const study::SessionRecord& session,
                              const ElicitedBlock& block, std::size_t scored);

/// The index in `sessions` (in the order of session_state.h) of the session that counts: the latest complete one; if
/// none is complete, the one with the most scored records, and of several such the latest. `sessions` must not be
/// empty.
std::size_t countedSession(std::span<const BlockInSession> sessions);

/// The sentence that names the session that counts and the others.
std::string note(const std::string& participant, const ElicitedBlock& block, std::span<const BlockInSession> sessions);

namespace {

using base::Result;
using BlockKind = ElicitedBlock::Kind;

/// The series in the order of the force experiment, or a place behind all of them.
std::size_t placeOf(const std::string& series) {
  constexpr std::array<const char*, 4> kOrder = {experiments::kFamiliarisation, experiments::kAscending,
                                                 experiments::kDescending, experiments::kRandom};
  return static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), series) - kOrder.begin());
}

Result<bool> isSeriesDone(const store::StudyFile& file, const study::SessionRecord& session,
                          const SessionSettings& settings, const std::string& series) {
  TACTUS_TRY(const auto judgements, store::judgements(file, {{}, session.id, true}));
  const auto protocol =
      experiments::ForceProtocol::create(settings.force, blockSeed(session.seed, Block::kForce), judgements);
  if (!protocol) return false;
  const auto plan = protocol->next();
  return plan.finished || placeOf(plan.step.series) > placeOf(series);
}

Result<bool> isFormDone(const store::StudyFile& file, const study::SessionRecord& session, const std::string& form) {
  TACTUS_TRY(const auto procedure, procedureIn(file));
  const auto worded = questionnaires::questionnaire(procedure::orDefault(procedure), form, session.language);
  if (!worded) return false;
  TACTUS_TRY(const auto answers, store::answers(file, {{}, session.id, false}));
  std::set<int> items;
  for (const auto& answer : answers) {
    if (answer.form == form && answer.status != study::Answer::Status::kCleared) items.insert(answer.item);
  }
  return items.size() >= worded->questions.size();
}

std::string sessionText(const BlockInSession& one) {
  using std::chrono::milliseconds;
  const std::chrono::system_clock::time_point started{milliseconds(one.session.started.utc_ms)};
  return "the one of " + base::formatUtc(started) + " (" +
         (one.session.kind == study::SessionKind::kImport ? "imported"
          : one.complete                                  ? "complete"
                                                          : "not complete") +
         ", records " + std::to_string(one.scored) + ", session " + toText(one.session.id).substr(0, 8) + ")";
}

}  // namespace

std::string text(const ElicitedBlock& block) {
  switch (block.kind) {
    case BlockKind::kSpeedLevel: return "the speed " + base::quoted(block.id);
    case BlockKind::kForceSeries: return "the series " + base::quoted(block.id);
    case BlockKind::kForm: return "the form " + base::quoted(block.id);
    case BlockKind::kRules: return "the rules";
  }
  return {};
}

Result<bool> isComplete(const store::StudyFile& file, const study::SessionRecord& session, const ElicitedBlock& block,
                        std::size_t scored) {
  if (session.kind == study::SessionKind::kImport || block.kind == BlockKind::kRules) return true;
  const auto settings = parseSessionSettings(session.settings);
  if (!settings || session.settings.empty()) return false;
  switch (block.kind) {
    case BlockKind::kSpeedLevel: return scored >= static_cast<std::size_t>(std::max(settings->speed.strokes, 0));
    case BlockKind::kForceSeries: return isSeriesDone(file, session, *settings, block.id);
    case BlockKind::kForm: return isFormDone(file, session, block.id);
    case BlockKind::kRules: break;
  }
  return true;
}

std::size_t countedSession(std::span<const BlockInSession> sessions) {
  TACTUS_CHECK(!sessions.empty());
  std::size_t best = 0;
  for (std::size_t i = 1; i < sessions.size(); ++i) {
    const BlockInSession& one = sessions[i];
    const bool counts = one.complete || (!sessions[best].complete && one.scored >= sessions[best].scored);
    if (counts) best = i;
  }
  return best;
}

std::string note(const std::string& participant, const ElicitedBlock& block, std::span<const BlockInSession> sessions) {
  const std::size_t counted = countedSession(sessions);
  std::string others;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (i != counted) others += (others.empty() ? "" : ", ") + sessionText(sessions[i]);
  }
  return participant + " did " + text(block) + " in more than one session: " + sessionText(sessions[counted]) +
         " counts, not " + others + ".";
}

namespace {

using base::Result;
using study::RecordId;

/// Whose a session is, and its place among the sessions of the person.
struct Visit {
  RecordId person;
  std::size_t place = 0;
  study::SessionRecord session;
};

/// What kind of record a note of a device without force is about.
struct WithoutForce {
  std::size_t strokes = 0;
  std::size_t judgements = 0;
  bool strokes_count = false;  ///< the protocol accepts them
};

/// Sessions that elicitation reads.
using Visits = std::map<RecordId, Visit>;

class StudyReader {
 public:
  explicit StudyReader(const store::StudyFile& file) : file_(file) {}

  Result<StudyView> read() {
    if (auto distinct = store::requireDistinctCodes(file_); !distinct) return tl::unexpected(distinct.error());
    TACTUS_TRY(const auto info, store::studyInfo(file_));
    view_.study.name = info.name;
    TACTUS_TRY(view_.study.procedure, procedureIn(file_));
    using Step = Result<void> (StudyReader::*)();
    for (const Step step : {&StudyReader::addParticipants, &StudyReader::addSpeeds, &StudyReader::addJudgements,
                            &StudyReader::addAnswers, &StudyReader::addRules, &StudyReader::addNotes}) {
      if (auto ok = (this->*step)(); !ok) return tl::unexpected(base::inFile(ok.error(), file_.path()));
    }
    return std::move(view_);
  }

 private:
  Result<void> addParticipants() {
    TACTUS_TRY(const auto persons, store::persons(file_));
    TACTUS_TRY(const auto sessions, store::sessions(file_));
    TACTUS_TRY(auto profiles, store::profiles(file_));

    // Who only felt models, such as the researcher, is no participant of the elicitation.
    std::map<RecordId, bool> only_felt;
    for (const auto& session : sessions) {
      const bool felt = session.kind == study::SessionKind::kUsability;
      const auto [it, is_new] = only_felt.try_emplace(session.person, felt);
      it->second = it->second && felt;
    }
    for (const auto& person : persons) {
      if (const auto it = only_felt.find(person.id); it != only_felt.end() && it->second) continue;
      place_of_[person.id] = view_.study.participants.size();
      study::Participant participant;
      participant.code = person.code;
      participant.simulated = person.simulated;
      view_.study.participants.push_back(std::move(participant));
    }
    std::map<RecordId, Visit> all;
    for (const auto& [person, place] : place_of_) {
      codes_[person] = view_.study.participants[place].code;
      TACTUS_TRY(const auto ordered, sessionsInOrder(file_, person));
      for (std::size_t i = 0; i < ordered.size(); ++i) {
        const auto& session = ordered[i];
        all[session.id] = {person, i, session};
        if (session.kind == study::SessionKind::kUsability) continue;
        visits_[session.id] = all[session.id];
        auto& participant = view_.study.participants[place];
        if (participant.simulated || participant.setup_unchecked) continue;
        TACTUS_TRY(const bool unchecked, isWithoutSetup(file_, session));
        participant.setup_unchecked = unchecked;
      }
    }
    std::erase_if(profiles, [&](const auto& profile) { return !all.contains(profile.entry.session); });
    std::stable_sort(profiles.begin(), profiles.end(), [&](const auto& a, const auto& b) {
      return all.at(a.entry.session).place < all.at(b.entry.session).place;
    });
    for (const auto& profile : profiles) {  // the latest holds
      auto& participant = view_.study.participants[place_of_.at(all.at(profile.entry.session).person)];
      participant.years_experience = profile.years_experience;
      participant.category = profile.category;
      participant.handedness = profile.handedness;
      participant.weight = profile.weight;
    }
    return {};
  }

  /// The session of a real person on a device that gives no force.
  bool isWithoutForce(const study::Entry& entry) const {
    const auto visit = visits_.find(entry.session);
    if (visit == visits_.end() || givesForce(visit->second.session.device)) return false;
    return !view_.study.participants[place_of_.at(visit->second.person)].simulated;
  }

  WithoutForce& withoutForce(const study::Entry& entry) {
    const RecordId& person = visits_.at(entry.session).person;
    view_.study.participants[place_of_.at(person)].virtual_device = true;
    return without_force_[person];
  }

  bool acceptsStrokes(const study::Entry& entry) const {
    const auto settings = parseSessionSettings(visits_.at(entry.session).session.settings);
    return settings && settings->virtual_strokes == VirtualStrokes::kAccepted;
  }

  /// Strokes on a device without force are practice, unless the protocol accepts them.
  void leaveOutWithoutForce(std::vector<study::StrokeRecord>& strokes) {
    std::erase_if(strokes, [&](const study::StrokeRecord& stroke) {
      if (stroke.verdict != name(experiments::StrokeVerdict::kAccepted) || !isWithoutForce(stroke.entry)) return false;
      WithoutForce& of_person = withoutForce(stroke.entry);
      ++of_person.strokes;
      of_person.strokes_count = of_person.strokes_count || acceptsStrokes(stroke.entry);
      return !acceptsStrokes(stroke.entry);
    });
  }

  /// A force that was not delivered was not judged, whatever was said.
  void leaveOutWithoutForce(std::vector<study::JudgementRecord>& judgements) {
    std::erase_if(judgements, [&](const study::JudgementRecord& judgement) {
      if (judgement.kind == study::ForceJudgement::Kind::kNoAnswer || !isWithoutForce(judgement.entry)) return false;
      ++withoutForce(judgement.entry).judgements;
      return true;
    });
  }

  Result<void> addNotes() {
    for (const auto& [person, found] : without_force_) {
      const std::string start = "VIRTUAL: " + codes_.at(person) + " moved a device that gives no force. ";
      std::string counts;
      if (found.judgements > 0) {
        counts += std::to_string(found.judgements) + (found.judgements == 1 ? " judgement was" : " judgements were") +
                  " not delivered to the hand and not counted";
      }
      if (found.strokes > 0) {
        counts +=
            (counts.empty() ? "" : "; ") + std::to_string(found.strokes) +
            (found.strokes == 1 ? " stroke" : " strokes") +
            (found.strokes_count ? " counted, because the protocol says virtual = accepted" : " taken as practice");
      }
      view_.notes.push_back(start + counts + '.');
    }
    return {};
  }

  Result<void> addSpeeds() {
    TACTUS_TRY(auto strokes, store::strokes(file_, {}, store::Recordings::kLeaveOut));
    leaveOutWithoutForce(strokes);
    std::erase_if(strokes, [](const study::StrokeRecord& stroke) {
      return stroke.practice || stroke.verdict != name(experiments::StrokeVerdict::kAccepted);
    });
    const auto level = [](const study::StrokeRecord& stroke) {
      return ElicitedBlock{ElicitedBlock::Kind::kSpeedLevel, stroke.level};
    };
    auto counted = ofCountedSession(std::move(strokes), level, [](const auto&) { return true; });
    if (!counted) return tl::unexpected(counted.error());
    for (auto& stroke : *counted) {
      TACTUS_TRY(auto recording, store::recordingOf(file_, stroke.entry.id));
      stroke.recording = std::move(recording);
      TACTUS_TRY(const auto samples, speedSamples(stroke, codeOf(stroke.entry)));
      view_.stroke_ids.push_back(stroke.entry.id);
      view_.study.speeds.insert(view_.study.speeds.end(), samples.begin(), samples.end());
    }
    return {};
  }

  Result<void> addJudgements() {
    TACTUS_TRY(auto judgements, store::judgements(file_));
    leaveOutWithoutForce(judgements);
    std::erase_if(judgements,
                  [](const study::JudgementRecord& judgement) { return !judgement.scored || judgement.catch_trial; });
    const auto series = [](const study::JudgementRecord& judgement) {
      return ElicitedBlock{ElicitedBlock::Kind::kForceSeries, judgement.series};
    };
    auto counted = ofCountedSession(std::move(judgements), series, [](const auto&) { return true; });
    if (!counted) return tl::unexpected(counted.error());
    for (auto& judgement : *counted) {
      study::ForceJudgement out;
      out.participant = codeOf(judgement.entry);
      out.series = judgement.series;
      out.step = judgement.step;
      out.force_n = judgement.commanded_n;
      out.kind = judgement.kind;
      out.term = std::move(judgement.term);
      view_.study.judgements.push_back(std::move(out));
      view_.judgement_ids.push_back(judgement.entry.id);
    }
    return {};
  }

  Result<void> addAnswers() {
    TACTUS_TRY(auto answers, store::answers(file_));
    const auto form = [](const study::AnswerRecord& answer) {
      return ElicitedBlock{ElicitedBlock::Kind::kForm, answer.form};
    };
    const auto is_answered = [](const study::AnswerRecord& answer) {
      return answer.status == study::Answer::Status::kAnswered;
    };
    TACTUS_TRY(auto counted, ofCountedSession(std::move(answers), form, is_answered));
    for (auto& answer : counted) {
      study::Answer out;
      out.participant = codeOf(answer.entry);
      out.form = std::move(answer.form);
      out.item = answer.item;
      out.term = std::move(answer.value);
      out.status = answer.status;
      out.wording = std::move(answer.wording);
      view_.study.answers.push_back(std::move(out));
      view_.answer_ids.push_back(answer.entry.id);
    }
    return {};
  }

  Result<void> addRules() {
    TACTUS_TRY(auto rules, store::rules(file_));
    const auto all = [](const study::RuleRecord&) { return ElicitedBlock{}; };
    auto counted = ofCountedSession(std::move(rules), all, [](const auto&) { return true; });
    if (!counted) return tl::unexpected(counted.error());
    for (auto& record : *counted) {
      record.rule.participant = codeOf(record.entry);
      view_.study.rules.push_back(std::move(record.rule));
      view_.rule_ids.push_back(record.entry.id);
    }
    return {};
  }

  const std::string& codeOf(const study::Entry& entry) const { return codes_.at(visits_.at(entry.session).person); }

  /// Of each block (what `block` calls a participant's part of a kind) the records of the session that counts,
  /// participant after participant by code. `is_scored` tells the records by which sessions are compared.
  template <class Record, class Block, class IsScored>
  Result<std::vector<Record>> ofCountedSession(std::vector<Record> records, Block block, IsScored is_scored) {
    std::erase_if(records, [&](const Record& record) { return !visits_.contains(record.entry.session); });
    // For each person and block: its sessions by their place.
    std::map<std::pair<RecordId, ElicitedBlock>, std::map<std::size_t, BlockInSession>> found;
    const auto key = [&](const Record& record) {
      return std::pair(visits_.at(record.entry.session).person, block(record));
    };
    for (const auto& record : records) {
      const Visit& visit = visits_.at(record.entry.session);
      auto& one = found[key(record)][visit.place];
      one.session = visit.session;
      one.scored += is_scored(record) ? 1 : 0;
    }
    std::map<std::pair<RecordId, ElicitedBlock>, RecordId> counted;
    std::vector<std::pair<std::string, std::string>> notes;  // with the code, by which they are sorted
    for (const auto& [what, by_place] : found) {
      std::vector<BlockInSession> sessions;
      for (const auto& [place, one] : by_place) sessions.push_back(one);
      if (sessions.size() > 1) {
        for (auto& one : sessions) {
          TACTUS_TRY(const auto complete, isComplete(file_, one.session, what.second, one.scored));
          one.complete = complete;
        }
        const std::string& code = codes_.at(what.first);
        notes.emplace_back(code, note(code, what.second, sessions));
      }
      counted[what] = sessions[countedSession(sessions)].session.id;
    }
    std::stable_sort(notes.begin(), notes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [code, sentence] : notes) view_.notes.push_back(std::move(sentence));
    std::erase_if(records, [&](const Record& record) { return counted.at(key(record)) != record.entry.session; });
    std::stable_sort(records.begin(), records.end(),
                     [&](const Record& a, const Record& b) { return codeOf(a.entry) < codeOf(b.entry); });
    return records;
  }

  const store::StudyFile& file_;
  Visits visits_;
  std::map<RecordId, std::string> codes_;     ///< of the participants
  std::map<RecordId, std::size_t> place_of_;  ///< of the participants, in the study
  std::map<RecordId, WithoutForce> without_force_;
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

Result<StudyView> studyForElicitation(const store::StudyFile& file) { return StudyReader(file).read(); }

}  // namespace tactus::session
