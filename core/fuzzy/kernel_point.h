// One point: lanes over output terms for an expert alone, over experts for a team. Part of kernel_source.h.

using VT = Pack<kTeam>;

template <int count>
TACTUS_INLINE Pack<count> load(const Lanes& lanes) noexcept {
  return load<count>(lanes.value);
}

template <int count>
TACTUS_INLINE Polynomial<Pack<count>> load(const Polynomial<Lanes>& f) noexcept {
  return {load<count>(f.width), load<count>(f.half_taper), load<count>(f.middle), load<count>(f.linear),
          load<count>(f.cubic)};
}

/// (0 + 2) + (1 + 3), whatever the width of a register.
TACTUS_INLINE double sum(const VT& x) noexcept {
#if TACTUS_KERNEL_WIDTH == 2
  const Register two = x.part[0] + x.part[1];
#else
  const Register& four = x.part[0];
  const auto two = __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
#endif
  return two[0] + two[1];
}

/// The same of lanes 0 to 3 and, if there are more, 4 to 7, added lane by lane; lanes that are missing count as 0.
template <int count>
TACTUS_INLINE double sumOfLanes(const Pack<count>& x) noexcept {
  VT halves;
  for (int p = 0; p < VT::kParts; ++p) {
    const int other = p + VT::kParts;
    halves.part[p] = other < Pack<count>::kParts ? x.part[p] + x.part[other] : x.part[p];
  }
  return sum(halves);
}

/// Lane k + 1 moves to lane k; the last becomes 0.
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

// Most inputs have three or four terms: half a block.
constexpr int kHalf = 4;

/// Memberships of one input in the terms of a block, absent terms included.
template <int count>
TACTUS_INLINE void fuzzify(const TermBlock& block, double input, double* slots) noexcept {
  const Pack<count> x = spread<count>(input);
  const Pack<count> rise = smaller((x - load<count>(block.a.value)) * load<count>(block.rise.value), spread<count>(1));
  const Pack<count> both = smaller((load<count>(block.d.value) - x) * load<count>(block.fall.value), rise);
  store(slots, larger(both, spread<count>(0)));
}

/// The rows that can be active at x: those of the segment in which x lies.
TACTUS_INLINE std::span<const std::uint16_t> rowsAt(const PointProgram& program, const PointSection& section,
                                                    double x) noexcept {
  const auto cell = static_cast<int>((x - section.grid_start) * section.cells_per_unit);
  const double* const breakpoints = program.breakpoints.data() + section.first_breakpoint;
  std::size_t segment = program.first_segment[section.first_cell + static_cast<std::size_t>(cell)];
  while (x >= breakpoints[segment]) ++segment;
  const std::uint16_t* const rows =
      program.segment_rows.data() + section.first_segment_row + segment * section.rows_per_segment;
  return {rows, section.rows_per_segment};
}

/// Slots and active rows of a section.
struct Fuzzified {
  const double* slots;
  const std::uint16_t* pivots;
  std::span<const std::uint16_t> rows;
};

/// An expert alone: one strength per output term, side by side; `count` lanes are enough for them.
template <int count>
TACTUS_INLINE void centroidAlone(const Program& common, const Team& team, const Fuzzified& at, std::size_t seat,
                                 PointOutcome& out) noexcept {
  constexpr std::size_t kParts = kLanes / kTeam;  // Weights of a rest
  const PointProgram& program = common.point;
  Pack<count> s = spread<count>(0);
  for (const std::uint16_t r : at.rows) {
    const Stretch& row = program.rows[team.first_row + r];
    const double pivot = at.slots[at.pivots[r]];
    const Rest* const rests = program.rests.data() + row.first;
    // An empty row may stand at the end of the tables.
    const Weights* const weights = program.weights.data() + team.first_weight + kParts * (row.first - team.first_rest);
    Pack<count> best = spread<count>(0);
    for (std::uint32_t k = 0; k < row.count; ++k) {
      best = larger(load<count>(weights[kParts * k].value) * smaller(at.slots[rests[k].slot], pivot), best);
    }
    s = larger(best, s);
  }
  const ClosedForm::SideBySide& form = common.forms[team.form].side_by_side;
  const Pack<count> next = nextLane(s);
  Pack<count> own_area, own_moment, shared_area, shared_moment;
  if (common.clip) {
    clip(s, load<count>(form.terms), own_area, own_moment);
    clip(smaller(smaller(s, next), load<count>(form.overlaps.peak)), load<count>(form.overlaps.shape), shared_area,
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
  out.all_fire = out.all_fire && area > common.negligible;
  out.mean += offset * team.shares.value[0];
}

/// Centroids of a team from its strengths: those of all experts, side by side, for each output term.
TACTUS_INLINE void centroidsOfTeam(const Program& common, const Team& team, const VT* strengths, std::size_t lanes,
                                   std::size_t seat, PointOutcome& out) noexcept {
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
  for (int lane = 0; lane < kWidth; ++lane) out.all_fire = out.all_fire && fires[lane] != 0;
  out.mean += sum(offsets * load<kTeam>(team.shares.value));
}

/// A team with `lanes` output terms, whose strengths stay in registers.
template <int lanes>
void denseTeam(const Program& common, const Team& team, const Fuzzified& at, std::size_t seat,
               PointOutcome& out) noexcept {
  const PointProgram& program = common.point;
  VT strengths[lanes];
  _Pragma("GCC unroll 8") for (int k = 0; k < lanes; ++k) strengths[k] = spread<kTeam>(0);
  for (const std::uint16_t r : at.rows) {
    const Stretch& row = program.rows[team.first_row + r];
    const double pivot = at.slots[at.pivots[r]];
    const Rest* const rests = program.rests.data() + row.first;
    const Weights* weights = program.weights.data() + team.first_weight + lanes * (row.first - team.first_rest);
    for (std::uint32_t i = 0; i < row.count; ++i, weights += lanes) {
      const VT rest = spread<kTeam>(smaller(at.slots[rests[i].slot], pivot));
      _Pragma("GCC unroll 8") for (int k = 0; k < lanes; ++k) {
        strengths[k] = larger(load<kTeam>(weights[k].value) * rest, strengths[k]);
      }
    }
  }
  centroidsOfTeam(common, team, strengths, lanes, seat, out);
}

/// A team with many output terms.
void sparseTeam(const Program& common, const Team& team, const Fuzzified& at, std::size_t seat,
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
  centroidsOfTeam(common, team, strengths, team.lanes, seat, out);
}

using DenseTeam = void (*)(const Program&, const Team&, const Fuzzified&, std::size_t, PointOutcome&) noexcept;
constexpr DenseTeam kDenseTeams[kLanes] = {denseTeam<1>, denseTeam<2>, denseTeam<3>, denseTeam<4>,
                                           denseTeam<5>, denseTeam<6>, denseTeam<7>, denseTeam<8>};

void point(const Program& common, const double* inputs, PointOutcome& out) noexcept {
  const PointProgram& program = common.point;
  alignas(64) double slots[kMostSlots];
  slots[kZeroSlot] = 0;
  slots[kOneSlot] = 1;
  out.all_fire = true;
  out.mean = 0;
  std::size_t seat = 0;
  for (const PointSection& section : program.sections) {
    for (const TermBlock& block : in(program.blocks, section.blocks)) {
      if (block.count <= kHalf) {
        fuzzify<kHalf>(block, inputs[block.input], slots + block.slot);
      } else {
        fuzzify<kLanes>(block, inputs[block.input], slots + block.slot);
      }
    }
    for (const Antecedent& antecedent : in(program.antecedents, section.antecedents)) {
      double least = antecedent.cap;
      for (const std::uint16_t slot : in(program.antecedent_slots, antecedent.of)) least = smaller(slots[slot], least);
      slots[antecedent.slot] = least;
    }
    const Fuzzified at{slots, program.pivots.data() + section.first_pivot,
                       rowsAt(program, section, inputs[section.pivot_input])};
    for (const Team& team : in(program.teams, section.teams)) {
      if (team.layout == Team::Layout::kDense) {
        kDenseTeams[team.lanes - 1](common, team, at, seat, out);
      } else if (team.layout == Team::Layout::kSparse) {
        sparseTeam(common, team, at, seat, out);
      } else if (team.lanes <= 4) {
        centroidAlone<4>(common, team, at, seat, out);
      } else if (kWidth == 2 && team.lanes <= 6) {
        centroidAlone<kWidth == 2 ? 6 : kLanes>(common, team, at, seat, out);
      } else {
        centroidAlone<kLanes>(common, team, at, seat, out);
      }
      seat += team.experts;
    }
  }
}
