// The two methods for the derivatives of one expert at a point: fast and general.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "core/analysis/gradient/gradient_sink.h"
#include "core/analysis/gradient/gradient_tables.h"

namespace tactus::analysis {

inline constexpr std::uint32_t kNoBank = std::numeric_limits<std::uint32_t>::max();

/// Whether an expert fires. kOpen: the fast path cannot decide and leaves the point to the general path.
enum class Firing { kFires, kAbstains, kOpen };

/// The data of a point for the fast path, reused while consecutive experts share their terms.
struct FastPoint {
  std::array<std::uint32_t, fuzzy::kMostInputs> bank;
  std::array<std::size_t, fuzzy::kMostInputs> segment;
  /// Indexed by input * kMostTerms + term; set for active terms only.
  std::array<double, fuzzy::kMostInputs * fuzzy::kMostTerms> membership;
  std::array<const MembershipPiece*, fuzzy::kMostInputs * fuzzy::kMostTerms> piece;

  FastPoint() noexcept { bank.fill(kNoBank); }
};

/// The memberships of a point for the general path, times a power of two; reused in the same way.
struct GeneralPoint {
  std::array<std::uint32_t, fuzzy::kMostInputs> bank;
  std::array<std::array<double, fuzzy::kMostTerms>, fuzzy::kMostInputs> membership;

  GeneralPoint() noexcept { bank.fill(kNoBank); }
};

/// Adds weight * dF/dparameter for an expert with a fast form, at a point of ordinary numbers (isOrdinary). `offset`:
/// receives the force measured from the lower end of the universe. Adds nothing unless the expert fires.
/// Thread: any. Real-time safe: yes.
Firing addFast(const GradientTables& tables, const GradientExpert& expert, std::span<const double> clamped,
               FastPoint& point, GradientSink& sink, double& offset) noexcept;

/// The same for any expert and any point; never returns kOpen. Thread: any. Real-time safe: yes.
Firing addGenerally(const GradientTables& tables, const GradientExpert& expert, std::span<const double> clamped,
                    GeneralPoint& point, GradientSink& sink, double& offset) noexcept;

}  // namespace tactus::analysis
