#include "app/dataset/tsv.h"

#include <algorithm>

namespace tactus::dataset {

Sidecar& Sidecar::member(std::string_view name, std::string_view value) {
  json_.key(name).value(value);
  return *this;
}

Sidecar& Sidecar::member(std::string_view name, double value) {
  json_.key(name).value(value);
  return *this;
}

Sidecar& Sidecar::member(std::string_view name, bool value) {
  json_.key(name).value(value);
  return *this;
}

Sidecar& Sidecar::object(std::string_view name, std::string_view description) {
  json_.key(name).beginObject().key("Description").value(description).endObject();
  return *this;
}

Sidecar& Sidecar::column(std::string_view name, std::string_view description, const Levels& levels) {
  json_.key(name).beginObject().key("Description").value(description);
  if (!levels.empty()) {
    json_.key("Levels").beginObject();
    for (const auto& [value, meaning] : levels) json_.key(value).value(meaning);
    json_.endObject();
  }
  json_.endObject();
  return *this;
}

Sidecar& Sidecar::column(std::string_view name, std::string_view description, std::string_view unit) {
  json_.key(name).beginObject().key("Description").value(description).key("Units").value(unit).endObject();
  return *this;
}

namespace {

bool isLetterOrDigit(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// The same number with one more decimal.
std::string longer(const std::string& number) {
  const std::size_t end = std::min(number.find('e'), number.size());
  const std::string mantissa = number.substr(0, end);
  return mantissa + (mantissa.find('.') == std::string::npos ? ".0" : "0") + number.substr(end);
}

}  // namespace

TsvWriter& TsvWriter::row(const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text_ += '\t';
    if (cells[i].empty()) text_ += "n/a";
    for (const char c : cells[i]) text_ += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
  }
  text_ += '\n';
  return *this;
}

std::vector<std::string> differentTexts(std::vector<std::string> cells) {
  for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
    while (std::find(cells.begin(), cell, *cell) != cell) *cell = longer(*cell);
  }
  return cells;
}

const std::string& Labels::of(const std::string& text) {
  const auto it = std::find_if(known_.begin(), known_.end(), [&](const auto& one) { return one.first == text; });
  if (it != known_.end()) return it->second;
  std::string plain;
  std::copy_if(text.begin(), text.end(), std::back_inserter(plain), isLetterOrDigit);
  std::string label = plain.empty() ? "x" : plain;
  const auto taken = [&] {
    return std::any_of(known_.begin(), known_.end(), [&](const auto& one) { return one.second == label; });
  };
  for (int number = 2; taken(); ++number) label = plain + "x" + std::to_string(number);
  return known_.emplace_back(text, label).second;
}

}  // namespace tactus::dataset
