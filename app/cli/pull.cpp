#include "core/analysis/pull/pull.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "app/cli/pull_text.h"
#include "app/cli/terminal.h"
#include "app/editing/edit.h"
#include "app/version.h"
#include "core/analysis/pull/pull_curve.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/fuzzy/force_model.h"
#include "core/model_io/model_file.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::cli {
namespace {

/// A reference curve or band from a CSV table.
struct ReadReference {
  analysis::ReferenceCurve curve;
  std::vector<std::string> warnings;
};

using base::CsvTable;
using base::ErrorCode;

constexpr std::size_t kMostRows = 10'000;  // a search looks at each of them some ten thousand times

/// The column of each input that the table has, and of the forces.
struct ReferenceColumns {
  std::vector<std::optional<std::size_t>> inputs;
  std::optional<std::size_t> low, high;
};

/// `depth`, or with its unit `depth_mm`.
std::optional<std::size_t> columnOf(const CsvTable& table, const fuzzy::Variable& variable,
                                    const std::string& ending = {}) {
  const auto plain = table.find(variable.id + ending);
  return plain ? plain : table.find(variable.id + ending + "_" + base::columnKey(variable.unit));
}

base::Result<ReferenceColumns> referenceColumns(const CsvTable& table, const fuzzy::ForceModel& model) {
  ReferenceColumns out;
  std::vector<std::string> ids;
  bool any = false;
  for (const auto& input : model.inputs) {
    out.inputs.push_back(columnOf(table, input));
    any = any || out.inputs.back();
    ids.push_back(input.id);
  }
  const auto refuse = [&](std::string wanted) {
    return base::inFile({ErrorCode::kSchema, {}, "header", base::joined(table.columns(), ", "), std::move(wanted)},
                        table.file());
  };
  if (!any) return refuse("a column of an input: " + base::joined(ids, ", "));
  const std::string& name = model.output.id;
  out.low = columnOf(table, model.output, "_min");
  out.high = columnOf(table, model.output, "_max");
  const auto force = columnOf(table, model.output);
  if (force && (out.low || out.high)) return refuse("either " + name + ", or " + name + "_min and " + name + "_max");
  if (force) out.low = out.high = force;
  if (!out.low && !out.high) return refuse("a column " + name + ", or " + name + "_min, " + name + "_max or both");
  return out;
}

/// The value of an input in a row.
base::Result<double> inputValue(const CsvTable& table, std::size_t row, std::size_t column,
                                const fuzzy::Variable& input) {
  const auto value = table.number(row, column);
  if (!value || (*value >= input.min && *value <= input.max)) return value;
  return table.refuse(row, column, ErrorCode::kValue,
                      "a value from " + base::formatNumber(input.min) + " to " + base::formatNumber(input.max));
}

/// Reads the file `path`: columns named after inputs, with or without their unit (`depth`, `depth_mm`; at least one,
/// the others are at their values in `point`), and the output in the same way, or a band by `force_min`, `force_max` or
/// both. Rows without a force are gaps. At most 10,000 rows.
base::Result<ReadReference> readReference(const std::string& path, const fuzzy::ForceModel& model,
                                          std::span<const double> point) {
  TACTUS_TRY(const auto table, CsvTable::read(path));
  TACTUS_TRY(const auto columns, referenceColumns(table, model));
  if (table.rowCount() == 0 || table.rowCount() > kMostRows) {
    return base::inFile(
        {ErrorCode::kLimit, {}, {}, std::to_string(table.rowCount()) + " rows", "1 to " + std::to_string(kMostRows)},
        path);
  }
  ReadReference out;
  if (auto note = table.note()) out.warnings.push_back(std::move(*note));
  out.curve.columns.resize(model.inputs.size());
  constexpr double kFree = std::numeric_limits<double>::infinity();
  const auto isGap = [&](std::size_t row, const std::optional<std::size_t>& column) {
    return !column || base::trimmed(table.cell(row, *column)).empty();
  };
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    const bool no_low = isGap(row, columns.low);
    const bool no_high = isGap(row, columns.high);
    if (no_low && no_high) continue;
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const auto& column = columns.inputs[i];
      TACTUS_TRY(const auto value,
                 column ? inputValue(table, row, *column, model.inputs[i]) : base::Result<double>(point[i]));
      out.curve.columns[i].push_back(value);
    }
    TACTUS_TRY(const auto low, no_low ? base::Result<double>(-kFree) : table.number(row, *columns.low));
    TACTUS_TRY(const auto high, no_high ? base::Result<double>(kFree) : table.number(row, *columns.high));
    if (low > high) {
      return table.refuse(row, *columns.high, ErrorCode::kValue,
                          "at least force_min, which is " + base::formatNumber(low));
    }
    out.curve.low_n.push_back(low);
    out.curve.high_n.push_back(high);
  }
  return out;
}

// The edits that come nearest to a reference curve, in words and as JSON.

/// The force at the point of the pull, beside what was found.
struct CurveQuestion {
  const fuzzy::ForceModel& model;
  std::optional<double> before_n;  ///< nothing in a hole
  std::optional<double> target_n;
  bool rules_left_out = false;  ///< the pull was of a mean
};

using base::formatFixed;

constexpr std::size_t kMostShown = 3;

std::string asText(const CurveQuestion& question, const analysis::CurvePull& pull, const PullNotes& notes) {
  std::string sentence =
      "The force is " + formatFixed(pull.residual_n, 3) + " N (root mean square) from the reference.";
  if (const auto left = blockerText(pull); !left.empty()) sentence += " Out of reach: " + left + ".";
  if (pull.candidates.empty() && pull.close) sentence += " Nothing has to change.";
  std::string text = wrapped(sentence, "", 0);
  std::size_t shown = 0;
  for (; shown < pull.candidates.size() && shown < kMostShown; ++shown) {
    const analysis::CurveCandidate& one = pull.candidates[shown];
    text += "\n" + wrapped(candidateText(question.model, one), padded(std::to_string(shown + 1), 4), 4);
    text += wrapped(elsewhereText(one.candidate), "    ", 4) + findingsText(notes.findings(one.candidate));
  }
  if (pull.candidates.size() > shown)
    text += "\n" + std::to_string(pull.candidates.size() - shown) + " more with --json\n";
  if (question.rules_left_out) text += "\nA rule belongs to one expert: its edits are offered with --expert ID.\n";
  return text;
}

std::string asJson(const CurveQuestion& question, const analysis::CurvePull& pull, const PullNotes& notes) {
  base::JsonWriter json;
  json.beginObject().key("before_n").value(question.before_n).key("target_n").value(question.target_n);
  json.key("residual_n").value(pull.residual_n).key("reachable").null().key("blocker");
  const std::string left = blockerText(pull);
  pull.close ? json.null() : json.value(left);
  writeSignOffs(json, notes.sign_offs);
  json.key("candidates").beginArray();
  for (const analysis::CurveCandidate& one : pull.candidates) {
    json.beginObject();
    writeMembers(json, question.model, one.candidate, notes.findings(one.candidate));
    json.key("residual_n").value(one.residual_n);
    json.key("text").value(candidateText(question.model, one)).endObject();
  }
  return json.endArray().endObject().text();
}

using base::ErrorCode;

/// The word for all rules in `--lock`, unless a variable is called so.
constexpr std::string_view kRules = "rules";

/// The text of the model after a candidate. The checks keep their points and get the new forces.
base::Result<std::string> editedText(const PullOptions& options, const OpenedModel& opened,
                                     const analysis::PullCandidate& candidate, const std::string& text) {
  TACTUS_TRY(auto edit, editing::finished(applied(opened.model, candidate.edits), text));
  editing::refreshChecks(edit.model, edit.compiled);
  edit.model.created_utc = base::formatUtc(std::chrono::system_clock::now());
  edit.model.generator = kGenerator;
  if (auto& from = edit.model.provenance) from->notes += (from->notes.empty() ? "" : " ") + edit.label + ".";
  return model_io::modelText(edit.model, options.out);
}

/// What an answer of either kind comes to on the screen and in a file.
struct Answer {
  std::vector<analysis::PullCandidate> candidates;
  std::vector<std::string> texts;  ///< one for each
  std::string text;                ///< for standard output
  std::vector<std::string> warnings;
};

/// A model, a point of it, and what is asked.
struct Question {
  OpenedModel opened;
  std::vector<double> point;
  analysis::PullSettings settings;
  std::optional<analysis::NewFindings> findings = {};
  std::vector<SignOff> sign_offs = {};
};

/// The point of `--pin`: the inputs that it names, and the others as in `point`.
base::Result<std::vector<double>> pinOption(const fuzzy::ForceModel& model, const std::string& text,
                                            std::vector<double> point) {
  std::istringstream entries(text);
  for (std::string entry; std::getline(entries, entry, ',');) {
    TACTUS_TRY(const auto input, inputOption(model, "--pin", entry));
    point[input.first] = input.second;
  }
  return point;
}

base::Result<Question> questionOf(const PullOptions& options) {
  TACTUS_TRY(auto opened, openedModel(options.model));
  Question out{std::move(opened), {}, {}};
  const fuzzy::ForceModel& model = out.opened.model;
  TACTUS_TRY(const auto expert, expertOption(model, options.model, options.expert));
  out.settings.expert = expert;
  for (const std::string& id : options.locked) {
    auto variable = variableOption(model, "--lock", id);
    if (variable) {
      out.settings.locked.push_back(*variable);
    } else if (id == kRules) {
      out.settings.lock_rules = true;
    } else {
      variable.error().wanted += ", or " + std::string(kRules);
      return tl::unexpected(variable.error());
    }
  }
  TACTUS_TRY(auto point, pointOption(model, "--at", options.at));
  out.point = std::move(point);
  if (auto ok = analysis::checkPoint(model, out.point); !ok) {
    ok.error().place = "--at " + ok.error().place;
    return tl::unexpected(ok.error());
  }
  for (const std::string& pin : options.pins) {
    TACTUS_TRY(auto pinned, pinOption(model, pin, out.point));
    if (auto ok = analysis::checkPoint(model, pinned); !ok) {
      ok.error().place = "--pin " + ok.error().place;
      return tl::unexpected(ok.error());
    }
    out.settings.pins.push_back(std::move(pinned));
  }
  return out;
}

std::vector<std::string> findingsAfter(const Question& question, const analysis::PullCandidate& one) {
  return question.findings->of(applied(question.opened.model, one.edits));
}

PullNotes notesOf(const Question& question) {
  return {[&question](const analysis::PullCandidate& one) { return findingsAfter(question, one); }, question.sign_offs};
}

bool leavesRulesOut(const Question& question) {
  return !question.settings.expert && question.opened.model.experts.size() > 1;
}

base::Result<Answer> pointAnswer(const PullOptions& options, const Question& question) {
  const fuzzy::ForceModel& model = question.opened.model;
  TACTUS_TRY(auto found, analysis::pull(model, question.point, *options.force_n, elicitation::justNoticeableDifference,
                                        question.settings));
  Answer out;
  const PullNotes notes = notesOf(question);
  out.text = options.json ? asJson(model, found, notes) : asText(model, found, leavesRulesOut(question), notes);
  for (const auto& one : found.candidates) out.texts.push_back(candidateText(model, one));
  out.candidates = std::move(found.candidates);
  return out;
}

base::Result<Answer> curveAnswer(const PullOptions& options, const Question& question) {
  const fuzzy::ForceModel& model = question.opened.model;
  TACTUS_TRY(auto reference, readReference(options.curve, model, question.point));
  const auto found = analysis::pullToCurve(model, question.point, reference.curve,
                                           elicitation::justNoticeableDifference, question.settings);
  if (!found) return base::inFile(found.error(), options.curve);
  const auto& compiled = question.opened.compiled;
  const auto now = question.settings.expert ? compiled.evaluateExpert(*question.settings.expert, question.point)
                                            : compiled.evaluate(question.point);
  const CurveQuestion asked{model, now.fired ? std::optional(now.force_n) : std::nullopt, options.force_n,
                            leavesRulesOut(question)};
  Answer out;
  out.warnings = std::move(reference.warnings);
  if (found->left_out > 0) {
    out.warnings.push_back(options.curve + ": " + std::to_string(found->left_out) +
                           " points at which no rule fires are left out");
  }
  const PullNotes notes = notesOf(question);
  out.text = options.json ? asJson(asked, *found, notes) : asText(asked, *found, notes);
  for (const auto& one : found->candidates) {
    out.candidates.push_back(one.candidate);
    out.texts.push_back(candidateText(model, one));
  }
  return out;
}

/// Other experts than the pulled one whose forces an edit of shared terms moves too.
std::optional<std::string> sharedNote(const Question& question, const Answer& answer) {
  const fuzzy::ForceModel& model = question.opened.model;
  if (!question.settings.expert || model.experts.size() == 1) return std::nullopt;
  for (const auto& candidate : answer.candidates) {
    for (const auto& edit : candidate.edits) {
      if (editsRule(edit.gesture) || !edit.list.owner.empty() || readersOf(model, edit.list).size() < 2) continue;
      return "the experts share terms: an edit of them changes the forces of others than " +
             model.experts[*question.settings.expert].id;
    }
  }
  return std::nullopt;
}

}  // namespace

base::Result<Output> pull(const PullOptions& options) {
  if (auto ok = requireOutput(options.out, {options.model, options.curve, options.study}); !ok)
    return tl::unexpected(ok.error());
  TACTUS_TRY(auto question, questionOf(options));
  if (!options.study.empty()) {
    TACTUS_TRY(auto sign_offs, signOffsOn(question.opened.model, options.study));
    question.sign_offs = std::move(sign_offs);
  }
  question.findings.emplace(question.opened.model, question.opened.compiled);
  TACTUS_TRY(auto answer, options.curve.empty() ? pointAnswer(options, question) : curveAnswer(options, question));

  std::vector<std::string> warnings = question.opened.warnings;
  warnings.insert(warnings.end(), answer.warnings.begin(), answer.warnings.end());
  for (const SignOff& one : question.sign_offs) {
    warnings.push_back("every edit contradicts a sign-off: " + one.author + ", " + one.utc + ": " + one.text);
  }
  if (auto note = sharedNote(question, answer)) warnings.push_back(std::move(*note));
  if (!options.apply) return Output{std::move(answer.text), std::move(warnings)};
  const std::size_t count = answer.candidates.size();
  if (*options.apply > count) {
    return base::fail(ErrorCode::kValue, "--apply", std::to_string(*options.apply),
                      count == 0 ? "an edit, but there is none" : "a number from 1 to " + std::to_string(count));
  }
  const std::string& text = answer.texts[*options.apply - 1];
  const auto& chosen = answer.candidates[*options.apply - 1];
  TACTUS_TRY(const auto edited, editedText(options, question.opened, chosen, text));
  for (const std::string& finding : findingsAfter(question, chosen)) warnings.push_back("new finding: " + finding);
  return written(
      options.out, edited,
      {options.json ? std::move(answer.text) : base::oneLine(options.out) + ": " + text + "\n", std::move(warnings)},
      options.json);
}

}  // namespace tactus::cli
