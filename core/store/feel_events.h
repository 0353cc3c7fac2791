// Stores placements and recordings of feeling a model as events and strokes. Private to core/store.
#pragma once

#include <string_view>

#include "core/base/error.h"
#include "core/study/session_records.h"

namespace tactus::store {

// Kinds of events, and level and verdicts of the strokes that are pieces of recordings.
inline constexpr std::string_view kPlacementKind = "placement";
inline constexpr std::string_view kFeelStartKind = "recording_started";
inline constexpr std::string_view kFeelEndKind = "recording_finished";
inline constexpr std::string_view kFeelLevel = "feel";
inline constexpr std::string_view kFeelVerdict = "recorded";
/// Verdict of a piece after which samples were lost.
inline constexpr std::string_view kFeelGapVerdict = "recorded_until_gap";

study::EventRecord eventOf(const study::PlacementRecord& record);
study::EventRecord eventOf(const study::FeelStart& record);
study::EventRecord eventOf(const study::FeelEnd& record);
study::StrokeRecord strokeOf(const study::FeelPiece& record);

/// The record stored in an event. Returns an error if the detail does not match the kind.
base::Result<study::PlacementRecord> placementOf(const study::EventRecord& event);
base::Result<study::FeelStart> feelStartOf(const study::EventRecord& event);
base::Result<study::FeelEnd> feelEndOf(const study::EventRecord& event);

}  // namespace tactus::store
