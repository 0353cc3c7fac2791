#include "app/editing/same_bits.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace tactus::editing {
namespace {

bool same(double one, double other) { return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other); }

bool same(const fuzzy::Term& one, const fuzzy::Term& other);
bool same(const fuzzy::Variable& one, const fuzzy::Variable& other);
bool same(const fuzzy::TermOverride& one, const fuzzy::TermOverride& other);
bool same(const fuzzy::Rule& one, const fuzzy::Rule& other);
bool same(const fuzzy::Expert& one, const fuzzy::Expert& other);
bool same(const fuzzy::Check& one, const fuzzy::Check& other);

template <class List>
bool allSame(const List& one, const List& other) {
  return one.size() == other.size() &&
         std::equal(one.begin(), one.end(), other.begin(), [](const auto& a, const auto& b) { return same(a, b); });
}

bool same(const fuzzy::Term& one, const fuzzy::Term& other) { return allSame(one.points, other.points); }

bool same(const fuzzy::Variable& one, const fuzzy::Variable& other) {
  return same(one.min, other.min) && same(one.max, other.max) && allSame(one.terms, other.terms);
}

bool same(const fuzzy::TermOverride& one, const fuzzy::TermOverride& other) { return allSame(one.terms, other.terms); }

bool same(const fuzzy::Rule& one, const fuzzy::Rule& other) { return same(one.weight, other.weight); }

bool same(const fuzzy::Expert& one, const fuzzy::Expert& other) {
  return same(one.weight, other.weight) && allSame(one.overrides, other.overrides) && allSame(one.rules, other.rules);
}

bool same(const fuzzy::Check& one, const fuzzy::Check& other) {
  return same(one.force, other.force) && allSame(one.in, other.in);
}

bool same(const fuzzy::RendererParameters& one, const fuzzy::RendererParameters& other) {
  return std::all_of(std::begin(fuzzy::kRendererFields), std::end(fuzzy::kRendererFields),
                     [&](const auto& field) { return same(one.*field.member, other.*field.member); });
}

}  // namespace

// Everything but the numbers is compared by ==, the numbers once more by their bits.
bool sameBits(const fuzzy::Expert& one, const fuzzy::Expert& other) { return one == other && same(one, other); }

bool sameBits(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other) {
  return one == other && same(one.default_force_n, other.default_force_n) && allSame(one.inputs, other.inputs) &&
         same(one.output, other.output) && allSame(one.experts, other.experts) && allSame(one.checks, other.checks) &&
         (!one.renderer || same(*one.renderer, *other.renderer));
}

}  // namespace tactus::editing
