#include "core/store/entry_tables.h"

#include <utility>

#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/pair_list.h"
#include "core/store/words.h"

namespace tactus::store {
namespace {

using base::ErrorCode;

std::string conditionsText(const std::vector<study::ItemCondition>& conditions) {
  PairList pairs;
  for (const auto& condition : conditions) pairs.emplace_back(condition.input, condition.term);
  return pairListText(pairs);
}

std::vector<study::ItemCondition> parseConditions(const std::string& text) {
  auto pairs = pairListIn(text);
  if (!pairs) refuse(ErrorCode::kSchema, "rule", base::quoted(text), "a list of [input, term]");
  std::vector<study::ItemCondition> conditions;
  for (auto& [input, term] : *pairs) conditions.push_back({std::move(input), std::move(term)});
  return conditions;
}

/// `name`, an id of a term, level, series or form.
const std::string& plainName(const std::string& name, const char* place) {
  if (base::looksLikeFormula(name)) refuse(ErrorCode::kValue, place, base::quoted(name), base::kNoFormula);
  return name;
}

}  // namespace

void putColumns(Query& query, const study::ProfileRecord& record) {
  query.put(record.years_experience).put(record.insertions_per_month).put(record.category).put(record.handedness);
  query.put(record.gloves).put(record.tube_size).put(record.haptic_experience).put(record.weight);
  query.put(record.comfort);
}
void takeColumns(Query& query, study::ProfileRecord& record) {
  record.years_experience = query.numberOrNothing();
  record.insertions_per_month = query.numberOrNothing();
  record.category = query.text();
  record.handedness = query.text();
  record.gloves = query.text();
  record.tube_size = query.text();
  record.haptic_experience = query.text();
  record.weight = query.numberOrNothing();
  record.comfort = query.text();
}

void putColumns(Query& query, const study::EventRecord& record) { query.put(record.kind).putJson(record.detail); }
void takeColumns(Query& query, study::EventRecord& record) {
  record.kind = query.text();
  record.detail = query.text();
}

void putColumns(Query& query, const study::StrokeRecord& record) {
  if (record.last > record.recording.size()) {
    refuse(ErrorCode::kValue, "stroke", "an end at sample " + std::to_string(record.last),
           "one within the " + std::to_string(record.recording.size()) + " samples of its recording");
  }
  query.put(plainName(record.level, "level"))
      .put(record.number)
      .put(record.attempt)
      .put(record.practice)
      .put(record.verdict);
  query.put(static_cast<std::int64_t>(record.first)).put(static_cast<std::int64_t>(record.last));
}
void takeColumns(Query& query, study::StrokeRecord& record) {
  record.level = query.text();
  record.number = query.small();
  record.attempt = query.small();
  record.practice = query.flag();
  record.verdict = query.text();
  record.first = static_cast<std::size_t>(query.integer());
  record.last = static_cast<std::size_t>(query.integer());
}

void putColumns(Query& query, const study::JudgementRecord& record) {
  query.put(plainName(record.series, "series"))
      .put(record.step)
      .put(record.attempt)
      .put(record.commanded_n)
      .put(record.felt_n);
  query.put(wordFor(record.kind))
      .put(plainName(record.term, "term"))
      .put(record.scored)
      .put(record.catch_trial)
      .put(record.feel_again);
  query.put(record.forward_mm).put(record.forward_speed_mm_s).put(record.response_s).put(record.delivered_share);
}
void takeColumns(Query& query, study::JudgementRecord& record) {
  record.series = query.text();
  record.step = query.small();
  record.attempt = query.small();
  record.commanded_n = query.number();
  record.felt_n = query.numberOrNothing();
  record.kind = fromWord<study::ForceJudgement::Kind>(query.text());
  record.term = query.text();
  record.scored = query.flag();
  record.catch_trial = query.flag();
  record.feel_again = query.small();
  record.forward_mm = query.number();
  record.forward_speed_mm_s = query.number();
  record.response_s = query.number();
  record.delivered_share = query.numberOrNothing();
}

void putColumns(Query& query, const study::AnswerRecord& record) {
  query.put(plainName(record.form, "form")).put(record.form_version).put(record.item).put(record.position);
  const bool is_number = base::parseNumber(record.value).has_value();  // on a rating scale
  query.put(wordFor(record.status)).put(is_number ? record.value : plainName(record.value, "answer"));
  query.put(record.response_s).put(plainName(record.wording, "wording"));
}
void takeColumns(Query& query, study::AnswerRecord& record) {
  record.form = query.text();
  record.form_version = query.small();
  record.item = query.small();
  record.position = query.small();
  record.status = fromWord<study::Answer::Status>(query.text());
  record.value = query.text();
  record.response_s = query.number();
  record.wording = query.text();
}

void putColumns(Query& query, const study::RatingRecord& record) {
  query.put(record.block).put(record.effort).put(record.comfort);
}
void takeColumns(Query& query, study::RatingRecord& record) {
  record.block = query.text();
  record.effort = query.small();
  record.comfort = query.small();
}

void putColumns(Query& query, const study::RuleRecord& record) {
  for (const auto& condition : record.rule.conditions) plainName(condition.term, "rule");
  query.put(plainName(record.rule.form, "rule")).put(conditionsText(record.rule.conditions));
  query.put(plainName(record.rule.then, "rule")).put(record.rule.weight);
}
void takeColumns(Query& query, study::RuleRecord& record) {
  record.rule.form = query.text();
  record.rule.conditions = parseConditions(query.text());
  record.rule.then = query.text();
  record.rule.weight = query.number();
}

}  // namespace tactus::store
