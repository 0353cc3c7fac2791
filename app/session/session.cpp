#include "app/session/session.h"

#include <algorithm>
#include <utility>

#include "app/session/judged_forces.h"
#include "app/session/session_state.h"
#include "app/session/study_procedure.h"
#include "core/base/error.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_records.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr int kLeastRating = 1;
constexpr int kMostRating = 7;

tl::unexpected<base::Error> notNow(std::string what, SessionPart part) {
  return fail(ErrorCode::kValue, "session", std::move(what) + " in the part " + base::quoted(name(part)),
              "a call that fits this part");
}

/// The number of earlier sessions that took a row of the Latin square: those of simulated persons count apart.
int sessionsInTurn(const SessionSettings& settings, const std::vector<study::SessionRecord>& sessions,
                   const std::vector<study::Person>& persons, bool simulated) {
  if (settings.speed.order != experiments::SpeedSettings::Order::kLatinSquare) return 0;
  return static_cast<int>(std::count_if(sessions.begin(), sessions.end(), [&](const study::SessionRecord& session) {
    const auto person =
        std::find_if(persons.begin(), persons.end(), [&](const auto& p) { return p.id == session.person; });
    const auto other = parseSessionSettings(session.settings);
    return person != persons.end() && person->simulated == simulated && other &&
           other->speed.order == settings.speed.order &&
           std::find(other->blocks.begin(), other->blocks.end(), Block::kSpeed) != other->blocks.end();
  }));
}

/// What the log says beside an answer.
std::vector<Note> notesOf(const study::RecordId& record, const std::optional<AnswerInput>& input,
                          std::optional<ResponseMark> mark, std::optional<bool> would_stop = {}) {
  std::vector<Note> out;
  if (input) out.push_back(answerInput(record, *input));
  if (mark) out.push_back(responseMarked(record, *mark));
  if (would_stop) out.push_back(wouldStop(record, *would_stop));
  return out;
}

}  // namespace

SessionTools systemTools() { return {study::momentNow, study::RecordIds()}; }

Session::Session(std::unique_ptr<SessionState> state) : state_(std::move(state)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Result<Session> Session::begin(store::StudyFile& file, const SessionStart& start, SessionTools tools) {
  if (start.consent_version.empty()) {
    return fail(ErrorCode::kValue, "session", "no consent", "the version of the text that the participant agreed to");
  }
  auto settings = start.settings;
  settings.force.device_friction_n = start.device_friction_n;
  settings.force.device_scale = settings.about().device_scale;
  TACTUS_TRY(const auto persons, store::persons(file));
  const auto person =
      std::find_if(persons.begin(), persons.end(), [&](const study::Person& p) { return p.id == start.person; });
  if (person == persons.end()) {
    return fail(ErrorCode::kReference, "session", "an unknown participant", "a participant of this study");
  }

  settings.felt = person->simulated || givesForce(start.device);
  TACTUS_TRY(const auto sessions, store::sessions(file));
  settings.speed.latin_row += sessionsInTurn(settings, sessions, persons, person->simulated);
  if (auto ok = validate(settings); !ok) return tl::unexpected(ok.error());

  if (start.protocol) {
    TACTUS_TRY(const auto state, store::protocolState(file));
    if (!state.current || state.current->id != *start.protocol) {
      return fail(ErrorCode::kReference, "session", "a protocol that does not count",
                  "the latest protocol of the study");
    }
  }

  study::SessionRecord record;
  record.id = tools.ids.next();
  record.protocol = start.protocol;
  record.person = start.person;
  record.kind = start.kind;
  record.started = tools.now();
  record.consent_version = start.consent_version;
  record.seed = start.seed;
  record.language = start.language;
  record.station = start.station;
  record.program = start.program;
  record.device = start.device;
  record.device_friction_n = start.device_friction_n;
  record.settings = toJson(settings);
  auto state = std::make_unique<SessionState>(file, std::move(tools), record);
  state->settings = std::move(settings);
  state->simulated = person->simulated;
  // Everything that can be refused is refused before the session is in the file.
  if (auto ok = state->makeProtocols(file); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto latest, latestSession(file, start.person));
  // The session and the first line of its log are stored together or not at all.
  auto begun = store::inOneBatch(file, [&] {
    return store::append(file, record).and_then([&] { return state->log(kBegan, afterDetail(latest)); });
  });
  if (!begun) return tl::unexpected(begun.error());
  return Session(std::move(state));
}

Result<Session> Session::resume(store::StudyFile& file, const study::RecordId& session, SessionTools tools) {
  TACTUS_TRY(const auto sessions, store::sessions(file));
  const auto record =
      std::find_if(sessions.begin(), sessions.end(), [&](const study::SessionRecord& s) { return s.id == session; });
  if (record == sessions.end()) {
    return fail(ErrorCode::kReference, "session", toText(session), "a session of this study");
  }
  TACTUS_TRY(const auto persons, store::persons(file));
  TACTUS_TRY(auto settings, settingsOf(file, *record));

  auto state = std::make_unique<SessionState>(file, std::move(tools), *record);
  state->settings = std::move(settings);
  for (const auto& person : persons) {
    if (person.id == record->person) state->simulated = person.simulated;
  }
  TACTUS_TRY(const auto events, store::events(file, {{}, record->id, true}));
  if (auto ok = state->readBack(file, events); !ok) return tl::unexpected(ok.error());
  state->announced = state->part();
  if (auto ok = state->log(kResumed, detail("stage", name(state->announced))); !ok) return tl::unexpected(ok.error());
  return Session(std::move(state));
}

SessionPart Session::part() const { return state_->part(); }
std::optional<Block> Session::block() const { return state_->block(); }
const study::SessionRecord& Session::record() const { return state_->record; }
const SessionSettings& Session::settings() const { return state_->settings; }
bool Session::isPaused() const { return state_->paused; }
const experiments::SpeedProtocol* Session::speed() const { return state_->speed ? &*state_->speed : nullptr; }
const experiments::ForceProtocol* Session::force() const { return state_->force ? &*state_->force : nullptr; }
const questionnaires::QuestionnaireRun* Session::form() const { return state_->form ? &*state_->form : nullptr; }
const study::ProfileRecord* Session::profile() const { return state_->profile ? &*state_->profile : nullptr; }
void Session::setEnteredBy(study::EnteredBy who) { state_->entered_by = who; }

std::size_t Session::blocksDone() const {
  const auto at = state_->block();
  const auto& blocks = state_->settings.blocks;
  if (!at) return blocks.size();
  return static_cast<std::size_t>(std::find(blocks.begin(), blocks.end(), *at) - blocks.begin());
}

Result<void> Session::tell(study::ProfileRecord profile) { return state_->tell(std::move(profile), {}); }

Result<void> Session::tell(study::ProfileRecord profile, const ExperienceBand& band) {
  profile.years_experience = band.middle_years;
  return state_->tell(std::move(profile), experienceBandChosen(band));
}

Result<void> Session::note(const Note& note) {
  if (note.kind.empty() || steersSession(note.kind)) {
    return fail(ErrorCode::kValue, "session", "a note of the kind " + base::quoted(note.kind),
                "a kind that does not steer the session");
  }
  return state_->log(note.kind.c_str(), note.detail);
}

Result<void> Session::addStroke(const experiments::Stroke& stroke, study::Recording recording,
                                std::size_t recording_first) {
  if (part() != SessionPart::kSpeed) return notNow("a stroke", part());
  auto record = state_->speed->record(stroke, std::move(recording), recording_first);
  record.entry = state_->entry();
  auto after = *state_->speed;
  if (auto ok = after.add(record); !ok) return ok;
  return state_->store(record, [&] { state_->speed = std::move(after); });
}

Result<void> Session::rejectStroke(const study::RecordId& stroke, const std::string& reason) {
  if (!state_->speed || state_->aborted) return notNow("a stroke taken back", part());
  TACTUS_TRY(const auto strokes,
             store::strokes(state_->file, {{}, state_->record.id, false}, store::Recordings::kLeaveOut));
  const auto it = std::find_if(strokes.begin(), strokes.end(),
                               [&](const study::StrokeRecord& one) { return one.entry.id == stroke; });
  if (it == strokes.end()) {
    return fail(ErrorCode::kReference, "session", "stroke " + toText(stroke), "a stroke of this session");
  }
  TACTUS_TRY(auto recording, store::recordingOf(state_->file, stroke));
  auto record = *it;
  record.recording = std::move(recording);
  record.entry = state_->entry();
  record.entry.supersedes = stroke;
  record.entry.reason = reason;
  record.verdict = name(experiments::StrokeVerdict::kRejected);
  auto after = *state_->speed;
  if (auto ok = after.add(record); !ok) return ok;
  return state_->store(record, [&] { state_->speed = std::move(after); });
}

Result<void> Session::judge(const experiments::ForceAnswer& answer, const std::optional<AnswerInput>& input) {
  if (part() != SessionPart::kForce) return notNow("a judgement", part());
  if (input) {
    if (auto ok = validate(*input); !ok) return ok;
  }
  TACTUS_TRY(auto record, state_->force->record(answer));
  record.entry = state_->entry();
  auto after = *state_->force;
  if (auto ok = after.add(record); !ok) return ok;
  const bool asked = answer.kind != study::ForceJudgement::Kind::kNoAnswer;
  const auto mark = asked ? responseMark(record.response_s) : std::nullopt;
  return state_->store(
      record, [&] { state_->force = std::move(after); },
      notesOf(record.entry.id, input, mark, asked ? answer.would_stop : std::nullopt));
}

Result<void> Session::correctJudgement(study::ForceJudgement::Kind kind, const std::string& term,
                                       const std::optional<AnswerInput>& input, std::optional<bool> would_stop) {
  const bool rates = part() == SessionPart::kRating && block() == Block::kForce;
  if (part() != SessionPart::kForce && !rates) return notNow("a corrected judgement", part());
  if (input) {
    if (auto ok = validate(*input); !ok) return ok;
  }
  TACTUS_TRY(auto record, state_->force->correction(kind, term));
  const auto supersedes = record.entry.supersedes;
  record.entry = state_->entry();
  record.entry.supersedes = supersedes;
  auto after = *state_->force;
  if (auto ok = after.add(record); !ok) return ok;
  return state_->store(
      record, [&] { state_->force = std::move(after); }, notesOf(record.entry.id, input, std::nullopt, would_stop));
}

Result<void> Session::reply(const questionnaires::Reply& reply, double response_s,
                            const std::optional<AnswerInput>& input) {
  if (part() != SessionPart::kForm) return notNow("an answer", part());
  if (input) {
    if (auto ok = validate(*input); !ok) return ok;
  }
  TACTUS_TRY(auto record, state_->form->draft(reply));
  const auto supersedes = record.entry.supersedes;
  record.entry = state_->entry();
  record.entry.supersedes = supersedes;
  record.response_s = response_s;
  auto after = *state_->form;
  if (auto ok = after.add(record); !ok) return ok;
  auto notes = notesOf(record.entry.id, input, responseMark(response_s));
  const auto reason = state_->form->page()->reason;
  if (reason && !supersedes) notes.push_back(questionChosen(record.entry.id, *reason));
  return state_->store(
      record, [&] { state_->form = std::move(after); }, notes);
}

void Session::back() {
  if (state_->form) state_->form->back();
}
bool Session::forward() { return state_->form && state_->form->forward(); }
bool Session::goToFirstOpen() { return state_->form && state_->form->goToFirstOpen(); }

bool Session::goTo(int number) { return state_->form && state_->form->goTo(number); }
void Session::goOn() {
  if (state_->form) state_->form->goOn();
}

Result<void> Session::closeBlock() {
  if (part() != SessionPart::kRating) return notNow("the end of a block", part());
  const Block block = *state_->block();
  const study::EventRecord event{state_->entry(), kBlockClosed, detail("block", name(block))};
  return state_->store(event, [&] { state_->rated.insert(block); });
}

Result<void> Session::rate(int effort, int comfort) {
  if (part() != SessionPart::kRating) return notNow("a rating", part());
  for (const int rating : {effort, comfort}) {
    if (rating < kLeastRating || rating > kMostRating) {
      return fail(ErrorCode::kValue, "rating", std::to_string(rating), "1 to 7");
    }
  }
  const Block block = *state_->block();
  const study::RatingRecord record{state_->entry(), std::string(name(block)), effort, comfort};
  return state_->store(record, [&] { state_->rated.insert(block); });
}

Result<void> Session::pause(const std::string& reason) {
  if (part() == SessionPart::kAborted || state_->paused) return notNow("a pause", part());
  const study::EventRecord event{state_->entry(), kPaused, detail("reason", reason)};
  return state_->store(event, [&] { state_->paused = true; });
}

Result<void> Session::unpause() {
  if (!state_->paused) return notNow("the end of a pause", part());
  const study::EventRecord event{state_->entry(), kUnpaused, {}};
  return state_->store(event, [&] { state_->paused = false; });
}

Result<void> Session::skipBlock(const std::string& reason) {
  const auto at = state_->block();
  if (!at || part() == SessionPart::kAborted) return notNow("a block to leave out", part());
  study::EventRecord event{state_->entry(), kBlockSkipped, detail("block", name(*at))};
  event.entry.reason = reason;
  return state_->store(event, [&] { state_->skipped.insert(*at); });
}

Result<void> Session::abort(const std::string& reason) {
  if (part() == SessionPart::kAborted) return notNow("a second end", part());
  const study::EventRecord event{state_->entry(), kAborted, detail("reason", reason)};
  return state_->store(event, [&] { state_->aborted = true; });
}

}  // namespace tactus::session
