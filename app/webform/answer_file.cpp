#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "app/session/profile_questions.h"
#include "app/webform/answers.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_members.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"

namespace tactus::webform {
namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::required;
using base::Result;
using Status = study::Answer::Status;

constexpr std::array<std::string_view, 4> kStatuses = {"answered", "skipped", "cant_tell", "cleared"};
constexpr std::array<std::string_view, 2> kGiven = {"page", "typed"};
constexpr base::NumberRange kCount{0, std::numeric_limits<int>::max()};
constexpr double kLongestS = 1e9;
/// Of times that a clock shows: 2000 to 2200.
constexpr std::int64_t kFirstMs = 946'684'800'000;
constexpr std::int64_t kLastMs = 7'258'118'400'000;

/// Milliseconds of `2026-11-28T10:14:32.123Z`, as browsers write it; nothing for another text.
std::optional<std::int64_t> utcMs(std::string_view text) {
  constexpr std::string_view kShape = "dddd-dd-ddTdd:dd:dd.dddZ";
  if (text.size() != kShape.size()) return std::nullopt;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (kShape[i] == 'd' ? !base::isDigit(text[i]) : text[i] != kShape[i]) return std::nullopt;
  }
  const auto part = [&](std::size_t from, std::size_t size) {
    return static_cast<int>(base::parseInteger(text.substr(from, size)).value_or(0));
  };
  const std::chrono::year_month_day day{std::chrono::year(part(0, 4)),
                                        std::chrono::month(static_cast<unsigned>(part(5, 2))),
                                        std::chrono::day(static_cast<unsigned>(part(8, 2)))};
  const int hours = part(11, 2);
  const int minutes = part(14, 2);
  const int seconds = part(17, 2);
  if (!day.ok() || hours > 23 || minutes > 59 || seconds > 59) return std::nullopt;
  const std::chrono::sys_days days{day};
  return ((std::int64_t{days.time_since_epoch().count()} * 24 + hours) * 60 + minutes) * 60'000 + seconds * 1000 +
         part(20, 3);
}

void readId(JsonMembers& members, std::string_view key, study::RecordId& id) {
  std::string text;
  members.text(required(key), text);
  if (const auto parsed = study::parseRecordId(text)) {
    id = *parsed;
  } else {
    members.refuse(key, "32 hexadecimal digits");
  }
}

void readAnswer(JsonMembers& members, FileAnswer& answer) {
  members.integer(required("item"), answer.item, {1, std::numeric_limits<int>::max()});
  if (const auto term = members.child(required("term")); term && term->kind() != base::JsonKind::kNull)
    members.text("term", answer.term);
  const auto status = members.word(required("status"), kStatuses);
  if (!status) {
    members.refuse("status", "one of answered, skipped, cant_tell, cleared");
    return;
  }
  constexpr std::array kInOrder = {Status::kAnswered, Status::kSkipped, Status::kCantTell, Status::kCleared};
  answer.status = kInOrder[*status];
  members.integer(required("utc_ms"), answer.utc_ms);
  if (answer.utc_ms < kFirstMs || answer.utc_ms > kLastMs)
    members.refuse("utc_ms", std::to_string(answer.utc_ms), "milliseconds since 1970 of the years 2000 to 2199");
  members.integer(required("changes"), answer.changes, kCount);
  members.number("response_s", answer.response_s, {0, kLongestS});
  if ((answer.status == Status::kAnswered) == answer.term.empty()) {
    members.refuse("term",
                   answer.term.empty() ? "no term with the status answered"
                                       : base::quoted(answer.term) + " without the status answered",
                   "a term where an item is answered, and null elsewhere");
  }
}

void readAnswers(JsonMembers& members, std::string_view key, std::vector<FileAnswer>& answers,
                 std::optional<base::Error>& error) {
  if (!members.child(required(key))) return;
  for (const base::JsonValue value : members.elements(required(key))) {
    JsonMembers part(value, error);
    FileAnswer answer;
    readAnswer(part, answer);
    if (error) return;
    answers.push_back(std::move(answer));
  }
}

void readProfile(const base::JsonValue& profile, JsonMembers& members, std::vector<FileProfile>& out) {
  for (const base::JsonValue value : profile) {
    FileProfile one{std::string(value.key()), {}};
    members.textOrEmpty(value.key(), one.value);
    out.push_back(std::move(one));
  }
}

void appendAnswers(const std::vector<FileAnswer>& answers, std::string& text) {
  text += "\nanswers " + std::to_string(answers.size());
  for (const FileAnswer& one : answers) {
    text += '\n' + std::to_string(one.item) + ' ' + std::string(kStatuses[static_cast<std::size_t>(one.status)]) + ' ' +
            (one.term.empty() ? "-" : one.term) + ' ' + std::to_string(one.utc_ms) + ' ' + std::to_string(one.changes);
  }
}

}  // namespace

static_assert(static_cast<int>(Status::kAnswered) == 0 && static_cast<int>(Status::kCleared) == 3);

Result<AnswerFile> parseAnswerFile(std::string_view text, const std::string& file) {
  return base::readJson(text, file, [](JsonMembers& members, std::optional<base::Error>& error) {
    AnswerFile out;
    members.format("tactus-answers");
    members.version(required("version"));
    if (error) return out;
    readId(members, "study", out.study);
    members.text(required("form"), out.form);
    members.text(required("wording"), out.wording);
    members.text(required("form_sha256"), out.form_sha256);
    members.text(required("language"), out.language);
    if (const auto person = members.object(required("participant"))) {
      JsonMembers part(*person, error);
      part.text(required("code"), out.code);
      if (base::trimmed(out.code) != out.code || base::looksLikeFormula(out.code) || study::codeKey(out.code).empty())
        part.refuse("code", base::quoted(out.code), "a participant's code");
      const auto given = part.word(required("given"), kGiven);
      if (!given) part.refuse("given", "page or typed");
      out.code_typed = given == 1U;
      readId(part, "run", out.run);
    }
    if (const auto consent = members.object(required("consent"))) {
      JsonMembers part(*consent, error);
      part.textOrEmpty(required("version"), out.consent_version);
      part.text(required("time"), out.consent_time);
      part.text(required("language"), out.consent_language);
      part.textOrEmpty(required("text"), out.consent_text);
      const auto time = utcMs(out.consent_time);
      if (!time) part.refuse("time", base::quoted(out.consent_time), "a time such as 2026-11-28T10:14:32.000Z");
      out.consent_utc_ms = time.value_or(0);
    } else {
      members.refuse("consent", "no consent", "the version and time of the participant's consent");
    }
    if (const auto profile = members.object(required("profile"))) {
      JsonMembers part(*profile, error);
      readProfile(*profile, part, out.profile);
    }
    readAnswers(members, "answers", out.answers, error);
    readAnswers(members, "usability", out.usability, error);
    members.text(required("check_code"), out.check_code);
    return out;
  });
}

std::string checkCodeOf(const AnswerFile& answers) {
  std::string text = "tactus-answers 1\n" + toText(answers.study) + '\n' + answers.form + ' ' + answers.wording + '\n' +
                     answers.form_sha256 + '\n' + answers.language + '\n' + answers.code + '\n' +
                     (answers.code_typed ? "typed " : "page ") + toText(answers.run) + '\n' + answers.consent_version +
                     '\n' + answers.consent_time + '\n' + answers.consent_text;
  for (const auto& [field, value] : answers.profile) text += '\n' + field + '=' + value;
  appendAnswers(answers.answers, text);
  appendAnswers(answers.usability, text);
  constexpr std::string_view kLetters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
  // Five bits for each letter, from the beginning of the hash.
  std::uint64_t bits = 0;
  for (const char c : base::sha256(text).substr(0, 10))
    bits = bits * 16 + static_cast<std::uint64_t>(c <= '9' ? c - '0' : c - 'a' + 10);
  std::string code;
  for (int letter = 7; letter >= 0; --letter) {
    code += kLetters[(bits >> (5 * static_cast<unsigned>(letter))) & 31U];
    if (letter == 4) code += '-';
  }
  return code;
}

namespace {

Result<void> checkItems(const std::vector<FileAnswer>& answers, const questionnaires::Questionnaire& asked,
                        const std::string& list, bool cant_tell) {
  std::map<int, bool> seen;
  for (const auto& question : asked.questions) seen[question.number] = false;
  const std::string range =
      std::to_string(asked.questions.front().number) + " to " + std::to_string(asked.questions.back().number);
  for (const FileAnswer& one : answers) {
    const std::string place = list + ", item " + std::to_string(one.item);
    const auto known = seen.find(one.item);
    if (known == seen.end())
      return base::fail(ErrorCode::kReference, list, "the item " + std::to_string(one.item),
                        "the items " + range + " of " + base::quoted(asked.form));
    if (known->second) return base::fail(ErrorCode::kSchema, place, "a second answer", "one answer to each item");
    known->second = true;
    if (one.status == Status::kCantTell && !cant_tell)
      return base::fail(ErrorCode::kValue, place, "cant_tell", "an answer that the form offers");
    if (one.status == Status::kAnswered && asked.choice(one.term) == nullptr) {
      std::vector<std::string> terms;
      for (const auto& choice : asked.choices) terms.push_back(choice.value);
      return base::fail(ErrorCode::kReference, place, "the term " + base::quoted(one.term),
                        "one of " + base::joined(terms, ", "));
    }
  }
  for (const auto& [number, answered] : seen) {
    if (!answered)
      return base::fail(ErrorCode::kSchema, list, "no item " + std::to_string(number),
                        "all items " + range + ", skipped ones too");
  }
  return {};
}

Result<void> checkProfile(const std::vector<FileProfile>& profile) {
  for (const auto& [field, value] : profile) {
    const session::ProfileQuestion* const question = session::profileQuestion(field);
    if (question == nullptr || value.empty()) continue;  // another version may ask more
    std::vector<std::string> known;
    for (const auto& offer : question->offers) known.emplace_back(offer.stored);
    if (std::find(known.begin(), known.end(), value) == known.end())
      return base::fail(ErrorCode::kReference, "profile, " + field, base::quoted(value),
                        "one of " + base::joined(known, ", "));
  }
  return {};
}

Result<const FormContent*> answeredOf(const AnswerFile& answers, std::span<const FormContent> forms) {
  const study::RecordId& study = forms.front().study;
  if (answers.study != study)
    return base::fail(ErrorCode::kReference, "study", "the form of the study " + toText(answers.study),
                      "a form of this study, " + toText(study));
  const auto same = [&](const FormContent& form) { return form.sha256 == answers.form_sha256; };
  const auto form = std::find_if(forms.begin(), forms.end(), same);
  if (form == forms.end())
    return base::fail(ErrorCode::kMismatch, "form_sha256", base::quoted(answers.form_sha256),
                      "the hash of a form of this study; the last is " + forms.back().sha256);
  if (answers.form != form->form)
    return base::fail(ErrorCode::kReference, "form", base::quoted(answers.form), base::quoted(form->form));
  if (answers.wording != form->wording)
    return base::fail(ErrorCode::kReference, "wording", base::quoted(answers.wording), base::quoted(form->wording));
  std::vector<std::string> languages;
  for (const FormLanguage& language : form->languages) languages.push_back(language.id);
  for (const std::string& language : {answers.language, answers.consent_language}) {
    if (form->language(language) == nullptr)
      return base::fail(ErrorCode::kReference, "language", base::quoted(language),
                        "one of " + base::joined(languages, ", "));
  }
  if (answers.consent_version != form->consent_version)
    return base::fail(ErrorCode::kMismatch, "consent", "version " + base::quoted(answers.consent_version),
                      "version " + base::quoted(form->consent_version));
  if (auto ok = checkProfile(answers.profile); !ok) return tl::unexpected(ok.error());
  const FormLanguage& words = form->languages.front();
  const bool force = form->form != words.scale.form;
  if (auto ok = checkItems(answers.answers, words.asked, "answers", force); !ok) return tl::unexpected(ok.error());
  if (!answers.usability.empty()) {
    if (auto ok = checkItems(answers.usability, words.scale, "usability", false); !ok)
      return tl::unexpected(ok.error());
  }
  if (const std::string code = checkCodeOf(answers); code != answers.check_code)
    return base::fail(
        ErrorCode::kMismatch, "check_code", base::quoted(answers.check_code),
        base::quoted(code) + ", the check code of what the file holds; it was changed after it was saved");
  return &*form;
}

}  // namespace

Result<const FormContent*> formAnswered(const AnswerFile& answers, std::span<const FormContent> forms,
                                        const std::string& file) {
  auto form = answeredOf(answers, forms);
  if (!form) return base::inFile(form.error(), file);
  return form;
}

}  // namespace tactus::webform
