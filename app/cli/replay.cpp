#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/terminal.h"
#include "app/replay/recorded_strokes.h"
#include "app/replay/stroke_file.h"
#include "app/replay/stroke_replay.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/store/model_versions.h"
#include "core/store/sealed_references.h"
#include "core/store/study_file.h"

namespace tactus::cli {
namespace {

using base::formatFixed;
using replay::ComparedStroke;
using replay::RecordedStroke;
using replay::StrokeBaseline;
using replay::StrokeComparison;
using replay::StrokeUse;

constexpr std::size_t kNameWidth = 32;
constexpr std::size_t kMostStrokeBytes = std::size_t{1} << 20U;

/// The kinds of strokes with their words: in JSON, and as the reason why they are left out.
struct UseWords {
  StrokeUse use;
  const char* name;
  const char* reason;
};
constexpr std::array kUses = {
    UseWords{StrokeUse::kExact, "exact", ""},
    UseWords{StrokeUse::kForceOff, "force_off", ""},
    UseWords{StrokeUse::kUnknownModel, "unknown_model", "felt on a model that the study does not keep"},
    UseWords{StrokeUse::kSamplesLost, "samples_lost", "samples are missing, because the program stood still"},
    UseWords{StrokeUse::kOtherForce, "other_force",
             "their own model gives another force than was recorded: another version of the program, a device that "
             "limited the spring, or an edit during the stroke"},
};

const UseWords& wordsOf(StrokeUse use) { return kUses[static_cast<std::size_t>(use)]; }

/// `recording 1, stroke 4`, `velvet-otter, slow 3`.
std::string nameOf(const RecordedStroke& stroke) {
  const std::string number = std::to_string(stroke.number);
  if (stroke.recording_number > 0) return "recording " + std::to_string(stroke.recording_number) + ", stroke " + number;
  return stroke.person + ", " + stroke.level + " " + number;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string signedJnd(const replay::StrokeNumbers& numbers) {
  return (numbers.noticeable_by_n < 0 ? "-" : "+") + formatFixed(numbers.noticeable, 1) + " JND";
}

/// How many strokes would feel different, and the one that differs most: a line each.
std::string headline(const StrokeBaseline& before, const StrokeComparison& found) {
  const replay::StrokeSummary& summary = found.summary;
  if (summary.compared == 0) return "No stroke could be compared.\n";
  std::string text = std::to_string(summary.felt) + " of " + counted(summary.compared, "stroke") +
                     " would feel different: by a just-noticeable difference (JND) or more.\n";
  const ComparedStroke& worst = found.strokes[*summary.worst];
  if (worst.numbers->noticeable == 0) return text + "No force changes.\n";
  return text + "largest: " + base::oneLine(nameOf((*before.strokes)[worst.stroke])) + ", " +
         signedJnd(*worst.numbers) + " at " + formatFixed(worst.numbers->noticeable_at_mm, 0) + " mm; median " +
         formatFixed(summary.median_noticeable, 2) + " JND\n";
}

/// One line for each reason for which strokes are left out, and for holes.
std::string notes(const StrokeBaseline& before, const StrokeComparison& found) {
  std::string text;
  if (found.summary.holes > 0) {
    text += wrapped(counted(found.summary.holes, "stroke") +
                        " would meet a place without a force, where no rule fires; no numbers are given for them.",
                    "", 0);
  }
  for (const UseWords& use : kUses) {
    std::size_t count = 0;
    for (const RecordedStroke& stroke : *before.strokes) count += stroke.use == use.use ? 1 : 0;
    if (count == 0) continue;
    if (use.use == StrokeUse::kForceOff) {
      text += wrapped(counted(count, "stroke") +
                          " of the speed experiment had no force: the numbers say what the stroke would meet.",
                      "", 0);
    } else if (!isCompared(use.use)) {
      text += wrapped(counted(count, "stroke") + " left out: " + use.reason + ".", "", 0);
    }
  }
  if (before.refusal) text += wrapped("Strokes are left out, --at may help: " + before.refusal->message(), "", 0);
  return text + wrapped(
                    "The hand is the recorded one and does not answer to the other force. Rms and shares can be read "
                    "as they are; peaks in fast strokes may differ by a factor of two.",
                    "", 0);
}

std::string row(const RecordedStroke& stroke, const ComparedStroke& one) {
  std::string text = padded(nameOf(stroke), kNameWidth);
  if (!one.numbers) {
    const auto& hole_mm = one.hole_mm[1] ? one.hole_mm[1] : one.hole_mm[0];
    return text + "no rule fires at " + formatFixed(*hole_mm, 1) + " mm" + (one.hole_mm[0] ? ", nor before\n" : "\n");
  }
  const replay::StrokeNumbers& numbers = *one.numbers;
  const auto cell = [&](double value, int decimals, std::size_t width) {
    text += rightAligned(formatFixed(value, decimals), width);
  };
  cell(numbers.peak_n[0], 3, 7);
  cell(numbers.peak_n[1], 3, 8);
  cell(numbers.largest_n, 3, 8);
  cell(numbers.largest_at_mm, 0, 5);
  cell(numbers.rms_n, 3, 7);
  cell(numbers.work_mj[0], 1, 7);
  cell(numbers.work_mj[1], 1, 7);
  cell(100 * numbers.time_share, 0, 5);
  cell(100 * numbers.path_share, 0, 5);
  text += rightAligned((numbers.noticeable_by_n < 0 ? "-" : "") + formatFixed(numbers.noticeable, 2), 7);
  return text + '\n';
}

std::string asText(const std::string& compared_with, const StrokeBaseline& before, const StrokeComparison& found) {
  std::string text = headline(before, found) + "before: " + base::oneLine(compared_with) + '\n';
  if (!found.strokes.empty()) {
    text += '\n' + std::string(kNameWidth, ' ') +
            " peak N          largest         rms    work mJ       above 1 JND    JND\n" +
            std::string(kNameWidth, ' ') + " before   after       N   mm      N  before  after  time%  path%\n";
  }
  for (const ComparedStroke& one : found.strokes) text += row((*before.strokes)[one.stroke], one);
  return text + '\n' + notes(before, found);
}

void writeNumbers(base::JsonWriter& json, const replay::StrokeNumbers& numbers) {
  json.key("peak_before_n").value(numbers.peak_n[0]).key("peak_after_n").value(numbers.peak_n[1]);
  json.key("largest_n").value(numbers.largest_n).key("largest_at_mm").value(numbers.largest_at_mm);
  json.key("rms_n").value(numbers.rms_n).key("mean_n").value(numbers.mean_n);
  json.key("work_before_mj").value(numbers.work_mj[0]).key("work_after_mj").value(numbers.work_mj[1]);
  json.key("time_share").value(numbers.time_share).key("path_share").value(numbers.path_share);
  json.key("largest_jnd").value(numbers.noticeable).key("largest_jnd_at_mm").value(numbers.noticeable_at_mm);
  json.key("largest_jnd_by_n").value(numbers.noticeable_by_n);
}

std::string asJson(const std::string& compared_with, const StrokeBaseline& before, const StrokeComparison& found) {
  base::JsonWriter json;
  const replay::StrokeSummary& summary = found.summary;
  json.beginObject().key("before").value(compared_with).key("compared").value(summary.compared);
  json.key("felt").value(summary.felt).key("holes").value(summary.holes).key("left_out").value(summary.left_out);
  json.key("median_jnd").value(summary.median_noticeable).key("strokes").beginArray();
  const auto writeStroke = [&](const RecordedStroke& stroke) {
    json.beginObject().key("recording").value(stroke.recording_number).key("stroke").value(stroke.number);
    json.key("person").value(stroke.person).key("level").value(stroke.level).key("simulated").value(stroke.simulated);
    json.key("use").value(wordsOf(stroke.use).name);
  };
  std::vector<bool> written(before.strokes->size());
  for (const ComparedStroke& one : found.strokes) {
    written[one.stroke] = true;
    writeStroke((*before.strokes)[one.stroke]);
    json.key("hole_before_mm").value(one.hole_mm[0]).key("hole_after_mm").value(one.hole_mm[1]);
    if (one.numbers) writeNumbers(json, *one.numbers);
    json.endObject();
  }
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i]) continue;
    writeStroke((*before.strokes)[i]);
    json.key("left_out").value(true).endObject();
  }
  return json.endArray().endObject().text();
}

/// The model before, and how the output names it.
base::Result<std::pair<OpenedModel, std::string>> modelBefore(const ReplayOptions& options,
                                                              const store::StudyFile& file) {
  if (!options.before.empty()) {
    TACTUS_TRY(auto opened, openedModel(options.before));
    return std::pair(std::move(opened), options.before);
  }
  if (options.last_sign_off) {
    TACTUS_TRY(const auto versions, store::modelVersions(file));
    const auto last = std::find_if(versions.rbegin(), versions.rend(), store::isSignOff);
    if (last == versions.rend()) {
      return tl::unexpected(base::Error{base::ErrorCode::kData, options.study, "models", "no sign-off",
                                        "a version that was signed off, or --before MODEL"});
    }
    TACTUS_TRY(const auto version, store::modelVersion(file, last->id));
    TACTUS_TRY(auto opened, openedModel(version.text, options.study));
    return std::pair(std::move(opened), "the last sign-off in the study, " + version.author + ", " + version.label);
  }
  TACTUS_TRY(const auto latest, store::latestModelVersion(file));
  if (!latest) {
    return tl::unexpected(base::Error{base::ErrorCode::kData, options.study, "models", "none",
                                      "a model in the study, or --before MODEL"});
  }
  TACTUS_TRY(auto opened, openedModel(latest->text, options.study));
  std::string name = "the last version in the study" + (latest->label.empty() ? "" : ", " + latest->label);
  return std::pair(std::move(opened), std::move(name));
}

editing::SharedModel shared(OpenedModel opened) {
  return std::make_shared<const editing::ReadyModel>(
      editing::ReadyModel{std::move(opened.model), std::move(opened.compiled)});
}

/// The strokes of a file through the two models, without the renderer.
base::Result<Output> replayFile(const ReplayOptions& options, const OpenedModel& after) {
  if (options.before.empty()) {
    return tl::unexpected(
        base::Error{base::ErrorCode::kData, options.study, {}, "strokes without a model before", "--before MODEL"});
  }
  TACTUS_TRY(const auto before, openedModel(options.before));
  TACTUS_TRY(const auto text, base::readFile(options.study, kMostStrokeBytes));
  TACTUS_TRY(const auto strokes, replay::parseStrokes(before.model, text, options.study));
  TACTUS_TRY(const auto inputs, contracts::strokeInputs(before.model));
  const auto same_id = [](const auto& a, const auto& b) { return a.id == b.id; };
  if (!std::equal(before.model.inputs.begin(), before.model.inputs.end(), after.model.inputs.begin(),
                  after.model.inputs.end(), same_id)) {
    return tl::unexpected(base::Error{base::ErrorCode::kMismatch, options.model, "/inputs", "other inputs",
                                      "the inputs of " + options.before});
  }
  std::size_t felt = 0;
  std::string rows;
  base::JsonWriter json;
  json.beginObject().key("before").value(options.before).key("strokes").beginArray();
  for (const replay::NamedStroke& one : strokes) {
    const auto feel = contracts::feelOf(before.compiled, after.compiled, inputs, one.stroke);
    felt += feel.rms_jnd >= 1 ? 1 : 0;
    rows += padded(one.name, kNameWidth) + rightAligned(formatFixed(feel.rms_jnd, 2), 8) +
            rightAligned(formatFixed(feel.largest_jnd, 2), 9) + rightAligned(formatFixed(feel.at_mm, 0), 8) + '\n';
    json.beginObject().key("name").value(one.name).key("rms_jnd").value(feel.rms_jnd);
    json.key("largest_jnd").value(feel.largest_jnd).key("largest_n").value(feel.largest_n);
    json.key("at_mm").value(feel.at_mm).endObject();
  }
  const std::string head =
      std::to_string(felt) + " of " + counted(strokes.size(), "stroke") +
      " would feel different: by a just-noticeable difference (JND) or more in the mean square.\n" +
      "before: " + base::oneLine(options.before) + "\n\n" + std::string(kNameWidth, ' ') +
      " rms JND  largest   at mm\n";
  return Output{options.json ? json.endArray().endObject().text() : head + rows, after.warnings};
}

}  // namespace

base::Result<Output> replayStrokes(const ReplayOptions& options) {
  TACTUS_TRY(auto after, openedModel(options.model));
  if (options.study.ends_with(".json")) return replayFile(options, after);
  TACTUS_TRY(const auto file, store::StudyFile::open(options.study, {store::Access::kReadOnly}));
  TACTUS_TRY(auto named, modelBefore(options, file));
  replay::Conditions conditions;
  for (const std::string& entry : options.at) {
    TACTUS_TRY(const auto input, inputOption(after.model, "--at", entry));
    conditions[after.model.inputs[input.first].id] = input.second;
  }
  TACTUS_TRY(const auto stored, replay::storedStrokes(file));
  std::vector<std::string> warnings = after.warnings;
  warnings.insert(warnings.end(), stored.unreadable.begin(), stored.unreadable.end());
  auto strokes = std::make_shared<const std::vector<RecordedStroke>>(replay::recordedStrokes(stored));
  if (strokes->empty()) {
    return tl::unexpected(base::Error{base::ErrorCode::kData, options.study, "recordings", "no stroke",
                                      "strokes that were recorded while a model was felt, or in the speed experiment"});
  }
  auto& [before, name] = named;
  const StrokeBaseline baseline = replay::baselineOf(std::move(strokes), shared(std::move(before)), conditions);
  const StrokeComparison found = replay::compareStrokes(baseline, *shared(std::move(after)));
  return Output{options.json ? asJson(name, baseline, found) : asText(name, baseline, found), std::move(warnings)};
}

}  // namespace tactus::cli
