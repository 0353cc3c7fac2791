// A form as displayed: its questions and choices in one language.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "questionnaires/scale_form.h"
#include "questionnaires/wording.h"

namespace tactus::questionnaires {

/// One possible answer.
struct Choice {
  std::string value;  ///< stored value: a term id, or a point of a scale
  std::string label;  ///< displayed text; empty for an unnamed point of a scale

  bool operator==(const Choice&) const = default;
};

struct Question {
  int number = 0;  ///< the form's item number
  std::string text;

  bool operator==(const Question&) const = default;
};

struct Questionnaire {
  std::string form;  ///< form id
  int version = 1;   ///< of the form
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

/// `form` in its original wording, in the language `en`.
Questionnaire asPrinted(const study::Form& form);
Questionnaire asPrinted(const ScaleForm& form);

/// `form` in the words of `wording`. Returns an error for a wording of another form or version, or a condition or
/// answer without words.
base::Result<Questionnaire> inWords(const study::Form& form, const Wording& wording);
base::Result<Questionnaire> inWords(const ScaleForm& form, const Wording& wording);

/// The ids of the forms to fill in: `ngt-force-v1` (Table A1), `usability-v1` (paper, Section 5.4).
std::vector<std::string> questionnaireIds();

/// The embedded languages of a form. The first is `en`, the paper's wording.
std::vector<std::string> languagesOf(std::string_view form);

/// An embedded form in one of its languages. For an unknown form or language returns an error with the list of known
/// ones.
base::Result<Questionnaire> questionnaire(std::string_view form, std::string_view language);

}  // namespace tactus::questionnaires
