// A form as displayed: its questions and choices in one language.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/procedure/procedure.h"
#include "core/study/records.h"
#include "questionnaires/form_file.h"

namespace tactus::questionnaires {

// A form's wording: in another language, or in plainer words than the paper's. Data, never code.

/// One wording of a form. An item is either worded as a whole, by its number, or composed: the phrases of its
/// conditions, then the question.
struct Wording {
  struct Phrase {
    study::ItemCondition condition;
    std::string text;
  };
  struct Label {
    std::string value;  ///< stored value: a term id, or a point of a scale
    std::string text;
  };
  struct Item {
    int number = 0;
    std::string text;
  };

  std::string form;  ///< form id
  int version = 1;   ///< of the form
  /// Id of the words, the same in all languages into which they are put: `plain`; `published`, those of the paper.
  std::string wording;
  std::string language;
  std::string title;
  std::string instructions;
  std::string remark;        ///< for the researcher, e.g. that the translation was not reviewed; may be empty
  std::string question;      ///< after the phrases; empty if items are worded as a whole
  std::string joiner = " ";  ///< between phrases, and before the question; empty in Chinese
  /// Inputs in the order of their phrases; empty: as in the item. Inputs that are not named come last.
  std::vector<std::string> order;
  std::vector<Phrase> phrases;
  std::vector<Item> items;
  std::vector<Label> answers;

  /// The phrases of `conditions` in their order and the question, joined. Nothing if a condition has no phrase.
  std::optional<std::string> sentence(const std::vector<study::ItemCondition>& conditions) const;
  const std::string* item(int number) const;
  const std::string* answer(std::string_view value) const;
};

/// Reads a wording (JSON, docs/procedure-packs.md) from `text`; `file` is its name in errors. Returns an error
/// for a missing key, or a duplicate phrase, item or answer.
base::Result<Wording> parseWording(std::string_view text, const std::string& file);

/// One possible answer.
struct Choice {
  std::string value;  ///< stored value: a term id, or a point of a scale
  std::string label;  ///< displayed text; empty for an unnamed point of a scale

  bool operator==(const Choice&) const = default;
};

struct Question {
  int number = 0;  ///< the form's item number
  std::string text;
  int block = 1;  ///< from 1: neighboring items that differ in the place of the tip alone; 1 throughout a scale

  bool operator==(const Question&) const = default;
};

struct Questionnaire {
  std::string form;     ///< form id
  int version = 1;      ///< of the form
  std::string wording;  ///< id of the words
  std::string language;
  std::string title;
  std::string instructions;  ///< may be empty
  std::string remark;        ///< on the wording, for the researcher; may be empty
  std::vector<Choice> choices;
  std::vector<Question> questions;  ///< in the order of the form

  bool operator==(const Questionnaire&) const = default;

  /// The choice with the stored value `value`, or null.
  const Choice* choice(std::string_view value) const;
};

/// Id of the paper's own words.
inline constexpr std::string_view kPublishedWording = "published";

/// `form` in the words of its items, in the language `language`. `way`: the input of the regions (Question::block).
Questionnaire asPrinted(const study::Form& form, std::string_view way, std::string_view language);
Questionnaire asPrinted(const ScaleForm& form);

/// `form` in the words of `wording`. Returns an error for a wording of another form or version, or a condition or
/// answer without words.
base::Result<Questionnaire> inWords(const study::Form& form, const Wording& wording, std::string_view way);
base::Result<Questionnaire> inWords(const ScaleForm& form, const Wording& wording);

/// The ids of the forms to fill in: those of the procedure, and `usability-v1` (paper, Section 5.4).
std::vector<std::string> questionnaireIds(const procedure::Procedure& procedure);

/// Refuses, with one sentence, a procedure whose wordings cannot be read, are of no form of it, or lack words; and a
/// form without a wording in the procedure's first language.
base::Result<void> checkWordings(const procedure::Procedure& procedure);

/// The ids of the wordings of a form, first the one in which it is asked where nobody says otherwise: `plain`,
/// `published`. Empty for an unknown form.
std::vector<std::string> wordingsOf(const procedure::Procedure& procedure, std::string_view form);

/// The languages of one of a form's wordings; an empty `wording` is the form's first.
std::vector<std::string> languagesOf(const procedure::Procedure& procedure, std::string_view form,
                                     std::string_view wording = {});

/// A form of the procedure in one of its wordings and languages; an empty `wording` is the form's first. So the
/// screens, paper and each survey system ask the same. For an unknown form, wording or language returns an error with
/// the list of known ones.
base::Result<Questionnaire> questionnaire(const procedure::Procedure& procedure, std::string_view form,
                                          std::string_view language, std::string_view wording = {});

/// The composed words of `form` in `language`, for screens that show condition, region and question apart. Refused as
/// in `questionnaire`.
base::Result<Wording> composedWording(const procedure::Procedure& procedure, std::string_view form,
                                      std::string_view language);

}  // namespace tactus::questionnaires
