// The screens that are text and cards, as data: what each says, and the cards that answer it.
#pragma once

#include <QString>

#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench {

/// One question about the participant, with its answers. Under an uncomfortable hand it says whom to tell.
PageState aboutYouPage(const AboutYouState& asked);

/// A rest: the force is off, there is no countdown, she continues whenever she likes. `begins_to_count`: the page that
/// says that the practice is over.
PageState restPage(bool begins_to_count);

/// The effort or comfort of a part that is done, with seven points between two ends.
/// `sentence`: its id in the word book. `chosen`: `1` to `7`, or kNotSay.
PageState ratingPage(const QString& sentence, const QString& chosen);

/// Statement `item` of the form for clinical teachers, the one at `position` of `count`, with seven points. The last
/// one locks the answers.
PageState statementPage(int item, int position, int count, const QString& chosen);

/// The end before the end: stopped for today, withdrawn, or no consent. `code`: of the participant.
PageState stoppedPage(StopReason why, const QString& code);

}  // namespace tactus::workbench
