#include "app/session/setup_certificate.h"

#include <algorithm>
#include <utility>

#include "app/session/judged_forces.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/store/entries.h"

namespace tactus::session {
namespace {

using base::JsonMembers;
using base::JsonWriter;
using base::required;
using base::Result;

constexpr const char* kSetup = "setup_checked";
constexpr std::array<std::string_view, kSetupItems.size()> kNames = {"device", "force",    "latency", "screens",
                                                                     "sound",  "language", "consent", "disk"};

SetupCertificate readCertificate(JsonMembers& members, std::optional<base::Error>& error) {
  SetupCertificate out;
  members.integer(required("utc_ms"), out.utc_ms);
  members.text(required("device"), out.device);
  members.textOrEmpty("program", out.program);
  for (const base::JsonValue value : members.elements("findings")) {
    JsonMembers one(value, error);
    SetupFinding finding;
    if (const auto item = one.word(required("item"), kNames)) finding.item = kSetupItems[*item];
    one.flag("good", finding.good);
    one.textOrEmpty("found", finding.found);
    out.findings.push_back(std::move(finding));
  }
  return out;
}

}  // namespace

std::string_view name(SetupItem item) noexcept { return kNames[static_cast<std::size_t>(item)]; }

bool SetupCertificate::isGood() const {
  return std::all_of(kSetupItems.begin(), kSetupItems.end(), [this](SetupItem item) {
    return std::any_of(findings.begin(), findings.end(),
                       [item](const SetupFinding& one) { return one.item == item && one.good; });
  });
}

bool holds(const SetupCertificate& certificate, const std::string& device, std::int64_t utc_ms) {
  return certificate.device == device && utc_ms >= certificate.utc_ms && utc_ms - certificate.utc_ms <= kSetupHoldsMs;
}

Note setupChecked(const SetupCertificate& certificate) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline);
  json.key("utc_ms").value(static_cast<long long>(certificate.utc_ms)).key("device").value(certificate.device);
  json.key("program").value(certificate.program).key("findings").beginArray(JsonWriter::Layout::kInline);
  for (const SetupFinding& one : certificate.findings) {
    json.beginObject(JsonWriter::Layout::kInline).key("item").value(name(one.item));
    json.key("good").value(one.good).key("found").value(one.found).endObject();
  }
  std::string text = json.endArray().endObject().text();
  text.pop_back();  // the newline of a whole file
  return {kSetup, std::move(text)};
}

Result<std::optional<SetupCertificate>> setupIn(const study::EventRecord& event) {
  if (event.kind != kSetup) return std::optional<SetupCertificate>();
  auto read = base::readJson(event.detail, "setup_checked " + toText(event.entry.id), readCertificate);
  if (!read) return tl::unexpected(read.error());
  return std::optional(std::move(*read));
}

Result<bool> isWithoutSetup(const store::StudyFile& file, const study::SessionRecord& session) {
  if (session.device.empty() || !givesForce(session.device)) return false;
  const store::Selection of{{}, session.id, true};
  TACTUS_TRY(const auto strokes, store::strokes(file, of, store::Recordings::kLeaveOut));
  if (strokes.empty()) {
    TACTUS_TRY(const auto judgements, store::judgements(file, of));
    if (judgements.empty()) return false;
  }
  TACTUS_TRY(const auto events, store::events(file, of));
  for (const auto& event : events) {
    TACTUS_TRY(const auto certificate, setupIn(event));
    if (certificate && certificate->isGood()) return false;
  }
  return true;
}

Result<std::optional<SetupCertificate>> latestSetup(const store::StudyFile& file) {
  TACTUS_TRY(const auto events, store::events(file));
  std::optional<SetupCertificate> latest;
  for (const auto& event : events) {
    if (event.kind != kSetup) continue;
    TACTUS_TRY(auto certificate, setupIn(event));
    if (!latest || certificate->utc_ms > latest->utc_ms) latest = std::move(certificate);
  }
  return latest;
}

}  // namespace tactus::session
