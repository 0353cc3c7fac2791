// A form's wording: in another language, or in plainer words than the paper's. Data, never code.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"

namespace tactus::questionnaires {

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

/// Reads a wording (JSON, see forms/ngt_force_v1.de.json) from `text`; `file` is its name in errors. Returns an error
/// for a missing key, or a duplicate phrase, item or answer.
base::Result<Wording> parseWording(std::string_view text, const std::string& file);

}  // namespace tactus::questionnaires
