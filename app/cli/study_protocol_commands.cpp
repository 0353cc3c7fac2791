// `tactus study protocol` and `tactus study key`: what the workbench sets in stage Collect, without a window.
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <utility>

#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/session/study_protocol.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/store/research_key.h"
#include "core/store/study_records.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;
using base::Result;
using session::StudyProtocol;

/// No protocol and no consent text is longer.
constexpr std::size_t kMostBytes = std::size_t{1} << 20U;
/// The longest line that is read as a key; a longer one is refused by the store.
constexpr std::size_t kLongestKey = 600;

Result<StudyProtocol> startOf(const StudyProtocolOptions& options, const store::StudyFile& file,
                              const store::ProtocolState& state) {
  if (!options.from.empty()) {
    TACTUS_TRY(const auto text, base::readFile(options.from, kMostBytes));
    auto read = session::parseStudyProtocol(text);
    if (!read) return base::inFile(read.error(), options.from);
    TACTUS_TRY(read->settings.procedure, session::procedureIn(file));
    return read;
  }
  return state.current ? session::protocolOf(file, *state.current) : StudyProtocol();
}

Result<StudyProtocol> changed(StudyProtocol protocol, const StudyProtocolOptions& options) {
  if (!options.preset.empty()) {
    auto next = session::withPreset(protocol, options.preset);
    if (!next) return next;
    protocol = std::move(*next);
  }
  for (const std::string& set : options.set) {
    const auto equals = set.find('=');
    if (equals == std::string::npos) {
      return base::fail(ErrorCode::kValue, "--set", base::quoted(set), "NAME=VALUE");
    }
    auto next = session::withProtocolValue(protocol, set.substr(0, equals), set.substr(equals + 1));
    if (!next) return next;
    protocol = std::move(*next);
  }
  for (const std::string& consent : options.consent) {
    const auto equals = consent.find('=');
    if (equals == std::string::npos) {
      return base::fail(ErrorCode::kValue, "--consent", base::quoted(consent), "LANGUAGE=FILE");
    }
    TACTUS_TRY(auto text, base::readFile(consent.substr(equals + 1), kMostBytes));
    protocol.consent[consent.substr(0, equals)] = std::move(text);
  }
  return protocol;
}

std::string stateText(const store::ProtocolState& state) {
  if (!state.current) return "no protocol is set; these are the defaults";
  return "version " + std::to_string(state.current->version) +
         (state.locked ? ", which participants follow" : ", a draft");
}

std::string asText(const std::string& file, const store::ProtocolState& state, const StudyProtocol& protocol) {
  std::string text = base::oneLine(file) + ": " + stateText(state) + '\n';
  for (const auto& [name, value] : session::protocolValues(protocol)) {
    text += "  " + name + " = " + base::oneLine(value) + '\n';
  }
  const auto load = session::loadOf(protocol);
  text += "  about " + std::to_string(std::lround(load.minutes)) + " min: " + std::to_string(load.strokes) +
          " insertions, " + std::to_string(load.judgements) + " forces, " + std::to_string(load.questions) +
          " questions";
  if (load.heat_share > 0) {
    text +=
        "; the motors at " + std::to_string(std::lround(100 * load.heat_share)) + " % of what they can hold for long";
  }
  return text + '\n';
}

std::string asJson(const std::string& file, const store::ProtocolState& state, const StudyProtocol& protocol,
                   const std::vector<study::ProtocolRecord>& records) {
  base::JsonWriter json;
  json.beginObject().key("file").value(file);
  json.key("version").value(state.current ? state.current->version : 0).key("locked").value(state.locked);
  const auto load = session::loadOf(protocol);
  json.key("load").beginObject(base::JsonWriter::Layout::kInline).key("minutes").value(load.minutes);
  json.key("strokes").value(load.strokes).key("judgements").value(load.judgements);
  json.key("questions").value(load.questions).key("heat_share").value(load.heat_share).endObject();
  json.key("protocol").raw(session::toJson(protocol)).key("records").beginArray();
  for (const study::ProtocolRecord& record : records) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("version").value(record.version);
    json.key("utc").value(utcText(record.utc_ms)).key("author").value(record.author);
    json.key("reason").value(record.reason).endObject();
  }
  json.endArray().endObject();
  return json.text();
}

Result<Output> shown(const store::StudyFile& file, const StudyProtocolOptions& options) {
  TACTUS_TRY(const auto state, store::protocolState(file));
  TACTUS_TRY(const auto protocol, session::currentProtocol(file));
  TACTUS_TRY(const auto records, store::protocols(file));
  const StudyProtocol now = protocol.value_or(StudyProtocol());
  return Output{options.json ? asJson(options.file, state, now, records) : asText(options.file, state, now),
                noticesOf(file)};
}

// The first line of the file, or of the standard input: a key on the command line would stay in its history.
Result<std::string> readKey(const StudyKeyOptions& options) {
  std::ifstream file;
  if (!options.from.empty()) {
    file.open(options.from, std::ios::binary);
    if (!file) return base::fail(ErrorCode::kIo, options.from, "a file that cannot be read", "a file with the key");
  }
  std::istream& in = options.from.empty() ? std::cin : file;
  std::string key;
  for (char letter = 0; key.size() < kLongestKey && in.get(letter) && letter != '\n';) key += letter;
  if (!key.empty() && key.back() == '\r') key.pop_back();
  if (key.empty()) {
    return base::fail(ErrorCode::kValue, "key", "an empty line", "the new key; --remove takes it away");
  }
  return key;
}

}  // namespace

Result<Output> studyProtocol(const StudyProtocolOptions& options) {
  const bool changes =
      !options.set.empty() || !options.consent.empty() || !options.from.empty() || !options.preset.empty();
  std::vector<std::string> copying;
  TACTUS_TRY(auto file, changes ? openToWrite(options.file, copying)
                                : store::StudyFile::open(options.file, {store::Access::kReadOnly, {}}));
  if (!changes) return shown(file, options);
  TACTUS_TRY(const auto state, store::protocolState(file));
  auto protocol = startOf(options, file, state);
  if (!protocol) return tl::unexpected(protocol.error());
  protocol = changed(std::move(*protocol), options);
  if (!protocol) return tl::unexpected(protocol.error());
  session::SessionTools tools = session::systemTools();
  if (const auto stored = session::setProtocol(file, *protocol, options.author, options.reason, tools); !stored)
    return tl::unexpected(stored.error());
  auto output = shown(file, options);
  if (output) output->warnings.insert(output->warnings.end(), copying.begin(), copying.end());
  if (auto closed = file.close(); output && !closed) output->warnings.push_back(closed.error().message());
  return output;
}

Result<Output> studyKey(const StudyKeyOptions& options) {
  std::string key;
  if (!options.remove) {
    TACTUS_TRY(auto read, readKey(options));
    key = std::move(read);
  }
  std::vector<std::string> warnings;
  TACTUS_TRY(auto file, openToWrite(options.file, warnings));
  if (auto ok = store::setResearchKey(file, key, utcNowMs()); !ok) return tl::unexpected(ok.error());
  for (auto& notice : noticesOf(file)) warnings.push_back(std::move(notice));
  for (auto& warning : closeSaved(file)) warnings.push_back(std::move(warning));
  const std::string name = base::oneLine(options.file);
  return Output{options.remove ? "The research key of " + name +
                                     " is removed: anyone can leave the participant's "
                                     "screens\n"
                               : "The research key of " + name +
                                     " is set: it leads from the participant's screens to "
                                     "the researcher's\n",
                std::move(warnings)};
}

}  // namespace tactus::cli
