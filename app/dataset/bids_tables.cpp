// Judgements, rules and answers as tables of BIDS.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "app/dataset/bids.h"
#include "app/dataset/tsv.h"
#include "core/base/text.h"
#include "core/study/csv_tables.h"
#include "questionnaires/questionnaire.h"

namespace tactus::dataset {
namespace {

constexpr std::string_view kTask = "insertion";

/// Where strokes on a device without force are among the data, they are accepted.
std::string_view systemOf(const study::Participant& participant) {
  return participant.virtual_device ? "virtual" : "stylus";
}

using Stroke = std::vector<const study::SpeedSample*>;
using StrokeKey = std::tuple<std::string, std::string, int>;  ///< participant, level, number

std::map<StrokeKey, Stroke> strokesOf(const study::Study& study) {
  std::map<StrokeKey, Stroke> strokes;
  for (const auto& sample : study.speeds) strokes[{sample.participant, sample.level, sample.stroke}].push_back(&sample);
  return strokes;
}

/// The mean rate in Hz, rounded to a millionth; 0 where the times do not tell it.
double rateOf(const Stroke& stroke) {
  const double length_s = stroke.back()->time_s - stroke.front()->time_s;
  if (stroke.size() < 2 || !(length_s > 0)) return 0;
  return std::round(static_cast<double>(stroke.size() - 1) / length_s * 1e6) / 1e6;
}

std::string samplesText(const Stroke& stroke) {
  TsvWriter table;
  for (const auto* sample : stroke) {
    std::vector<std::string> cells = {base::formatNumber(sample->time_s), base::formatNumber(sample->depth_mm),
                                      base::formatNumber(sample->speed_mm_s)};
    table.row(sample == stroke.front() ? differentTexts(std::move(cells)) : cells);
  }
  return table.text();
}

std::string channelsText() {
  TsvWriter table({"name", "component", "type", "tracked_point", "units"});
  table.row({"time_s", "", "LATENCY", "tube", "s"});
  table.row({"depth_mm", "", "POS", "tube", "mm"});
  table.row({"speed_mm_s", "", "VEL", "tube", "mm/s"});
  return table.text();
}

std::string motionText(const std::string& level, double rate_hz, const study::Participant& participant) {
  Sidecar sidecar;
  sidecar.member("TaskName", kTask);
  // The validator for Node refuses members of our own here.
  sidecar.member("TaskDescription",
                 "Push a tube forward in one stroke; the speed that was asked for: " + level +
                     (participant.simulated ? ". Simulated by a program, not measured" : "") +
                     (participant.virtual_device ? ". VIRTUAL: on a device that gives no force" : ""));
  sidecar.member("SamplingFrequency", rate_hz);
  sidecar.member("TrackingSystemName", systemOf(participant));
  sidecar.member("RecordingType", "continuous");
  sidecar.member("MotionChannelCount", 3.0).member("TrackedPointsCount", 1.0);
  sidecar.member("POSChannelCount", 1.0).member("VELChannelCount", 1.0).member("LATENCYChannelCount", 1.0);
  return sidecar.text();
}

std::string twoDigits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

}  // namespace

std::vector<std::string> writeMotion(const PublishedStudy& published, FileSet& files) {
  std::map<std::string, const study::Participant*> people;
  for (const auto& participant : published.study().participants) people[participant.code] = &participant;
  Labels levels;
  std::size_t left_out = 0;
  for (const auto& [key, stroke] : strokesOf(published.study())) {
    const auto& [participant, level, number] = key;
    const double rate_hz = rateOf(stroke);
    if (rate_hz <= 0) {
      ++left_out;
      continue;
    }
    const std::string path = subject(participant) + "/motion/" + subject(participant) + "_task-" + std::string(kTask) +
                             "_tracksys-" + std::string(systemOf(*people.at(participant))) + "_acq-" +
                             levels.of(level) + "_run-" + twoDigits(number) + '_';
    files.add(path + "motion.tsv", samplesText(stroke));
    files.add(path + "motion.json", motionText(level, rate_hz, *people.at(participant)));
    files.add(path + "channels.tsv", channelsText());
  }
  if (left_out == 0) return {};
  return {std::to_string(left_out) + (left_out == 1 ? " stroke is" : " strokes are") +
          " left out: a single sample, or no time between the samples, gives no sampling frequency."};
}

namespace {

/// The words of the force, and what stands in the place of one.
Levels forceLevels(const procedure::Procedure& about) {
  Levels levels;
  for (const auto& answer : about.forms.front().answers) levels.emplace_back(answer.term, answer.word);
  return levels;
}

Levels joined(Levels levels, const Levels& more) {
  levels.insert(levels.end(), more.begin(), more.end());
  return levels;
}

template <class Record>
std::vector<Record> of(const std::vector<Record>& records, const std::string& participant) {
  std::vector<Record> out;
  std::copy_if(records.begin(), records.end(), std::back_inserter(out),
               [&](const Record& record) { return record.participant == participant; });
  return out;
}

std::string pathOf(const std::string& participant, std::string_view task) {
  return subject(participant) + "/beh/" + subject(participant) + "_task-" + std::string(task) + "_beh";
}

void writeJudgements(const PublishedStudy& published, const study::Participant& participant, FileSet& files) {
  TsvWriter table({"series", "step", "force_n", "term"});
  for (const auto& judgement : of(published.study().judgements, participant.code)) {
    table.row({judgement.series, std::to_string(judgement.step), base::formatNumber(judgement.force_n),
               std::string(study::judgementText(judgement))});
  }
  Sidecar sidecar;
  sidecar.member("TaskName", "judgement").member("TaskDescription", "Judge a constant force in words");
  sidecar.member("Simulated", participant.simulated);
  if (participant.virtual_device) sidecar.member("Device", "VIRTUAL: gives no force");
  sidecar.column("series", "The order of the forces: ascending, descending or random");
  sidecar.column("step", "Place in the series, from 1");
  sidecar.column("force_n", "The force that was commanded", "N");
  sidecar.column("term", "The word for the force; n/a: no answer",
                 joined(forceLevels(procedure::of(published.study())),
                        {{"not_felt", "no force was felt"}, {"beyond_practice", "larger than in real placements"}}));
  const std::string path = pathOf(participant.code, "judgement");
  files.add(path + ".tsv", table.text());
  files.add(path + ".json", sidecar.text());
}

void writeRules(const PublishedStudy& published, const study::Participant& participant, FileSet& files) {
  const auto rules = of(published.study().rules, participant.code);
  if (rules.empty()) return;
  std::vector<std::string> columns = {"form"};
  columns.insert(columns.end(), published.inputs.begin(), published.inputs.end());
  columns.insert(columns.end(), {"then", "weight"});
  TsvWriter table(columns);
  for (const auto& rule : rules) {
    std::vector<std::string> cells = {rule.form};
    for (const auto& input : published.inputs) {
      const auto it = std::find_if(rule.conditions.begin(), rule.conditions.end(),
                                   [&](const study::ItemCondition& condition) { return condition.input == input; });
      cells.push_back(it == rule.conditions.end() ? std::string() : it->term);
    }
    cells.push_back(rule.then);
    cells.push_back(base::formatNumber(rule.weight));
    table.row(cells);
  }
  Sidecar sidecar;
  sidecar.member("TaskName", "rules").member("TaskDescription", "Rules given directly instead of through answers");
  sidecar.member("Simulated", participant.simulated);
  sidecar.column("form", "Form or reading whose depth terms the rule uses");
  for (const auto& input : published.inputs) {
    sidecar.column(input, "Term of this input in the rule's conditions; n/a: no condition");
  }
  sidecar.column("then", "The word for the force", forceLevels(procedure::of(published.study())));
  sidecar.column("weight", "Weight of the rule, 0 to 1", "1");
  const std::string path = pathOf(participant.code, "rules");
  files.add(path + ".tsv", table.text());
  files.add(path + ".json", sidecar.text());
}

/// The name of a form's table, other than the `taken` ones, to which it is added. The answers that become the rules of
/// the force model are `force_rules`.
std::string tableName(const procedure::Procedure& about, const std::string& form, std::set<std::string>& taken) {
  std::string name = form == about.forms.front().id ? "force_rules" : form;
  for (char& c : name) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (!is_plain) c = '_';
  }
  while (!taken.insert(name).second) name += "_other";
  return name;
}

/// `q07` for item 7, as in the survey files.
std::string itemColumn(int item) { return (item < 10 ? "q0" : "q") + std::to_string(item); }

/// Of one form: the value of each participant's item.
using FormAnswers = std::map<std::string, std::map<int, std::string>>;

std::string formSidecar(const procedure::Procedure& about, const std::string& form, const std::vector<int>& items,
                        bool worded) {
  const auto words = questionnaires::questionnaire(about, form, about.languages.front());
  Levels levels;
  if (words) {
    for (const auto& choice : words->choices)
      levels.emplace_back(choice.value, choice.label.empty() ? choice.value : choice.label);
  }
  levels = joined(std::move(levels), {{"cant_tell", "the participant cannot tell"},
                                      {"skipped", "no answer"},
                                      {"cleared", "answered, then withdrawn"}});
  Sidecar sidecar;
  sidecar.object("MeasurementToolMetadata", words ? words->title + " (" + form + ")" : form);
  sidecar.column("participant_id", "Participant, a code that was drawn for this data set");
  for (const int item : items) {
    std::string text = "Item " + std::to_string(item);
    if (words) {
      const auto it = std::find_if(words->questions.begin(), words->questions.end(),
                                   [&](const auto& question) { return question.number == item; });
      if (it != words->questions.end()) text = it->text;
    }
    sidecar.column(itemColumn(item), text, levels);
  }
  if (worded) {
    sidecar.column("wording", "The words in which the participant was asked",
                   {{"plain", "as in the descriptions here"}, {"published", "as in the paper's Table A1"}});
  }
  return sidecar.text();
}

}  // namespace

void writeBehavior(const PublishedStudy& published, FileSet& files) {
  for (const auto& participant : published.study().participants) {
    writeJudgements(published, participant, files);
    writeRules(published, participant, files);
  }
}

void writeEvents(const PublishedStudy& published, FileSet& files) {
  const auto described = session::trialsTable(true);
  std::vector<std::string> columns = {"onset", "duration", "trial_type"};
  Sidecar sidecar;
  sidecar.column("onset", "When the answer or the stroke was stored, since the session began", "s");
  sidecar.column("duration", "Not known of a stroke; otherwise the column response_s tells it", "s");
  sidecar.column("trial_type", "stroke, judgement or answer");
  for (const auto& column : described.columns) {
    columns.emplace_back(column.name);
    column.unit.empty() ? sidecar.column(column.name, column.meaning)
                        : sidecar.column(column.name, column.meaning, column.unit);
  }
  const std::string description = sidecar.text();
  const auto rows = session::trialRows(published.trials, true);
  for (std::size_t first = 0; first < rows.size();) {
    const session::Trial& begin = published.trials[first];
    TsvWriter table(columns);
    std::size_t end = first;
    for (; end < rows.size(); ++end) {
      const session::Trial& trial = published.trials[end];
      if (trial.participant != begin.participant || trial.session != begin.session) break;
      std::vector<std::string> cells = {base::formatNumber(trial.time_s), "", std::string(session::name(trial.kind))};
      cells.insert(cells.end(), rows[end].begin(), rows[end].end());
      table.row(cells);
    }
    const std::string name = subject(begin.participant);
    const std::string path = name + "/beh/" + name + "_task-session_run-" + std::to_string(begin.session) + "_events";
    files.add(path + ".tsv", table.text());
    files.add(path + ".json", description);
    first = end;
  }
}

void writePhenotype(const PublishedStudy& published, FileSet& files) {
  std::map<std::string, FormAnswers> forms;
  std::map<std::string, std::map<std::string, std::string>> wordings;  // of a form, by participant
  for (const auto& answer : published.study().answers) {
    const bool is_answered = answer.status == study::Answer::Status::kAnswered;
    forms[answer.form][answer.participant][answer.item] =
        is_answered ? answer.term : std::string(study::statusText(answer.status));
    if (!answer.wording.empty()) wordings[answer.form][answer.participant] = answer.wording;
  }
  std::set<std::string> taken;
  for (const auto& [form, answers] : forms) {
    std::vector<int> items;
    for (const auto& [participant, values] : answers) {
      for (const auto& [item, value] : values) items.push_back(item);
    }
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    std::vector<std::string> columns = {"participant_id"};
    for (const int item : items) columns.push_back(itemColumn(item));
    const bool worded = wordings.contains(form);
    if (worded) columns.emplace_back("wording");
    TsvWriter table(columns);
    for (const auto& participant : published.study().participants) {
      const auto found = answers.find(participant.code);
      const std::map<int, std::string> values = found == answers.end() ? std::map<int, std::string>() : found->second;
      std::vector<std::string> cells = {subject(participant.code)};
      for (const int item : items) cells.push_back(values.contains(item) ? values.at(item) : std::string());
      if (worded) cells.push_back(wordings.at(form)[participant.code]);
      table.row(cells);
    }
    const std::string path = "phenotype/" + tableName(procedure::of(published.study()), form, taken);
    files.add(path + ".tsv", table.text());
    files.add(path + ".json", formSidecar(procedure::of(published.study()), form, items, worded));
  }
}

}  // namespace tactus::dataset
