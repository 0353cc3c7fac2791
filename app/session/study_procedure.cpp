#include "app/session/study_procedure.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/json/json_members.h"
#include "core/base/text.h"
#include "core/store/study_records.h"
#include "questionnaires/questionnaire.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::Result;
using procedure::Procedure;
using Json = nlohmann::ordered_json;

/// Highest step of a ladder: the force universe to a tenth of a newton, as far as a device is asked to go.
double highestStepN(const Procedure& procedure) {
  const double most_n = experiments::kHighestForceN * procedure.device_scale;
  return std::clamp(std::floor(procedure.output.max * 10 + 0.5) / 10, 0.2, std::floor(most_n * 10) / 10);
}

Result<ProcedurePtr> checked(Procedure read) {
  if (auto ok = questionnaires::checkWordings(read); !ok) return tl::unexpected(std::move(ok).error());
  auto out = std::make_shared<const Procedure>(std::move(read));
  auto protocol = firstProtocol(out);
  if (!protocol) return tl::unexpected(std::move(protocol).error());
  if (auto ok = validate(protocol->settings); !ok)
    return base::inFile(std::move(ok).error(), out->id + "/procedure.json");
  return out;
}

/// `protocol` with the settings that the pack gives, nested as the values of a protocol are named: the device beside
/// the settings.
Result<StudyProtocol> withPack(const StudyProtocol& protocol, const Procedure& procedure) {
  Json said = Json::parse(procedure.protocol);
  Json change = Json::object();
  if (said.contains("device")) {
    change["device"] = said["device"];
    said.erase("device");
  }
  change["settings"] = std::move(said);
  Json json = Json::parse(toJson(protocol));
  json.merge_patch(change);
  auto out = parseStudyProtocol(json.dump());
  if (out) {
    out->settings.procedure = protocol.settings.procedure;
    return out;
  }
  out.error().place = "/protocol: " + out.error().place;
  return base::inFile(std::move(out).error(), procedure.id + "/procedure.json");
}

/// Strokes of a procedure whose slow is slower begin and end at lower speeds: `slow` of nasogastric tubes ends at 100
/// mm/s.
void fitStrokes(const fuzzy::Variable& rate, experiments::StrokeSettings& stroke) {
  constexpr double kUsualSlowMmS = 100;
  const double share = std::min(1.0, rate.terms.front().points[3] / kUsualSlowMmS);
  for (double* const speed : {&stroke.start_speed_mm_s, &stroke.stop_speed_mm_s, &stroke.edge_speed_mm_s})
    *speed = std::round(*speed * share * 100) / 100;
}

/// What a protocol says of its procedure.
struct Kept {
  std::string sha256;
  procedure::PackFiles files;  ///< of the first protocol of a study; otherwise empty
};

Result<Kept> keptIn(const std::string& protocol_text) {
  return base::readJson(protocol_text, {}, [](JsonMembers& members, std::optional<base::Error>& error) {
    Kept out;
    const auto object = members.object("procedure");
    if (!object) return out;
    JsonMembers named(*object, error);
    named.text(base::required("sha256"), out.sha256);
    std::vector<JsonMembers::NamedText> files;
    named.texts("files", files);
    out.files = {files.begin(), files.end()};
    return out;
  });
}

/// The procedures that were read before, so that a study of thousand sessions reads its pack once.
class ReadProcedures {
 public:
  Result<ProcedurePtr> read(Kept kept, const std::string& study) {
    const std::lock_guard lock(mutex_);
    if (auto known = known_[kept.sha256].lock()) return known;
    if (procedure::packSha256(kept.files) != kept.sha256) {
      return base::fail(ErrorCode::kMismatch, "procedure", "files that do not fit their SHA-256",
                        "the pack with which the study was made; take the study from a backup");
    }
    TACTUS_TRY(auto read, procedure::readProcedure(std::move(kept.files), study));
    TACTUS_TRY(auto out, checked(std::move(read)));
    known_[kept.sha256] = out;
    last_.insert(last_.begin(), out);
    if (last_.size() > kKept) last_.pop_back();
    return out;
  }

 private:
  static constexpr std::size_t kKept = 4;

  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<const Procedure>> known_;
  std::vector<ProcedurePtr> last_;
};

}  // namespace

Result<ProcedurePtr> readPack(const std::string& name) {
  if (auto carried = procedure::builtIn(name)) return carried;
  std::error_code ignored;
  if (!std::filesystem::is_directory(name, ignored)) {
    return base::inFile(
        {ErrorCode::kReference,
         {},
         {},
         "no folder and no procedure of this name",
         "a folder or zip file with procedure.json, or one of " + base::joined(procedure::builtInIds(), ", ")},
        name);
  }
  TACTUS_TRY(auto read, procedure::readPackFolder(name));
  return checked(std::move(read));
}

Result<ProcedurePtr> readPack(procedure::PackFiles files, const std::string& name) {
  std::size_t all = 0;
  for (const auto& [path, bytes] : files) {
    all += bytes.size();
    if (bytes.size() <= procedure::kMostFileBytes && all <= procedure::kMostPackBytes) continue;
    return base::inFile({ErrorCode::kLimit,
                         {},
                         {},
                         base::quoted(path) + " beyond the limit",
                         "files of at most 4 MiB, and 16 MiB together"},
                        name);
  }
  TACTUS_TRY(auto read, procedure::readProcedure(std::move(files), name));
  return checked(std::move(read));
}

Result<StudyProtocol> firstProtocol(const ProcedurePtr& procedure) {
  StudyProtocol out;
  SessionSettings& settings = out.settings;
  settings.procedure = procedure;
  settings.form = procedure->forms.front().id;
  out.languages = procedure->languages;
  settings.force.terms.clear();
  for (const auto& term : procedure->output.terms) settings.force.terms.push_back(term.id);
  if (const auto* const rate = procedure->rateInput()) {
    settings.speed.levels.clear();
    for (const auto& term : rate->terms) settings.speed.levels.push_back(term.id);
    if (procedure != procedure::defaultProcedure()) fitStrokes(*rate, settings.speed.stroke);
  } else {
    std::erase(settings.blocks, Block::kSpeed);
  }
  if (procedure != procedure::defaultProcedure()) {
    auto& ladder = settings.force.ladder;
    ladder.highest_n = highestStepN(*procedure);
    ladder.lowest_n = ladder.step_n = ladder.highest_n > 6 ? 0.5 : ladder.highest_n > 2 ? 0.2 : 0.1;
    if (ladder.step_n == 0.5) ladder.highest_n = std::floor(ladder.highest_n * 2) / 2;
    settings.force.device_scale = procedure->device_scale;
    settings.force.continuous_n *= procedure->device_scale;
    settings.force.familiarisation_n = {ladder.at(ladder.count() / 3)};
  }
  return procedure->protocol.empty() ? out : withPack(out, *procedure);
}

Result<void> keepProcedure(store::StudyFile& file, const ProcedurePtr& procedure, SessionTools& tools) {
  TACTUS_TRY(auto protocol, firstProtocol(procedure));
  study::ProtocolRecord record{tools.ids.next(), 1, tools.now().utc_ms, {}, {}, toJson(protocol, procedure.get())};
  return store::append(file, record);
}

Result<ProcedurePtr> procedureIn(const store::StudyFile& file) {
  TACTUS_TRY(const auto state, store::protocolState(file));
  if (!state.current) return ProcedurePtr{};
  TACTUS_TRY(const auto current, keptIn(state.current->text));
  if (current.sha256.empty()) return ProcedurePtr{};
  TACTUS_TRY(const auto records, store::protocols(file));
  for (const auto& record : records) {
    TACTUS_TRY(auto kept, keptIn(record.text));
    if (kept.sha256 != current.sha256 || kept.files.empty()) continue;
    static ReadProcedures read_procedures;
    auto read = read_procedures.read(std::move(kept), file.path());
    if (!read) return base::inFile(std::move(read).error(), file.path());
    return read;
  }
  return base::inFile({ErrorCode::kReference, "protocol", "procedure", "a procedure whose pack is not in the study",
                       "the pack with which the study was made; take the study from a backup"},
                      file.path());
}

Result<ProcedurePtr> procedureAt(const std::string& path) {
  std::error_code ignored;
  if (path.empty() || !std::filesystem::exists(path, ignored)) return ProcedurePtr{};
  TACTUS_TRY(const auto file, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
  return procedureIn(file);
}

Result<StudyProtocol> protocolOf(const store::StudyFile& file, const study::ProtocolRecord& record) {
  TACTUS_TRY(auto out, parseStudyProtocol(record.text));
  TACTUS_TRY(out.settings.procedure, procedureIn(file));
  return out;
}

Result<SessionSettings> settingsOf(const store::StudyFile& file, const study::SessionRecord& session) {
  TACTUS_TRY(auto out, parseSessionSettings(session.settings));
  TACTUS_TRY(out.procedure, procedureIn(file));
  return out;
}

Result<void> requireSameProcedure(const store::StudyFile& one, const std::string& other) {
  TACTUS_TRY(const auto here, procedureIn(one));
  TACTUS_TRY(const auto opened, store::StudyFile::open(other, {store::Access::kReadOnly, {}}));
  TACTUS_TRY(const auto there, procedureIn(opened));
  const Procedure& ours = procedure::orDefault(here);
  const Procedure& theirs = procedure::orDefault(there);
  if (ours.sha256 == theirs.sha256) return {};
  const auto text = [](const Procedure& of) {
    return base::quoted(of.id) + " (pack " + std::to_string(of.version) + ", " + of.sha256.substr(0, 12) + ")";
  };
  return base::inFile(
      {ErrorCode::kMismatch, {}, "procedure", text(theirs), text(ours) + ", that of the study it is merged into"},
      other);
}

}  // namespace tactus::session
