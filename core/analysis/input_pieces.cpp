#include "core/analysis/input_pieces.h"

#include <algorithm>
#include <cmath>

namespace tactus::analysis {
namespace {

using fuzzy::MembershipFunction;

constexpr std::size_t kIndexCells = 256;

/// First double at which a term that ends in a vertical edge is 0 again.
double pastEdge(double edge) { return std::nextafter(edge, HUGE_VAL); }

/// Neither products nor quotients of a few such numbers leave the range of double.
bool isModerate(double x) { return isOrdinary(x) && std::abs(x) < 1e60; }

bool hasPieces(const MembershipFunction& f, double hi) {
  if (f.gaussian) return false;
  for (const double x : {f.a, f.b, f.c, f.d, f.b - f.a, f.d - f.c}) {
    if (!isModerate(x)) return false;
  }
  // At the upper end the piece to the left counts, so no term may begin or end right there.
  return !(f.a == f.b && f.a == hi) && !(f.c == f.d && pastEdge(f.d) == hi);
}

/// The term from x up to the next vertex, or nothing where it is 0.
std::optional<MembershipPiece> pieceAt(const MembershipFunction& f, const TermSlots& slots, std::uint16_t term,
                                       double x) {
  MembershipPiece piece{term, slots[0], slots[1], 0, 0, 0, 1, slots[0]};
  if (x < f.a || x > f.d || (x == f.d && f.c < f.d)) return std::nullopt;
  const bool rises = x < f.b;
  if (!rises && (x < f.c || f.c == f.d)) return piece;
  piece.foot = rises ? f.a : f.d;
  piece.shoulder = rises ? f.b : f.c;
  piece.slope = 1 / (piece.shoulder - piece.foot);
  piece.base = 0;
  if (!rises) piece.foot_slot = slots[3], piece.shoulder_slot = slots[2];
  return piece;
}

}  // namespace

std::optional<InputPieces> InputPieces::of(std::span<const MembershipFunction> terms, std::span<const TermSlots> slots,
                                           double lo, double hi) {
  if (!isModerate(hi - lo) || !isModerate(lo) || !isModerate(hi)) return std::nullopt;
  InputPieces out;
  std::vector<double> starts = {lo};
  for (const auto& f : terms) {
    if (!hasPieces(f, hi)) return std::nullopt;
    for (const double x : {f.a, f.b, f.c, f.c < f.d ? f.d : pastEdge(f.d)}) {
      if (x > lo && x < hi) starts.push_back(x);
    }
  }
  std::sort(starts.begin(), starts.end());
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());

  std::vector<std::vector<MembershipPiece>> segments;
  for (const double start : starts) {
    auto& pieces = segments.emplace_back();
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (const auto piece = pieceAt(terms[t], slots[t], static_cast<std::uint16_t>(t), start))
        pieces.push_back(*piece);
    }
    out.pieces_per_segment_ = std::max(out.pieces_per_segment_, pieces.size());
  }
  for (auto& pieces : segments) {
    MembershipPiece filler;
    filler.base = 0;
    pieces.resize(out.pieces_per_segment_, pieces.empty() ? filler : pieces.front());
    out.pieces_.insert(out.pieces_.end(), pieces.begin(), pieces.end());
  }
  out.ends_.assign(starts.begin() + 1, starts.end());

  // A vertex in an earlier cell is passed for sure, because the cell of a point never falls as the point rises.
  out.lo_ = lo;
  out.cells_per_unit_ = static_cast<double>(kIndexCells) / (hi - lo);
  out.first_segment_.assign(kIndexCells + 2, 0);
  for (const double end : out.ends_) {
    const double cell = (end - lo) * out.cells_per_unit_;
    for (std::size_t i = 0; i < out.first_segment_.size(); ++i) {
      if (static_cast<std::size_t>(cell) < i) ++out.first_segment_[i];
    }
  }
  out.ends_.push_back(HUGE_VAL);
  return out;
}

}  // namespace tactus::analysis
