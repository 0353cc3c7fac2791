// The words for enumerators in the study file and in the tables that are made of it.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "core/store/connection.h"
#include "core/study/session_records.h"

namespace tactus::store {

template <class Enum>
struct Words;

template <>
struct Words<study::EnteredBy> {
  static constexpr std::array<std::pair<study::EnteredBy, std::string_view>, 3> kAll = {
      {{study::EnteredBy::kParticipant, "participant"},
       {study::EnteredBy::kResearcher, "researcher"},
       {study::EnteredBy::kProgram, "program"}}};
};

template <>
struct Words<study::SessionKind> {
  static constexpr std::array<std::pair<study::SessionKind, std::string_view>, 3> kAll = {
      {{study::SessionKind::kElicitation, "elicitation"},
       {study::SessionKind::kUsability, "usability"},
       {study::SessionKind::kImport, "import"}}};
};

template <>
struct Words<study::ForceJudgement::Kind> {
  static constexpr std::array<std::pair<study::ForceJudgement::Kind, std::string_view>, 4> kAll = {
      {{study::ForceJudgement::Kind::kTerm, "term"},
       {study::ForceJudgement::Kind::kNotFelt, "not_felt"},
       {study::ForceJudgement::Kind::kBeyondPractice, "beyond_practice"},
       {study::ForceJudgement::Kind::kNoAnswer, "no_answer"}}};
};

template <>
struct Words<study::Answer::Status> {
  static constexpr std::array<std::pair<study::Answer::Status, std::string_view>, 4> kAll = {
      {{study::Answer::Status::kAnswered, "answered"},
       {study::Answer::Status::kSkipped, "skipped"},
       {study::Answer::Status::kCantTell, "cant_tell"},
       {study::Answer::Status::kCleared, "cleared"}}};
};

/// The word for `value`.
template <class Enum>
std::string_view wordFor(Enum value) {
  for (const auto& [candidate, word] : Words<Enum>::kAll) {
    if (candidate == value) return word;
  }
  refuse(base::ErrorCode::kValue, {}, "an unknown enumerator", "one of the program");
}

/// The enumerator of `word`. Refuses an unknown word, e.g. from a newer program.
template <class Enum>
Enum fromWord(std::string_view word) {
  for (const auto& [value, candidate] : Words<Enum>::kAll) {
    if (candidate == word) return value;
  }
  refuse(base::ErrorCode::kValue, {}, base::quoted(word), "a word that this program knows");
}

}  // namespace tactus::store
