#include "app/link/client_message.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/close_match.h"
#include "core/base/json/json_document.h"
#include "core/base/json/json_members.h"
#include "core/base/text.h"

namespace tactus::link {
namespace {

using base::ErrorCode;
using base::JsonKind;
using base::JsonMembers;
using base::JsonValue;
using base::required;
using base::Result;

constexpr std::size_t kLongestName = 60;
constexpr std::size_t kLongestId = 100;

/// `text` on one line, cut to whole characters.
std::string shortName(std::string_view text) {
  std::string name = base::oneLine(text);
  if (name.size() <= kLongestName) return name;
  std::size_t end = 0;
  while (true) {
    const auto bytes = base::firstCharacter(std::string_view(name).substr(end)).bytes;
    if (end + bytes > kLongestName) break;
    end += bytes;
  }
  name.resize(end);
  return name;
}

void readWant(JsonMembers& members, Hello& hello) {
  if (!members.has("want")) return;
  hello.wants_model = hello.wants_state = false;
  std::vector<std::string> wanted;
  members.texts("want", wanted);
  for (const std::string& word : wanted) {
    if (word == "model") {
      hello.wants_model = true;
    } else if (word == "state") {
      hello.wants_state = true;
    } else {
      members.refuse("want", "the word " + base::quoted(word), "model, state or both");
    }
  }
}

Result<JsonValue> valueOf(const base::JsonDocument& document, std::string_view key) {
  if (const auto value = document.root().find(key)) return *value;
  std::string found = "an object without members";
  for (const JsonValue first : document.root()) {
    found = "the member " + base::quoted(first.key());
    break;
  }
  return base::fail(ErrorCode::kSchema, {}, std::move(found), "a line with the member '" + std::string(key) + "'");
}

Result<base::JsonDocument> parseLine(std::string_view line) {
  if (!base::isUtf8(line)) return base::fail(ErrorCode::kSyntax, {}, "bytes that are not UTF-8", "JSON in UTF-8");
  return base::JsonDocument::parse(line);
}

}  // namespace

Result<Hello> readHello(std::string_view line) {
  const auto document = parseLine(line);
  if (!document) return tl::unexpected(document.error());
  const auto greeting = valueOf(*document, "hello");
  if (!greeting) return tl::unexpected(greeting.error());
  std::optional<base::Error> error;
  JsonMembers members(document->root(), error);
  Hello hello;
  std::string name;
  if (greeting->kind() != JsonKind::kString || greeting->text() != kProtocol) {
    members.refuse("hello", "'" + std::string(kProtocol) + "'");
  }
  members.version(required("version"));
  members.text(required("token"), hello.token);
  members.textOrEmpty("name", name);
  readWant(members, hello);
  members.number("state_hz", hello.state_hz, {kLowestStateHz, kHighestStateHz});
  if (error) return tl::unexpected(*std::move(error));
  hello.name = shortName(name);
  return hello;
}

Result<Ask> readAsk(std::string_view line) {
  const auto document = parseLine(line);
  if (!document) return tl::unexpected(document.error());
  const auto question = valueOf(*document, "ask");
  if (!question) return tl::unexpected(question.error());
  std::optional<base::Error> error;
  JsonMembers members(*question, error);
  Ask ask;
  if (const auto id = members.child(required("id"))) {
    const bool fits = id->kind() == JsonKind::kNumber || id->kind() == JsonKind::kString;
    if (fits && id->text().size() <= kLongestId) {
      ask.id = id->json();
    } else {
      members.refuse("id", "a number or a string of at most " + std::to_string(kLongestId) + " bytes");
    }
  }
  members.numbers(required("inputs"), ask.inputs);
  if (error) return tl::unexpected(*std::move(error));
  return ask;
}

}  // namespace tactus::link
