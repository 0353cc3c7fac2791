#include <chrono>
#include <filesystem>

#include "app/bundle/zip.h"
#include "app/certify/certificate.h"
#include "app/cli/commands.h"
#include "app/cli/output_file.h"
#include "app/cli/terminal.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/bundle_check.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

using certify::Answers;
using certify::Certificate;
using certify::Percentiles;

/// The questions of a model file, of a bundle as a folder or a zip file, or of its manifest.
base::Result<certify::Questions> questionsFrom(const CertifyOptions& options, std::vector<std::string>& warnings) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_directory(options.model, ignored)) return certify::questionsOfBundle(options.model);
  const fs::path path(options.model);
  if (path.filename() == model_io::kManifestName)
    return certify::questionsOfBundle(path.has_parent_path() ? path.parent_path().string() : ".");
  if (bundle::isZipName(options.model)) {
    TACTUS_TRY(const auto folder, bundle::UnzippedFolder::of(options.model));
    auto questions = certify::questionsOfBundle(folder.path());
    if (!questions) return tl::unexpected(folder.named(questions.error()));
    return questions;
  }
  TACTUS_TRY(const auto text, base::readFile(options.model, model_io::kMostModelFileBytes));
  TACTUS_TRY(auto read, model_io::parseModel(text, options.model));
  warnings = read.warnings;
  auto questions = certify::questionsOf(std::move(read.model), base::sha256(text));
  if (!questions) return base::inFile(questions.error(), options.model);
  return questions;
}

/// At most `most` of the points, evenly spread.
void thinOut(std::vector<certify::Point>& points, std::size_t most) {
  if (points.size() <= most) return;
  std::vector<certify::Point> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(std::move(points[i * points.size() / most]));
  points = std::move(kept);
}

std::string countsText(const std::string& what, const Answers& answers) {
  std::string text =
      "  " + padded(what, 16) + std::to_string(answers.right) + " of " + std::to_string(answers.all) + " right";
  for (const auto& [count, word] : {std::pair{answers.wrong, "wrong"},
                                    {answers.late, "late"},
                                    {answers.missing, "missing"},
                                    {answers.unasked(), "not asked any more"}}) {
    if (count > 0) text += ", " + std::to_string(count) + " " + word;
  }
  text += "; largest error " + certify::scientific(answers.largest_error_n) + " N";
  return text + (answers.where.empty() ? "" : " at " + base::oneLine(answers.where)) + "\n";
}

std::string timesText(const std::string& what, const Percentiles& of) {
  std::string text = "  " + padded(what, 16);
  for (const double us : {of.half, of.p99, of.p999, of.largest}) text += rightAligned(base::formatFixed(us, 1), 10);
  return text + "\n";
}

std::string asText(const Certificate& made) {
  std::string text = wrapped(made.verdict(), "", 2);
  text += "  " + padded("program", 16) + base::oneLine(made.target) +
          (made.program.empty() ? "" : ", which says it is " + base::oneLine(made.program)) + "\n";
  text += "  " + padded("model", 16) + "SHA-256 " + made.model_sha256 + "\n";
  text += "  " + padded("machine", 16) + made.machine + "\n";
  text += countsText("points", made.points);
  if (made.has_tube) {
    text += countsText("steps of tube", made.steps);
  } else {
    text += std::string("  ") + padded("steps of tube", 16) +
            (made.program_has_tube ? "none, because the model lacks depth or speed"
                                   : "none, because the program says that it has no tube") +
            "\n";
  }
  if (made.points.latency_us.empty()) return text;
  text += "  " + padded("us", 16);
  for (const char* const head : {"50 %", "99 %", "99.9 %", "largest"}) text += rightAligned(head, 10);
  text +=
      "\n" + timesText("latency, points", made.points.latency()) + timesText("jitter, points", made.points.jitter());
  if (!made.steps.latency_us.empty())
    text += timesText("latency, steps", made.steps.latency()) + timesText("jitter, steps", made.steps.jitter());
  return text;
}

void writeTimes(base::JsonWriter& json, std::string_view key, const Percentiles& of) {
  json.key(key).beginObject(base::JsonWriter::Layout::kInline).key("p50").value(of.half).key("p99").value(of.p99);
  json.key("p99_9").value(of.p999).key("largest").value(of.largest).endObject();
}

void writeAnswers(base::JsonWriter& json, std::string_view key, const Answers& answers) {
  json.key(key).beginObject().key("asked").value(answers.all - answers.unasked()).key("right").value(answers.right);
  json.key("wrong").value(answers.wrong).key("late").value(answers.late).key("missing").value(answers.missing);
  json.key("not_asked").value(answers.unasked()).key("largest_error_n").value(answers.largest_error_n);
  json.key("where");
  answers.where.empty() ? json.null() : json.value(answers.where);
  writeTimes(json, "latency_us", answers.latency());
  writeTimes(json, "jitter_us", answers.jitter());
  json.endObject();
}

std::string asJson(const Certificate& made) {
  base::JsonWriter json;
  json.beginObject().key("certified").value(made.ok()).key("verdict").value(made.verdict());
  json.key("target").value(made.target).key("program").value(made.program).key("model").value(made.model_name);
  json.key("model_sha256").value(made.model_sha256).key("utc").value(made.utc).key("generator").value(made.generator);
  json.key("machine").value(made.machine).key("tolerance").value(made.tolerance);
  writeAnswers(json, "points", made.points);
  json.key("tube").value(made.has_tube);
  writeAnswers(json, "steps", made.steps);
  json.key("largest_depth_error_mm").value(made.largest_depth_error_mm).key("wrong");
  made.failure.empty() ? json.null() : json.value(made.failure);
  return json.endObject().text();
}

}  // namespace

base::Result<Output> certifyProgram(const CertifyOptions& options) {
  if (auto ok = requireOutput(options.out, {options.model}); !ok) return tl::unexpected(ok.error());
  Output said;
  TACTUS_TRY(auto questions, questionsFrom(options, said.warnings));
  if (options.points) thinOut(questions.points, *options.points);
  const InterruptSignals signals;
  certify::Patience patience;
  patience.answer = std::chrono::milliseconds(static_cast<int>(options.timeout_s * 1000));
  patience.is_stopped = [&signals] { return signals.raised(); };
  TACTUS_TRY(const auto made, certify::certify({options.target, options.arguments}, questions,
                                               {options.tolerance, base::formatUtc(std::chrono::system_clock::now()),
                                                std::string(kGenerator)},
                                               patience));
  said.text = options.json ? asJson(made) : asText(made);
  if (!made.ok()) said.failure = made.failure.empty() ? made.verdict() : made.failure;
  if (options.out.empty()) return said;
  return written(options.out, certificatePage(made), std::move(said), options.json);
}

}  // namespace tactus::cli
