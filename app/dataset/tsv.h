// Tables as BIDS wants them: tabs between the cells, `n/a` where a value is missing, no quotes.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/json/json_writer.h"

namespace tactus::dataset {

// The JSON file beside a table of BIDS: what the table is, and what each column holds.

/// The possible values of a column and what each means, in their order.
using Levels = std::vector<std::pair<std::string, std::string>>;

class Sidecar {
 public:
  Sidecar() { json_.beginObject(); }

  Sidecar& member(std::string_view name, std::string_view value);
  Sidecar& member(std::string_view name, const char* value) { return member(name, std::string_view(value)); }
  Sidecar& member(std::string_view name, double value);
  Sidecar& member(std::string_view name, bool value);
  /// An object with `Description` alone.
  Sidecar& object(std::string_view name, std::string_view description);

  Sidecar& column(std::string_view name, std::string_view description, const Levels& levels = {});
  Sidecar& column(std::string_view name, std::string_view description, std::string_view unit);
  Sidecar& column(std::string_view name, std::string_view description, const char* unit) {
    return column(name, description, std::string_view(unit));
  }

  /// The text; nothing is added afterwards.
  std::string text() { return json_.endObject().text(); }

 private:
  base::JsonWriter json_;
};

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
