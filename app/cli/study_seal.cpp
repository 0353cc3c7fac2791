#include "app/cli/study_seal.h"

#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <termios.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "app/cli/study_text.h"
#include "app/session/sealing.h"
#include "app/session/study_procedure.h"
#include "app/version.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/store/sealed_references.h"
#include "elicitation/model/evidence.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;
using base::Result;

constexpr std::size_t kLongestLine = 1000;

/// While it lives the terminal shows nothing of what is typed.
class HiddenTyping {
 public:
  HiddenTyping() : changed_(tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!changed_) return;
    termios hidden = before_;
    hidden.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden);
  }
  ~HiddenTyping() {
    if (changed_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
  }
  HiddenTyping(const HiddenTyping&) = delete;
  HiddenTyping& operator=(const HiddenTyping&) = delete;

 private:
  termios before_{};
  bool changed_;
};

std::string firstLine(std::istream& in) {
  std::string line;
  for (char letter = 0; line.size() < kLongestLine && in.get(letter) && letter != '\n';) line += letter;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

std::string typed(const char* question) {
  std::cerr << question << std::flush;
  std::string line;
  {
    const HiddenTyping hidden;
    line = firstLine(std::cin);
  }
  std::cerr << '\n';
  return line;
}

/// From the file, the terminal (`twice`: a typing error would lock the reference for ever) or the standard input.
Result<std::string> readPassphrase(const std::string& path, bool twice) {
  if (!path.empty()) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return base::fail(ErrorCode::kIo, path, "a file that cannot be read", "a file with the passphrase");
    return firstLine(file);
  }
  if (isatty(STDIN_FILENO) == 0) return firstLine(std::cin);
  std::string passphrase = typed("Passphrase: ");
  if (twice && typed("Once more: ") != passphrase) {
    return base::fail(ErrorCode::kValue, "passphrase", "two different ones", "the same one twice");
  }
  return passphrase;
}

Result<std::map<std::string, double>> curveConditions(const procedure::Procedure& about,
                                                      const std::vector<std::string>& at) {
  fuzzy::ForceModel model;
  model.inputs = about.inputs;
  auto out = session::usualConditions(about);
  for (const auto& text : at) {
    TACTUS_TRY(const auto given, inputOption(model, "--at", text));
    const auto& input = model.inputs[given.first];
    if (!out.contains(input.id)) {
      return base::fail(ErrorCode::kValue, "--at", base::quoted(text), "another input than the depth of the curve");
    }
    out[input.id] = given.second;
  }
  return out;
}

std::string timesText(std::size_t times) {
  return times == 1 ? "once" : times == 2 ? "twice" : std::to_string(times) + " times";
}

}  // namespace

Result<Output> studySeal(const StudySealOptions& options) {
  session::SealOrder order;
  order.name = options.reference;
  order.note = options.note;
  TACTUS_TRY(order.content, base::readFile(options.reference, store::kMostSealedBytes));
  std::vector<std::string> warnings;
  TACTUS_TRY(auto file, openToWrite(options.file, warnings));
  TACTUS_TRY(const auto procedure, session::procedureIn(file));
  const procedure::Procedure& about = procedure::orDefault(procedure);
  // What is wrong is said before the passphrase is asked for.
  if (auto ok = elicitation::readReferenceCurve(order.content, options.reference, about); !ok)
    return tl::unexpected(ok.error());
  TACTUS_TRY(order.conditions, curveConditions(about, options.at));
  TACTUS_TRY(const auto state, session::sealState(file));
  if (state.trials.empty() && state.began && !options.late) {
    return base::inFile({ErrorCode::kValue,
                         {},
                         {},
                         "a study whose elicitation has begun",
                         "a study before the first stroke, judgement, answer or rule; --late seals all the same, and "
                         "the report says so"},
                        options.file);
  }
  if (state.trials.empty()) {
    TACTUS_TRY(order.passphrase, readPassphrase(options.passphrase_file, true));
  }
  TACTUS_TRY(const auto sealed, session::seal(file, order, kGenerator));
  const store::SealedReference& record = sealed.record;
  for (auto& notice : noticesOf(file)) warnings.push_back(std::move(notice));
  for (auto& warning : closeSaved(file)) warnings.push_back(std::move(warning));
  const std::string utc = utcText(record.entry.when.utc_ms);
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("sealed_utc").value(utc);
    json.key("sha256").value(record.sha256).key("points").value(sealed.points).key("late").value(record.late);
    json.key("notices").values(warnings).endObject();
    return Output{json.text(), std::move(warnings)};
  }
  return Output{
      "Sealed " + std::to_string(sealed.points) + " points of " + base::oneLine(options.reference) + " in " +
          base::oneLine(options.file) + " at " + utc + (record.late ? ", late: the elicitation has begun" : "") +
          "\nSHA-256 " + record.sha256 +
          "\nKeep the passphrase: without it nobody can open the reference. Keep the CSV file away from all who "
          "answer or edit.\n",
      std::move(warnings)};
}

Result<Output> studyOpen(const StudyOpenOptions& options) {
  if (auto ok = requireOutput(options.out, {options.file}); !ok) return tl::unexpected(ok.error());
  std::vector<std::string> warnings;
  TACTUS_TRY(auto file, openToWrite(options.file, warnings));
  TACTUS_TRY(const auto state, session::sealState(file));
  if (!state.trials.empty() && !state.signed_off && !options.early) {
    return base::inFile({ErrorCode::kValue,
                         {},
                         {},
                         "no model that is signed off",
                         "a sign-off in the history of the model; --early opens all the same, and the report says so"},
                        options.file);
  }
  std::string passphrase;
  if (!state.trials.empty()) {
    TACTUS_TRY(passphrase, readPassphrase(options.passphrase_file, false));
  }
  TACTUS_TRY(const auto opened, session::unseal(file, passphrase, kGenerator));
  const store::SealOpening& record = opened.opening;
  for (auto& notice : noticesOf(file)) warnings.push_back(std::move(notice));
  for (auto& warning : closeSaved(file)) warnings.push_back(std::move(warning));
  const std::string utc = utcText(record.entry.when.utc_ms);
  std::string text;
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("opened_utc").value(utc);
    json.key("sealed_utc").value(utcText(opened.reference.entry.when.utc_ms));
    json.key("sha256").value(opened.reference.sha256).key("points").value(opened.points.size());
    json.key("early").value(record.early).key("openings").value(opened.times);
    json.key("changes_after").value(opened.changes_after).key("notices").values(warnings).endObject();
    text = json.text();
  } else {
    text = "Opened the reference of " + base::oneLine(options.file) + ", sealed at " +
           utcText(opened.reference.entry.when.utc_ms) + ": " + std::to_string(opened.points.size()) +
           " points, SHA-256 as sealed\nThis is noted in the study" +
           (record.early ? std::string(" as early, before a sign-off") : std::string()) + ". It was opened " +
           timesText(opened.times) + ". `tactus report` compares the model with it and lists each later change.\n";
  }
  Output said{std::move(text), std::move(warnings)};
  if (options.out.empty()) return said;
  return written(options.out, record.content, std::move(said), options.json);
}

}  // namespace tactus::cli
