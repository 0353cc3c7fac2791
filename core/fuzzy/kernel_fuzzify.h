// Memberships at one point, and the rows of rules that can be active there. Part of kernel_source.h. Words: program.h.

template <int count>
TACTUS_INLINE Pack<count> load(const Lanes& lanes) noexcept {
  return load<count>(lanes.value);
}

/// x clamped to the universe of input i.
TACTUS_INLINE double clampInput(const Program& common, std::size_t i, double x) noexcept {
  const double above = x > common.input_min[i] ? x : common.input_min[i];
  return smaller(above, common.input_max[i]);
}

/// Clamps the inputs to their universes. Returns false if an input is not finite.
TACTUS_INLINE bool clampInputs(const Program& common, const double* inputs, double* clamped) noexcept {
  double nothing = 0;  // becomes NaN if an input is NaN or infinite
  for (std::size_t i = 0; i < common.inputs; ++i) {
    nothing += inputs[i] - inputs[i];
    clamped[i] = clampInput(common, i, inputs[i]);
  }
  return nothing == 0;
}

// Most inputs have three or four terms, which is half a block.
constexpr int kHalf = 4;

/// Memberships of one input in the terms of a block, including absent terms. Negative values stay, because the
/// strengths are cut at 0 later.
template <int count>
TACTUS_INLINE void fuzzify(const TermBlock& block, double input, double* slots) noexcept {
  const Pack<count> x = spread<count>(input);
  const Pack<count> rise = smaller((x - load<count>(block.a)) * load<count>(block.rise), load<count>(block.height));
  store(slots, smaller((load<count>(block.d) - x) * load<count>(block.fall), rise));
}

/// The rows that can be active at x: the rows of the segment that contains x.
TACTUS_INLINE std::span<const std::uint16_t> rowsAt(const PointProgram& program, const PointSection& section,
                                                    double x) noexcept {
  const auto cell = static_cast<int>((x - section.grid_start) * section.cells_per_unit);
  const double* const breakpoints = program.breakpoints.data() + section.first_breakpoint;
  const GridCell& start = program.cells[section.first_cell + static_cast<std::size_t>(cell)];
  const std::uint16_t* rows = program.segment_rows.data() + section.first_segment_row + start.row;
  for (const double* end = breakpoints + start.segment; x >= *end; ++end) rows += section.rows_per_segment;
  return {rows, section.rows_per_segment};
}

/// The slots and the active rows of a section.
struct Fuzzified {
  const double* slots;
  const std::uint16_t* pivots;
  std::span<const std::uint16_t> rows;
};

/// Computes the slots of a section at one point. `inputs`: clamped values. `pivot`: the clamped value of the pivot
/// input.
TACTUS_INLINE Fuzzified fuzzify(const PointProgram& program, const PointSection& section, const double* inputs,
                                double pivot, double* slots) noexcept {
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
  return {slots, program.pivots.data() + section.first_pivot, rowsAt(program, section, pivot)};
}
