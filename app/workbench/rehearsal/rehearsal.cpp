#include "app/workbench/rehearsal/rehearsal.h"

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <algorithm>
#include <string>
#include <utility>

#include "app/session/session_notes.h"
#include "app/session/session_settings.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/rehearsal/screen_nurse.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "experiments/force_series.h"

namespace tactus::workbench {
namespace {

using base::Result;

tl::unexpected<base::Error> refuse(const std::string& what, const std::string& found, const std::string& wanted) {
  return base::fail(base::ErrorCode::kData, "rehearsal, " + what, found, wanted);
}

Result<study::SessionRecord> sessionOf(const store::StudyFile& file, const std::string& code) {
  TACTUS_TRY(const auto person, store::findPerson(file, code));
  if (!person) return refuse("participant " + base::quoted(code), "nobody", "the simulated nurse");
  if (!(person)->simulated) return refuse("participant " + base::quoted(code), "a person", "one marked as simulated");
  TACTUS_TRY(auto sessions, store::sessions(file, (person)->id));
  if (sessions.size() != 1) return refuse("sessions", std::to_string(sessions.size()), "one");
  return std::move(sessions.front());
}

Result<void> checkStrokes(const store::StudyFile& file, const store::Selection& all, const NurseMemory& memory) {
  TACTUS_TRY(const auto strokes, store::strokes(file, all, store::Recordings::kLeaveOut));
  for (const auto& [level, wanted] : memory.strokes) {
    const auto accepted = std::count_if(strokes.begin(), strokes.end(), [id = level.toStdString()](const auto& one) {
      return one.level == id && !one.practice && one.verdict == "accepted";
    });
    if (accepted != wanted) {
      return refuse("insertions at " + level.toStdString(), std::to_string(accepted), std::to_string(wanted));
    }
  }
  return {};
}

std::string wordOf(study::ForceJudgement::Kind kind, const std::string& term) {
  using Kind = study::ForceJudgement::Kind;
  if (kind == Kind::kNotFelt) return "not_felt";
  return kind == Kind::kBeyondPractice ? "beyond_practice" : term;
}

Result<void> checkJudgements(const store::StudyFile& file, const store::Selection& all, const NurseMemory& memory) {
  TACTUS_TRY(const auto judgements, store::judgements(file, all));
  std::vector<std::string> words;
  for (const auto& one : judgements) {
    if (one.series != experiments::kFamiliarisation) words.push_back(wordOf(one.kind, one.term));
  }
  if (words.size() != memory.judgements.size()) {
    return refuse("judged forces", std::to_string(words.size()), std::to_string(memory.judgements.size()));
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string said = memory.judgements[i].toStdString();
    if (words[i] != said) return refuse("force " + std::to_string(i + 1), base::quoted(words[i]), base::quoted(said));
  }
  return {};
}

Result<void> checkAnswers(const store::StudyFile& file, const store::Selection& latest, const NurseMemory& memory) {
  TACTUS_TRY(const auto answers, store::answers(file, latest));
  if (answers.size() != memory.replies.size()) {
    return refuse("answered questions", std::to_string(answers.size()), std::to_string(memory.replies.size()));
  }
  for (const study::AnswerRecord& one : answers) {
    const auto said = memory.replies.find(one.item);
    const std::string word = one.status == study::Answer::Status::kCantTell ? "cant_tell" : one.value;
    const std::string wanted = said == memory.replies.end() ? std::string() : said->second.toStdString();
    if (word != wanted) return refuse("question " + std::to_string(one.item), base::quoted(word), base::quoted(wanted));
  }
  return {};
}

QString comparisonOf(session::OwnModelVerdict verdict) {
  switch (verdict) {
    case session::OwnModelVerdict::kLighter: return QStringLiteral("lighter");
    case session::OwnModelVerdict::kHeavier: return QStringLiteral("heavier");
    case session::OwnModelVerdict::kCantTell: return QStringLiteral("cant_tell");
    case session::OwnModelVerdict::kAboutRight: break;
  }
  return QStringLiteral("right");
}

Result<void> checkRatings(const store::StudyFile& file, const store::Selection& all, const NurseMemory& memory) {
  TACTUS_TRY(const auto ratings, store::ratings(file, all));
  if (static_cast<int>(ratings.size()) == memory.ratings) return {};
  return refuse("rated parts", std::to_string(ratings.size()), std::to_string(memory.ratings));
}

Result<void> checkLog(const store::StudyFile& file, const store::Selection& all, const NurseMemory& memory) {
  TACTUS_TRY(const auto events, store::events(file, all));
  std::vector<std::pair<QString, QString>> regions;
  int marks = 0;
  bool sealed = false;
  bool finished = false;
  for (const study::EventRecord& event : events) {
    TACTUS_TRY(const auto line, session::ownModelIn(event));
    if (line && (line)->verdict) {
      regions.emplace_back(QString::fromStdString((line)->place.region), comparisonOf(*(line)->verdict));
    } else if (line) {
      ++marks;
    }
    sealed = sealed || event.kind == session::kAnswersSealed;
    finished = finished || (event.kind == "stage_entered" &&
                            event.detail.find(name(session::SessionPart::kFinished)) != std::string::npos);
  }
  if (regions != memory.own_regions) {
    return refuse("regions of the own model", std::to_string(regions.size()),
                  std::to_string(memory.own_regions.size()) + " with the comparisons that were given");
  }
  if (marks != memory.marks) return refuse("marks", std::to_string(marks), std::to_string(memory.marks));
  if (sealed != memory.sealed) return refuse("lock of the answers", sealed ? "locked" : "open", "as it was left");
  if (!finished) return refuse("session", "not finished", "all of its parts");
  return {};
}

}  // namespace

Result<void> checkRehearsal(const store::StudyFile& file, const NurseMemory& memory) {
  TACTUS_TRY(const auto session, sessionOf(file, memory.code.toStdString()));
  const store::Selection all{{}, session.id, true};
  if (auto ok = checkStrokes(file, all, memory); !ok) return ok;
  if (auto ok = checkJudgements(file, all, memory); !ok) return ok;
  if (auto ok = checkAnswers(file, {{}, session.id, false}, memory); !ok) return ok;
  if (auto ok = checkRatings(file, all, memory); !ok) return ok;
  return checkLog(file, all, memory);
}

// How far a rehearsal has come, for programs that watch it from outside: a line for each thing that a screen asks.

/// A JSON object on one line: the screen, what the nurse knows to be stored (`insertions`, `judgements`, `answers`,
/// `ratings`), `position` of a question (else 0), and `failed` while the disk refuses. `at`: null before the session.
QByteArray progressLine(const ParticipantState& state, const SessionSnapshot* at, const NurseMemory& memory);

namespace {

using Screen = ParticipantScreen;

// Each level that was shown counts whole, the one that is being done as far as its dots go.
int insertions(const ParticipantState& state, const NurseMemory& memory) {
  int count = 0;
  for (const auto& [level, wanted] : memory.strokes) count += wanted;
  return state.screen == Screen::kSpeed ? count - state.speed.wanted + state.speed.recorded : count;
}

int answers(const SessionSnapshot* at) {
  if (at == nullptr) return 0;
  const auto given =
      std::count_if(at->replies.begin(), at->replies.end(), [](const ItemReply& reply) { return !reply.isOpen(); });
  return static_cast<int>(given);
}

}  // namespace

QByteArray progressLine(const ParticipantState& state, const SessionSnapshot* at, const NurseMemory& memory) {
  const QJsonObject line = {
      {QStringLiteral("screen"), QString::fromLatin1(factsOf(state.screen).id)},
      {QStringLiteral("insertions"), insertions(state, memory)},
      {QStringLiteral("judgements"), static_cast<int>(memory.judgements.size())},
      {QStringLiteral("answers"), answers(at)},
      {QStringLiteral("ratings"), memory.ratings},
      {QStringLiteral("position"), state.screen == Screen::kQuestion ? state.question.position : 0},
      {QStringLiteral("failed"), state.failed}};
  return QJsonDocument(line).toJson(QJsonDocument::Compact);
}

namespace {

constexpr int kWakeMs = 1;
// Between two chances of the screens to be painted and of the study to be written.
constexpr double kMostAtOnceMs = 480;
// Longer than any rest of a warm device; and the computer has had time to show a screen and to store an answer.
constexpr double kStillS = 900;
constexpr qint64 kStillMs = 60'000;

}  // namespace

Rehearsal::Rehearsal(const Parts& on, session::NurseTraits traits, std::uint64_t seed, double speed)
    : on_(on), hands_(on.window, on.look), nurse_(hands_, std::move(traits), seed), speed_(speed) {
  timer_.setInterval(kWakeMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Rehearsal::wake);
}

void Rehearsal::begin() {
  clock_.start();
  serial_since_.start();
  serial_since_s_ = nowS();
  timer_.start();
}

void Rehearsal::wake() {
  owed_ms_ = std::min(owed_ms_ + static_cast<double>(clock_.nsecsElapsed()) * 1e-6 * speed_, kMostAtOnceMs);
  clock_.start();
  while (owed_ms_ >= VirtualTime::kBeat) {
    owed_ms_ -= VirtualTime::kBeat;
    nurse_.notice(on_.course.state(), nowS());
    tell();
    nurse_.live(on_.course.state(), on_.device.latest(), nowS());
    on_.time.advance(on_.device, VirtualTime::kBeat);
    if (!nurse_.isDone() && !nurse_.isSentAway() && !standsStill()) continue;
    timer_.stop();
    if (nurse_.isDone()) {
      emit done();
    } else {
      emit stuck(nurse_.isSentAway() ? tr("The screens ended the session before the nurse was done.")
                                     : tr("Nothing has happened for fifteen minutes on the screen \"%1\".")
                                           .arg(on_.window.screen()->accessibleName()));
    }
    return;
  }
}

void Rehearsal::tell() {
  const ParticipantState& state = on_.course.state();
  const std::pair now(state.serial, state.failed);
  if (told_ == now) return;
  told_ = now;
  emit came(progressLine(state, on_.course.session().snapshot().get(), nurse_.memory()));
}

bool Rehearsal::standsStill() {
  if (const std::uint64_t serial = on_.course.state().serial; serial != serial_) {
    serial_ = serial;
    serial_since_s_ = nowS();
    serial_since_.start();
  }
  return nowS() - serial_since_s_ > kStillS && serial_since_.elapsed() > kStillMs;
}

}  // namespace tactus::workbench
