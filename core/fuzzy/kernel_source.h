// The source of the kernels. Included by kernels.cpp once per instruction set, each time inside another namespace and
// under another target; not for anybody else. One point works on eight doubles at a time, a batch on sixteen; the
// compiler splits what the machine cannot do at once.

/// Numbers side by side, in registers of kWidth doubles.
constexpr int kWidth = TACTUS_KERNEL_WIDTH;
using Register = double __attribute__((vector_size(kWidth * sizeof(double)), may_alias));
using Bits = long long __attribute__((vector_size(kWidth * sizeof(double))));

template <int count>
struct Pack {
  static constexpr int kParts = count / kWidth;
  Register part[kParts];
};

/// For each part of a result.
#define TACTUS_EACH_PART(expression)                                                                 \
  Pack<count> out;                                                                                   \
  _Pragma("GCC unroll 16") for (int i = 0; i < Pack<count>::kParts; ++i) out.part[i] = (expression); \
  return out

#define TACTUS_INLINE [[gnu::always_inline]] inline

template <int count>
TACTUS_INLINE Pack<count> spread(double x) noexcept {
  TACTUS_EACH_PART(Register{} + x);
}
template <int count>
TACTUS_INLINE Pack<count> load(const double* from) noexcept {
  TACTUS_EACH_PART(([&] {
    Register r;
    __builtin_memcpy(&r, from + i * kWidth, sizeof r);
    return r;
  }()));
}
template <int count>
TACTUS_INLINE void store(double* to, const Pack<count>& x) noexcept {
  _Pragma("GCC unroll 16") for (int i = 0; i < Pack<count>::kParts; ++i) {
    __builtin_memcpy(to + i * kWidth, &x.part[i], sizeof(Register));
  }
}
template <int count>
TACTUS_INLINE Pack<count> operator+(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] + y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] - y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator*(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] * y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator/(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] / y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator*(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] * y);
}
template <int count>
TACTUS_INLINE Pack<count> operator+(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] + y);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] - y);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(double x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x - y.part[i]);
}
/// The larger of both; y where x is not a number.
template <int count>
TACTUS_INLINE Pack<count> larger(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] > y.part[i] ? x.part[i] : y.part[i]);
}
/// The smaller of both; y where x is not a number.
template <int count>
TACTUS_INLINE Pack<count> smaller(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] < y.part[i] ? x.part[i] : y.part[i]);
}
TACTUS_INLINE double smaller(double x, double y) noexcept { return x < y ? x : y; }
/// x where it is positive, else 1: a divisor.
template <int count>
TACTUS_INLINE Pack<count> positiveOrOne(const Pack<count>& x) noexcept {
  TACTUS_EACH_PART(x.part[i] > 0 ? x.part[i] : Register{} + 1.0);
}

/// One per output term, and one per point of a batch.
using V8 = Pack<8>;
using VB = Pack<kBatch>;

TACTUS_INLINE V8 load(const Lanes& lanes) noexcept { return load<8>(lanes.value); }

/// ((0 + 4) + (2 + 6)) + ((1 + 5) + (3 + 7)), whatever the width of a register.
TACTUS_INLINE double sum(const V8& x) noexcept {
#if TACTUS_KERNEL_WIDTH == 2
  const Register two = (x.part[0] + x.part[2]) + (x.part[1] + x.part[3]);
#else
#if TACTUS_KERNEL_WIDTH == 4
  const Register four = x.part[0] + x.part[1];
#else
  const Register& r = x.part[0];
  const auto four = __builtin_shufflevector(r, r, 0, 1, 2, 3) + __builtin_shufflevector(r, r, 4, 5, 6, 7);
#endif
  const auto two = __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
#endif
  return two[0] + two[1];
}

/// Lane k + 1 moves to lane k; the last becomes 0.
TACTUS_INLINE V8 nextLane(const V8& x) noexcept {
  const Register zero{};
#if TACTUS_KERNEL_WIDTH == 2
  return {{__builtin_shufflevector(x.part[0], x.part[1], 1, 2), __builtin_shufflevector(x.part[1], x.part[2], 1, 2),
           __builtin_shufflevector(x.part[2], x.part[3], 1, 2), __builtin_shufflevector(x.part[3], zero, 1, 2)}};
#elif TACTUS_KERNEL_WIDTH == 4
  return {{__builtin_shufflevector(x.part[0], x.part[1], 1, 2, 3, 4),
           __builtin_shufflevector(x.part[1], zero, 1, 2, 3, 4)}};
#else
  return {{__builtin_shufflevector(x.part[0], zero, 1, 2, 3, 4, 5, 6, 7, 8)}};
#endif
}

/// Area and moment of a set of terms, lane by lane, before the overlaps with the next lanes are taken off.
struct Sums {
  V8 area, moment;
};

TACTUS_INLINE Sums clipped(const V8& s, const V8& width, const V8& half_taper, const V8& middle, const V8& skew,
                           const V8& half_width, const V8& third_taper) noexcept {
  const V8 area = s * (width - s * half_taper);
  return {area, area * middle + skew * (s * s) * (half_width - s * third_taper)};
}

TACTUS_INLINE Centroid centroid(const ClosedForm& form, const V8& s, bool clip) noexcept {
  const V8 next = nextLane(s);
  Sums whole, overlap;
  if (clip) {
    whole = clipped(s, load(form.width), load(form.half_taper), load(form.middle), load(form.skew),
                    load(form.half_width), load(form.third_taper));
    const V8 t = smaller(smaller(s, next), load(form.overlap_peak));
    overlap = clipped(t, load(form.overlap_width), load(form.overlap_half_taper), load(form.overlap_middle),
                      load(form.overlap_skew), load(form.overlap_half_width), load(form.overlap_third_taper));
  } else {
    whole = {s * load(form.width), s * load(form.middle)};
    const V8 fall = s * load(form.inverse_fall);
    const V8 rise = next * load(form.inverse_rise);
    const V8 share = fall / positiveOrOne(fall + rise);  // way from the start of the overlap to its peak
    const V8 width = load(form.overlap_width);
    const V8 area = width * width * (rise * share) * 0.5;
    overlap = {area, area * (load(form.overlap_start) + width * (share + 1) * (1.0 / 3))};
  }
  return {sum(whole.area - overlap.area), sum(whole.moment - overlap.moment)};
}

/// Number of breakpoints up to x: the segment of the pivot input.
TACTUS_INLINE std::size_t segmentOf(const FastExpert& expert, double x) noexcept {
  const auto cell = static_cast<int>((x - expert.grid_start) * expert.cells_per_unit);
  std::size_t segment = expert.first_segment[static_cast<std::size_t>(cell)];
  while (x >= expert.breakpoints[segment]) ++segment;
  return segment;
}

TACTUS_INLINE V8 strengthsOf(const FastExpert& expert, const double* slots, double pivot_value) noexcept {
  V8 strengths = spread<8>(0);
  const std::uint32_t* const rows =
      expert.segment_rows.data() + segmentOf(expert, pivot_value) * expert.rows_per_segment;
  for (std::size_t r = 0; r < expert.rows_per_segment; ++r) {
    const Row& row = expert.rows[rows[r]];
    const double pivot = slots[row.pivot];
    const std::uint16_t* const rests = expert.rests.data() + row.first;
    const Lanes* const weights = expert.weights.data() + row.first;
    V8 best = spread<8>(0);
    for (std::uint32_t k = 0; k < row.count; ++k) {
      best = larger(load(weights[k]) * smaller(slots[rests[k]], pivot), best);
    }
    strengths = larger(best, strengths);
  }
  return strengths;
}

// Most inputs have three or four terms: half a block, unless a register holds a whole one anyway.
constexpr int kHalf = kWidth < 8 ? 4 : 8;

/// Memberships of one input in the terms of a block, absent terms included.
template <int count>
TACTUS_INLINE void fuzzify(const TermBlock& block, double input, double* slots) noexcept {
  const Pack<count> x = spread<count>(input);
  const Pack<count> rise = smaller((x - load<count>(block.a.value)) * load<count>(block.rise.value), spread<count>(1));
  const Pack<count> both = smaller((load<count>(block.d.value) - x) * load<count>(block.fall.value), rise);
  store(slots, larger(both, spread<count>(0)));
}

void point(const Program& program, const double* inputs, Centroid* out) noexcept {
  alignas(64) double slots[kMostSlots];
  for (std::size_t i = 0; i < program.constants.size(); ++i) store(slots + i * kLanes, load(program.constants[i]));
  for (const TermBlock& block : program.blocks) {
    if (block.count <= kHalf) {
      fuzzify<kHalf>(block, inputs[block.input], slots + block.slot);
    } else {
      fuzzify<8>(block, inputs[block.input], slots + block.slot);
    }
  }
  for (const Antecedent& antecedent : program.antecedents) {
    double least = slots[antecedent.of[0]];
    for (const std::uint16_t slot : antecedent.of) least = smaller(slots[slot], least);
    slots[antecedent.slot] = least;
  }
  for (const FastExpert& expert : program.experts) {
    const V8 strengths = strengthsOf(expert, slots, inputs[expert.pivot_input]);
    *out++ = centroid(program.forms[expert.form], strengths, program.clip);
  }
}

/// The same for one output term of many points.
TACTUS_INLINE void addClipped(const VB& s, const ClosedForm& form, std::size_t k, VB& area, VB& moment) noexcept {
  const VB a = s * (form.width.value[k] - s * form.half_taper.value[k]);
  VB m = a * form.middle.value[k];
  if (form.skew.value[k] != 0) {
    m = m + (s * s) * form.skew.value[k] * (form.half_width.value[k] - s * form.third_taper.value[k]);
  }
  area = area + a;
  moment = moment + m;
}

TACTUS_INLINE void takeClippedOverlap(const VB& s, const VB& next, const ClosedForm& form, std::size_t k, VB& area,
                                      VB& moment) noexcept {
  const VB t = smaller(smaller(s, next), spread<kBatch>(form.overlap_peak.value[k]));
  const VB a = t * (form.overlap_width.value[k] - t * form.overlap_half_taper.value[k]);
  VB m = a * form.overlap_middle.value[k];
  if (form.overlap_skew.value[k] != 0) {
    m = m + (t * t) * form.overlap_skew.value[k] *
                (form.overlap_half_width.value[k] - t * form.overlap_third_taper.value[k]);
  }
  area = area - a;
  moment = moment - m;
}

TACTUS_INLINE void takeScaledOverlap(const VB& s, const VB& next, const ClosedForm& form, std::size_t k, VB& area,
                                     VB& moment) noexcept {
  const VB fall = s * form.inverse_fall.value[k];
  const VB rise = next * form.inverse_rise.value[k];
  const VB share = fall / positiveOrOne(fall + rise);
  const double width = form.overlap_width.value[k];
  const VB a = (rise * share) * (width * width) * 0.5;
  area = area - a;
  moment = moment - a * ((share + 1) * (width * (1.0 / 3)) + form.overlap_start.value[k]);
}

TACTUS_INLINE void batchStrengths(const FastExpert& expert, const VB* slots, VB* strengths) noexcept {
  for (const RuleGroup& group : expert.groups) {
    const FastRule* const rules = expert.batch_rules.data() + group.first;
    VB best;
    if (group.unit_weights) {
      best = slots[rules[0].rest];
      for (std::uint32_t k = 1; k < group.count; ++k) best = larger(slots[rules[k].rest], best);
      best = smaller(slots[group.pivot], best);
    } else {
      best = spread<kBatch>(0);
      for (std::uint32_t k = 0; k < group.count; ++k) {
        best = larger(smaller(slots[group.pivot], slots[rules[k].rest]) * rules[k].weight, best);
      }
    }
    strengths[group.lane] = larger(best, strengths[group.lane]);
  }
}

/// Memberships of many points in one term: both ramps cut to [0, 1].
TACTUS_INLINE VB membership(const FastTerm& term, const VB& x) noexcept {
  VB result = spread<kBatch>(1);
  if (term.has_rise) result = smaller((x - term.a) * term.rise, result);
  if (term.has_fall) result = smaller((term.d - x) * term.fall, result);
  return larger(result, spread<kBatch>(0));
}

/// Mean over all experts; points where some area is negligible are marked in `look_again`.
TACTUS_INLINE VB meanForce(const Program& program, const VB* slots, Bits* look_again) noexcept {
  VB force = spread<kBatch>(program.output_min);
  for (const FastExpert& expert : program.experts) {
    if (expert.share == 0) continue;
    const ClosedForm& form = program.forms[expert.form];
    VB strengths[kLanes + 1];
    for (std::size_t k = 0; k <= form.count; ++k) strengths[k] = spread<kBatch>(0);
    batchStrengths(expert, slots, strengths);
    VB area = spread<kBatch>(0);
    VB moment = spread<kBatch>(0);
    for (std::size_t k = 0; k < form.count; ++k) {
      const VB& s = strengths[k];
      if (program.clip) {
        addClipped(s, form, k, area, moment);
      } else {
        area = area + s * form.width.value[k];
        moment = moment + s * form.middle.value[k];
      }
      if (form.overlap_width.value[k] == 0) continue;
      if (program.clip) {
        takeClippedOverlap(s, strengths[k + 1], form, k, area, moment);
      } else {
        takeScaledOverlap(s, strengths[k + 1], form, k, area, moment);
      }
    }
    for (int i = 0; i < VB::kParts; ++i) look_again[i] |= ~(area.part[i] > program.negligible);
    force = force + moment / area * expert.share;
  }
  return force;
}

void batch(const Program& program, const double* const* columns, BatchOutcome& out) noexcept {
  VB inputs[kMostInputs];
  Bits look_again[VB::kParts] = {};
  for (std::size_t k = 0; k < program.varying.size(); ++k) {
    const std::size_t i = program.varying[k];
    const VB x = load<kBatch>(columns[k]);
    for (int p = 0; p < VB::kParts; ++p) look_again[p] |= x.part[p] - x.part[p] != 0.0;  // NaN and infinity
    inputs[i] = smaller(larger(x, spread<kBatch>(program.input_min[i])), spread<kBatch>(program.input_max[i]));
  }
  VB slots[kMostSlots];
  for (std::size_t i = 0; i < program.constant_count; ++i) {
    slots[i] = spread<kBatch>(program.constants[i / kLanes].value[i % kLanes]);
  }
  for (const FastTerm& term : program.terms) slots[term.slot] = membership(term, inputs[term.input]);
  for (const Antecedent& antecedent : program.antecedents) {
    VB least = slots[antecedent.of[0]];
    for (const std::uint16_t slot : antecedent.of) least = smaller(slots[slot], least);
    slots[antecedent.slot] = least;
  }
  store(out.force_n, meanForce(program, slots, look_again));

  out.look_again = 0;
  Bits any{};
  for (int p = 0; p < VB::kParts; ++p) any |= look_again[p];
  long long some = 0;
  for (int lane = 0; lane < kWidth; ++lane) some |= any[lane];
  if (some == 0) return;
  for (int p = 0; p < static_cast<int>(kBatch); ++p) {
    out.look_again |= look_again[p / kWidth][p % kWidth] != 0 ? 1U << p : 0U;
  }
}

#undef TACTUS_EACH_PART
#undef TACTUS_INLINE
#undef TACTUS_KERNEL_WIDTH
