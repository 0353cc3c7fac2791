// What a participant agrees to: statements that follow from the protocol, the study's own text, and whom to ask.
#pragma once

#include <QString>
#include <vector>

#include "app/workbench/participant/check_in.h"
#include "app/workbench/participant/kit/wordbook.h"

namespace tactus::workbench {

/// The paragraphs of the consent screen. The statements name only what the session has: without movements no recording
/// of them, with the device's largest force and the minutes; the protocol may have others instead.
/// `usability`: of a clinical teacher, who uses no device here.
std::vector<nurse::Phrase> consentParagraphs(const ParticipantPlan& plan, const nurse::Language& language,
                                             bool usability);

/// The same as the text that is stored with the consent, one paragraph in a line.
QString consentText(const ParticipantPlan& plan, const std::vector<nurse::Phrase>& paragraphs,
                    const nurse::Language& language);

/// About how long the sessions of the plan take, in min.
int minutesOf(const ParticipantPlan& plan);

/// Why no session of a real person can begin: nobody has said whose study it is, or whom to ask. Empty if one can.
QString whyNoSession(const ParticipantPlan& plan);
/// Of it: a language of the plan without a text of the study; empty: each has one.
QString whyNoText(const ParticipantPlan& plan);

}  // namespace tactus::workbench
