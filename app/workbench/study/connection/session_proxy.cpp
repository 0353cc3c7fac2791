#include "app/workbench/study/connection/session_proxy.h"

#include <QPointer>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/base/error.h"
#include "core/store/batch.h"
#include "core/store/persons.h"

namespace tactus::workbench {

using base::Result;

/// A session in the thread of the study.
struct SessionProxy::LiveSession {
  std::optional<session::Session> session;
  study::Moment now;  ///< of the call that is being made
  SessionStep step = 0;
  std::shared_ptr<const SessionSnapshot> snapshot;

  void look() { snapshot = std::make_shared<const SessionSnapshot>(snapshotOf(*session, step, snapshot.get())); }
};

SessionProxy::SessionProxy(StudyConnection& study, QObject* parent, std::function<study::Moment()> now)
    : QObject(parent), study_(study), now_(std::move(now)) {
  connect(&study_, &StudyConnection::changed, this, &SessionProxy::changed);
  connect(&study_, &StudyConnection::opened, this, &SessionProxy::forgetSession);
  connect(&study_, &StudyConnection::closed, this, &SessionProxy::forgetSession);
}

void SessionProxy::begin(const session::SessionStart& start, std::optional<study::Person> newcomer) {
  open([start, newcomer = std::move(newcomer)](store::StudyFile& file, session::SessionTools tools) {
    std::optional<session::Session> begun;
    // The person and the session together or not at all.
    const auto stored = store::inOneBatch(file, [&]() -> Result<void> {
      if (newcomer) {
        if (auto ok = store::append(file, *newcomer); !ok) return ok;
      }
      TACTUS_TRY(auto session, session::Session::begin(file, start, std::move(tools)));
      begun = std::move(session);
      return {};
    });
    return stored ? Result<session::Session>(std::move(*begun)) : tl::unexpected(stored.error());
  });
}

void SessionProxy::resume(const study::RecordId& session) {
  open([session](store::StudyFile& file, session::SessionTools tools) {
    return session::Session::resume(file, session, std::move(tools));
  });
}

void SessionProxy::leave() {
  if (!room_) return;
  send(room_, Asks::kNext, [](LiveSession& room, store::StudyFile&) -> Result<void> {
    room.session.reset();
    room.snapshot.reset();
    return {};
  });
}

bool SessionProxy::tell(SessionStep step, const study::ProfileRecord& profile,
                        std::optional<session::ExperienceBand> band) {
  return answer(step, [profile, band](session::Session& session) {
    return band ? session.tell(profile, *band) : session.tell(profile);
  });
}

bool SessionProxy::addStroke(SessionStep step, session::CapturedStroke stroke) {
  const auto taken = std::make_shared<const session::CapturedStroke>(std::move(stroke));
  return answer(step, [taken](session::Session& session) {
    return session.addStroke(taken->stroke, taken->recording, taken->recording_first);
  });
}

bool SessionProxy::judge(SessionStep step, const experiments::ForceAnswer& given,
                         std::optional<session::AnswerInput> input) {
  return answer(step,
                [given, input = std::move(input)](session::Session& session) { return session.judge(given, input); });
}

bool SessionProxy::correctJudgement(SessionStep step, const experiments::ForceAnswerOption& word,
                                    std::optional<session::AnswerInput> input, std::optional<bool> would_stop) {
  return answer(step, [word, input = std::move(input), would_stop](session::Session& session) {
    const bool term = word.kind == study::ForceJudgement::Kind::kTerm;
    return session.correctJudgement(word.kind, term ? word.id : std::string(), input, would_stop);
  });
}

bool SessionProxy::reply(SessionStep step, const questionnaires::Reply& reply, double response_s,
                         std::optional<session::AnswerInput> input) {
  return answer(step, [reply, response_s, input = std::move(input)](session::Session& session) {
    return session.reply(reply, response_s, input);
  });
}

bool SessionProxy::rate(SessionStep step, int effort, int comfort) {
  return answer(step, [effort, comfort](session::Session& session) { return session.rate(effort, comfort); });
}

bool SessionProxy::back(SessionStep step) {
  return answer(step, [](session::Session& session) -> Result<void> {
    session.back();
    return {};
  });
}

bool SessionProxy::forward(SessionStep step) {
  return answer(step, [](session::Session& session) -> Result<void> {
    session.forward();
    return {};
  });
}

bool SessionProxy::goToFirstOpen(SessionStep step) {
  return answer(step, [](session::Session& session) -> Result<void> {
    session.goToFirstOpen();
    return {};
  });
}

bool SessionProxy::goTo(SessionStep step, int item) {
  return answer(step, [item](session::Session& session) -> Result<void> {
    session.goTo(item);
    return {};
  });
}

bool SessionProxy::goOn(SessionStep step) {
  return answer(step, [](session::Session& session) -> Result<void> {
    session.goOn();
    return {};
  });
}

bool SessionProxy::closeBlock(SessionStep step) {
  return answer(step, [](session::Session& session) { return session.closeBlock(); });
}

void SessionProxy::rejectStroke(const study::RecordId& stroke, const std::string& reason) {
  instruct([stroke, reason](session::Session& session) { return session.rejectStroke(stroke, reason); });
}

void SessionProxy::skipBlock(const std::string& reason) {
  instruct([reason](session::Session& session) { return session.skipBlock(reason); });
}

void SessionProxy::pause(const std::string& reason) {
  instruct([reason](session::Session& session) { return session.pause(reason); }, Asks::kSame);
}

void SessionProxy::unpause() {
  instruct([](session::Session& session) { return session.unpause(); }, Asks::kSame);
}

void SessionProxy::abort(const std::string& reason) {
  instruct([reason](session::Session& session) { return session.abort(reason); });
}

void SessionProxy::setEnteredBy(study::EnteredBy who) {
  const auto set = [who](session::Session& session) -> Result<void> {
    session.setEnteredBy(who);
    return {};
  };
  instruct(set, Asks::kSame);
}

void SessionProxy::note(session::Note note) {
  instruct([note = std::move(note)](session::Session& session) { return session.note(note); }, Asks::kSame);
}

// Each session gets a room of its own, so that nothing that is late finds the wrong one.
void SessionProxy::open(Opening opening) {
  if (!study_.takesOrders()) {
    emit refused(tr("No study is open, so no session can begin."));
    return;
  }
  const auto room = std::make_shared<LiveSession>();
  if (room_) leave();
  room_ = room;
  snapshot_.reset();
  unanswered_ = moving_on_ = 0;  // what is still on its way for another room is not waited for
  // It must not keep the room: a study may stay open for the sessions of months.
  study_.beforeClosing([its = std::weak_ptr(room)] {
    if (const auto still = its.lock()) still->session.reset();
  });
  send(room, Asks::kNext, [opening = std::move(opening)](LiveSession& its, store::StudyFile& file) -> Result<void> {
    session::SessionTools tools{[at = &its] { return at->now; }, study::RecordIds()};
    TACTUS_TRY(auto session, opening(file, std::move(tools)));
    its.session = std::move(session);
    its.step = 1;
    its.look();
    return {};
  });
}

bool SessionProxy::answer(SessionStep step, Call call) {
  if (!snapshot_ || isMovingOn() || step != snapshot_->step || !study_.takesOrders()) return false;
  send(room_, Asks::kNext, onSession(std::move(call), Asks::kNext));
  return true;
}

void SessionProxy::instruct(Call call, Asks asks) {
  if (room_ && study_.takesOrders()) {
    send(room_, asks, onSession(std::move(call), asks));
  } else {
    emit refused(tr("There is no session for this."));
  }
}

/// The work of `call`.
SessionProxy::Work SessionProxy::onSession(Call call, Asks asks) {
  return [call = std::move(call), asks](LiveSession& room, store::StudyFile&) -> Result<void> {
    if (!room.session) {
      return base::fail(base::ErrorCode::kValue, "session", "none, it has ended or could not begin", "an open session");
    }
    if (auto ok = call(*room.session); !ok) return ok;
    if (asks == Asks::kNext) ++room.step;
    room.look();
    return {};
  };
}

void SessionProxy::send(std::shared_ptr<LiveSession> room, Asks asks, Work work) {
  ++unanswered_;
  if (asks == Asks::kNext) ++moving_on_;
  const auto seen = std::make_shared<std::shared_ptr<const SessionSnapshot>>();
  const auto told = [self = QPointer(this), room, asks](const std::function<void()>& take) {
    if (!self || self->room_ != room) return;
    --self->unanswered_;
    if (asks == Asks::kNext) --self->moving_on_;
    take();
    emit self->changed();
  };
  study_.order(
      [room, seen, now = now_(), work = std::move(work)](store::StudyFile& file, study::RecordIds&) -> Result<void> {
        room->now = now;
        if (auto ok = work(*room, file); !ok) return ok;
        *seen = room->snapshot;
        return {};
      },
      [this, told, seen] { told([&] { snapshot_ = *seen; }); },
      [this, told](const QString& sentence) { told([&] { emit refused(sentence); }); });
  emit changed();
}

void SessionProxy::forgetSession() {
  room_.reset();
  snapshot_.reset();
  unanswered_ = moving_on_ = 0;
  emit changed();
}

}  // namespace tactus::workbench
