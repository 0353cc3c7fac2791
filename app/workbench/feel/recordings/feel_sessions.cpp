#include "app/workbench/feel/recordings/feel_sessions.h"

#include <chrono>

#include "app/version.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/base/json/json_writer.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::workbench {
namespace {

using base::Result;
using study::RecordId;

std::string settingsOf(const FeelSessions::Visit& visit) {
  base::JsonWriter json;
  json.beginObject(base::JsonWriter::Layout::kInline).key("purpose").value("feel");
  json.key("device").value(visit.device_id).key("simulated").value(visit.simulated).endObject();
  std::string text = json.text();
  text.pop_back();  // the newline of a whole file
  return text;
}

}  // namespace

study::Moment momentNow() {
  using namespace std::chrono;
  return {utcNowMs(), duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count()};
}

Result<RecordId> FeelSessions::researcher(store::StudyFile& file, study::RecordIds& ids) {
  const auto people = readPeople(file);
  if (!people) return tl::unexpected(people.error());
  for (const StudyPerson& person : *people) {
    if (person.researcher) return person.id;
  }
  store::PersonCodes codes;
  const auto code = store::unusedCode(file, codes);
  if (!code) return tl::unexpected(code.error());
  const study::Person person{ids.next(), *code, false};
  if (auto ok = store::append(file, person); !ok) return tl::unexpected(ok.error());
  return person.id;
}

Result<RecordId> FeelSessions::sessionOf(const Visit& visit, store::StudyFile& file, study::RecordIds& ids) {
  const Key key(visit.run, visit.who);
  if (const auto found = sessions_.find(key); found != sessions_.end()) return found->second;
  // Person, session and profile together or not at all: it is tried again where the disk refuses.
  auto batch = store::Batch::begin(file);
  if (!batch) return tl::unexpected(batch.error());
  const auto who = visit.who ? Result<RecordId>(*visit.who) : researcher(file, ids);
  if (!who) return who;
  study::SessionRecord session;
  session.id = ids.next();
  session.person = *who;
  session.kind = study::SessionKind::kUsability;
  session.started = visit.started;
  session.program = kGenerator;
  session.device = visit.device;
  session.device_friction_n = visit.device_friction_n;
  session.settings = settingsOf(visit);
  if (auto ok = store::append(file, session); !ok) return tl::unexpected(ok.error());
  if (!visit.who) {
    study::ProfileRecord profile;
    profile.entry = {ids.next(), session.id, visit.started, study::EnteredBy::kResearcher, std::nullopt, {}};
    profile.category = kResearcherCategory;
    if (auto ok = store::append(file, profile); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = batch->commit(); !ok) return tl::unexpected(ok.error());
  sessions_[key] = session.id;
  return session.id;
}

int FeelSessions::numberOf(std::uint64_t serial, const RecordId& session) {
  const auto [it, is_new] = numbers_.try_emplace(serial, 0);
  if (is_new) it->second = ++counts_[session];
  return it->second;
}

}  // namespace tactus::workbench
