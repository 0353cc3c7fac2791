// One point. An expert alone uses one lane per output term; a team uses one lane per expert. Part of kernel_source.h.
// Words: program.h.

using VT = Pack<kTeam>;

template <int count>
TACTUS_INLINE Polynomial<Pack<count>> load(const Polynomial<Lanes>& f) noexcept {
  return {load<count>(f.width), load<count>(f.half_taper), load<count>(f.middle), load<count>(f.linear),
          load<count>(f.cubic)};
}

/// (0 + 2) + (1 + 3), regardless of the register width, so that every instruction set gives the same bits.
TACTUS_INLINE double sum(const VT& x) noexcept {
#if TACTUS_KERNEL_WIDTH == 2
  const Register two = x.part[0] + x.part[1];
#else
  const Register& four = x.part[0];
  // Wider registers exist on x86-64 only; the builtin is faster there than a shuffle.
  const auto two = __builtin_shufflevector(four, four, 0, 1) + __builtin_ia32_vextractf128_pd256(four, 1);
#endif
  return two[0] + two[1];
}

/// Adds lanes 4 to 7 (0 if absent) to lanes 0 to 3, then adds these four like `sum`.
template <int count>
TACTUS_INLINE double sumOfLanes(const Pack<count>& x) noexcept {
  VT halves;
  for (int p = 0; p < VT::kParts; ++p) {
    const int other = p + VT::kParts;
    halves.part[p] = other < Pack<count>::kParts ? x.part[p] + x.part[other] : x.part[p];
  }
  return sum(halves);
}

/// Moves lane k + 1 to lane k. The last lane becomes 0.
template <int count>
TACTUS_INLINE Pack<count> nextLane(const Pack<count>& x) noexcept {
  Pack<count> next;
  for (int p = 0; p < Pack<count>::kParts; ++p) {
    const Register after = p + 1 < Pack<count>::kParts ? x.part[p + 1] : Register{};
#if TACTUS_KERNEL_WIDTH == 2
    next.part[p] = __builtin_shufflevector(x.part[p], after, 1, 2);
#else
    next.part[p] = __builtin_shufflevector(x.part[p], after, 1, 2, 3, 4);
#endif
  }
  return next;
}

/// The contribution of one team to the outcome.
struct TeamOutcome {
  double mean;    ///< sum of the experts' offsets times their shares
  bool all_fire;  ///< no area is negligible
};

/// The centroid of an expert alone: one strength per output term, side by side. `count`: lanes, at least the number of
/// output terms.
template <int count>
TACTUS_INLINE TeamOutcome centroidAlone(const Program& common, const Team& team, const Fuzzified& at, std::size_t seat,
                                        PointOutcome& out) noexcept {
  constexpr std::size_t kParts = kLanes / kTeam;  // groups of weights per rest
  const PointProgram& program = common.point;
  // Two maxima at once: with a single one, each rest would have to wait for the one before.
  Pack<count> even = spread<count>(0);
  Pack<count> odd = spread<count>(0);
  for (const std::uint16_t r : at.rows) {
    const Stretch& row = program.rows[team.first_row + r];
    const Pack<count> pivot = spread<count>(at.slots[at.pivots[r]]);
    const Rest* rest = program.rests.data() + row.first;
    const Rest* const end = rest + row.count;
    // If the row is empty, this pointer may be the end of the table.
    const Weights* weights = program.weights.data() + team.first_weight + kParts * (row.first - team.first_rest);
    const auto strength = [&](std::size_t k) {
      return load<count>(weights[kParts * k].value) * smaller(spread<count>(at.slots[rest[k].slot]), pivot);
    };
    for (; end - rest >= 2; rest += 2, weights += 2 * kParts) {
      even = larger(strength(0), even);
      odd = larger(strength(1), odd);
    }
    if (rest != end) even = larger(strength(0), even);
  }
  const Pack<count> s = larger(even, odd);
  const ClosedForm::SideBySide& form = common.forms[team.form].side_by_side;
  const Pack<count> next = nextLane(s);
  Pack<count> own_area, own_moment, shared_area, shared_moment;
  if (common.clip) {
    clip(s, load<count>(form.terms), own_area, own_moment);
    clip(smaller(smaller(s, load<count>(form.overlaps.peak)), next), load<count>(form.overlaps.shape), shared_area,
         shared_moment);
  } else {
    own_area = s * load<count>(form.terms.width);
    own_moment = s * load<count>(form.terms.middle);
    const Overlap<Pack<count>> overlap{{load<count>(form.overlaps.shape.width), {}, {}, {}, {}},
                                       {},
                                       load<count>(form.overlaps.start),
                                       load<count>(form.overlaps.inverse_fall),
                                       load<count>(form.overlaps.inverse_rise)};
    overlapScaled(s, next, overlap, shared_area, shared_moment);
  }
  const double area = sumOfLanes(own_area - shared_area);
  const double offset = sumOfLanes(own_moment - shared_moment) / area;
  out.area[seat] = area;
  out.offset[seat] = offset;
  return {offset * team.shares.value[0], area > common.negligible};
}

/// Centroids of a team. `strengths`: for each output term, the strengths of all experts of the team side by side.
TACTUS_INLINE TeamOutcome centroidsOfTeam(const Program& common, const Team& team, const VT* strengths,
                                          std::size_t lanes, std::size_t seat, PointOutcome& out) noexcept {
  const ClosedForm& form = common.forms[team.form];
  VT areas = spread<kTeam>(0);
  VT moments = spread<kTeam>(0);
  for (std::size_t k = 0; k < lanes; ++k) {
    addLane(form, common.clip, k, strengths[k], strengths, ~std::uint64_t{0}, areas, moments);
  }
  const VT offsets = moments / areas;
  store(out.area + seat, areas);
  store(out.offset + seat, offsets);
  Bits fires = areas.part[0] > common.negligible;
  for (int p = 1; p < VT::kParts; ++p) fires &= areas.part[p] > common.negligible;
  bool all_fire = true;
  for (int lane = 0; lane < kWidth; ++lane) all_fire = all_fire && fires[lane] != 0;
  return {sum(offsets * load<kTeam>(team.shares.value)), all_fire};
}

/// A team with `lanes` output terms. The strengths stay in registers.
template <int lanes>
TeamOutcome denseTeam(const Program& common, const Team& team, const Fuzzified& at, std::size_t seat,
                      PointOutcome& out) noexcept {
  const PointProgram& program = common.point;
  VT strengths[lanes];
  _Pragma("GCC unroll 8") for (int k = 0; k < lanes; ++k) strengths[k] = spread<kTeam>(0);
  for (const std::uint16_t r : at.rows) {
    const Stretch& row = program.rows[team.first_row + r];
    const VT pivot = spread<kTeam>(at.slots[at.pivots[r]]);
    const Rest* const rests = program.rests.data() + row.first;
    const Weights* weights = program.weights.data() + team.first_weight + lanes * (row.first - team.first_rest);
    for (std::uint32_t i = 0; i < row.count; ++i, weights += lanes) {
      const VT rest = smaller(spread<kTeam>(at.slots[rests[i].slot]), pivot);
      _Pragma("GCC unroll 8") for (int k = 0; k < lanes; ++k) {
        strengths[k] = larger(load<kTeam>(weights[k].value) * rest, strengths[k]);
      }
    }
  }
  return centroidsOfTeam(common, team, strengths, lanes, seat, out);
}

/// A team with more than eight output terms.
TeamOutcome sparseTeam(const Program& common, const Team& team, const Fuzzified& at, std::size_t seat,
                       PointOutcome& out) noexcept {
  const PointProgram& program = common.point;
  VT strengths[kMostTerms];
  for (std::size_t k = 0; k < team.lanes; ++k) strengths[k] = spread<kTeam>(0);
  for (const std::uint16_t r : at.rows) {
    const Stretch& row = program.rows[team.first_row + r];
    const double pivot = at.slots[at.pivots[r]];
    const Rest* const rests = program.rests.data() + row.first;
    const Weights* const weights = program.weights.data() + team.first_weight + (row.first - team.first_rest);
    for (std::uint32_t k = 0; k < row.count; ++k) {
      VT& strength = strengths[rests[k].lane];
      strength = larger(load<kTeam>(weights[k].value) * smaller(at.slots[rests[k].slot], pivot), strength);
    }
  }
  return centroidsOfTeam(common, team, strengths, team.lanes, seat, out);
}

using DenseTeam = TeamOutcome (*)(const Program&, const Team&, const Fuzzified&, std::size_t, PointOutcome&) noexcept;
constexpr DenseTeam kDenseTeams[kLanes] = {denseTeam<1>, denseTeam<2>, denseTeam<3>, denseTeam<4>,
                                           denseTeam<5>, denseTeam<6>, denseTeam<7>, denseTeam<8>};

TACTUS_INLINE TeamOutcome centroids(const Program& common, const Team& team, const Fuzzified& at, std::size_t seat,
                                    PointOutcome& out) noexcept {
  if (team.layout == Team::Layout::kDense) return kDenseTeams[team.lanes - 1](common, team, at, seat, out);
  if (team.layout == Team::Layout::kSparse) return sparseTeam(common, team, at, seat, out);
  if (team.lanes <= 4) return centroidAlone<4>(common, team, at, seat, out);
  if constexpr (kWidth == 2) {
    if (team.lanes <= 6) return centroidAlone<6>(common, team, at, seat, out);
  }
  return centroidAlone<kLanes>(common, team, at, seat, out);
}

bool point(const Program& common, const double* inputs, PointOutcome& out) noexcept {
  const PointProgram& program = common.point;
  double clamped[kMostInputs];
  if (!clampInputs(common, inputs, clamped)) return false;
  alignas(64) double slots[kMostSlots];
  slots[kZeroSlot] = 0;
  slots[kOneSlot] = 1;
  TeamOutcome all{0, true};
  std::size_t seat = 0;
  for (const PointSection& section : program.sections) {
    // Clamps the pivot input again, because that is faster than to load the value just stored in `clamped`.
    const double pivot = clampInput(common, section.pivot_input, inputs[section.pivot_input]);
    const Fuzzified at = fuzzify(program, section, clamped, pivot, slots);
    for (const Team& team : in(program.teams, section.teams)) {
      const TeamOutcome one = centroids(common, team, at, seat, out);
      all.mean += one.mean;
      all.all_fire = all.all_fire && one.all_fire;
      seat += team.experts;
    }
  }
  out.mean = all.mean;
  return all.all_fire;
}
