// Tables as BIDS wants them: tabs between the cells, `n/a` where a value is missing, no quotes.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace tactus::dataset {

class TsvWriter {
 public:
  /// Without names of columns the table has no header.
  TsvWriter() = default;
  explicit TsvWriter(const std::vector<std::string>& columns) { row(columns); }

  /// One row; an empty cell becomes `n/a`, and tabs and line ends in a cell become spaces.
  TsvWriter& row(const std::vector<std::string>& cells);

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// `cells` with zeros after the numbers that another one equals in text, so that all differ and none changes its value.
/// The validator 1.15 takes the first row of a motion table for names, and refuses two of one name.
std::vector<std::string> differentTexts(std::vector<std::string> cells);

/// Gives texts their labels: letters and digits only, one text one label.
class Labels {
 public:
  /// The label of `text`: its letters and digits; with a number behind where another text has that label already.
  const std::string& of(const std::string& text);

 private:
  std::vector<std::pair<std::string, std::string>> known_;  ///< text, label
};

}  // namespace tactus::dataset
