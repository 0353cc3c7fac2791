// What each screen of the nurse shows, taken from the state of the course.
#pragma once

#include "app/workbench/participant/participant_state.h"
#include "app/workbench/participant/screens/about_you_screen.h"
#include "app/workbench/participant/screens/closing_screens.h"
#include "app/workbench/participant/screens/consent_screen.h"
#include "app/workbench/participant/screens/device_check_screen.h"
#include "app/workbench/participant/screens/force_screen.h"
#include "app/workbench/participant/screens/own_model_screen.h"
#include "app/workbench/participant/screens/question_screen.h"
#include "app/workbench/participant/screens/review_screen.h"
#include "app/workbench/participant/screens/scale_screen.h"
#include "app/workbench/participant/screens/stroke_screen.h"
#include "app/workbench/participant/screens/welcome_screen.h"

namespace tactus::workbench {

/// `entering_code`: she said that she has a code, and has not typed it yet.
nurse::WelcomeState shownWelcome(const ParticipantState& state, bool entering_code);
nurse::ConsentState shownConsent(const ParticipantState& state);
nurse::AboutYouState shownAboutYou(const ParticipantState& state);
nurse::DeviceCheckState shownDeviceCheck(const ParticipantState& state);
nurse::StrokeState shownStrokes(const ParticipantState& state);
nurse::ForceState shownForce(const ParticipantState& state);
nurse::QuestionState shownQuestion(const ParticipantState& state);
nurse::ScaleState shownScale(const ParticipantState& state);
nurse::ReviewState shownReview(const ParticipantState& state);
nurse::OwnModelState shownOwnModel(const ParticipantState& state);
nurse::StoppedState shownStopped(const ParticipantState& state);

/// What covers the screen: the id of its sentence, or empty.
QString shownCover(const ParticipantState& state);

}  // namespace tactus::workbench
