// The questions of the form for the screens: what a question asks, and all answers for the review.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/workbench/participant/participant_state.h"
#include "app/workbench/study/connection/session_snapshot.h"
#include "core/study/records.h"

namespace tactus::workbench {

/// The form with this id, if its items have conditions; the one of usability has none.
std::optional<study::Form> formWithConditions(const std::string& form);

/// The question of `page`. `chosen`: what is chosen on the screen now.
QuestionState questionState(const study::Form& form, const ItemPage& page, const QString& chosen);

ReviewState reviewState(const study::Form& form, const std::vector<ItemReply>& replies);

/// A term id, or `cant_tell`; empty where there is no reply, or it was skipped or taken back.
QString wordOf(const std::optional<questionnaires::Reply>& reply);
/// Of a judged force: a term id, `not_felt`, `beyond_practice`.
QString wordOf(const study::JudgementRecord& judgement);
/// The reply that `word` stands for; nothing for a word that the form does not offer.
std::optional<questionnaires::Reply> replyOf(const study::Form& form, const QString& word);

}  // namespace tactus::workbench
