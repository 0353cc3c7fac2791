// Area and moment of output sets by their closed form. Part of kernel_source.h.

/// Area and first moment of a trapezoid clipped at s, with positions measured from the lower end of the universe.
/// `Number` is a double, or one double per element of s. A symmetric trapezoid takes fewer operations if `Number` is a
/// double.
template <int count, class Number>
TACTUS_INLINE void clip(const Pack<count>& s, const Polynomial<Number>& f, Pack<count>& area,
                        Pack<count>& moment) noexcept {
  area = s * (f.width - s * f.half_taper);
  moment = area * f.middle;
  if constexpr (std::is_same_v<Number, double>) {
    if (f.linear == 0) return;
  }
  moment = moment + (s * s) * (f.linear - s * f.cubic);
}

/// The overlap of a set scaled by `left` with the next set, scaled by `right`: a triangle between two ramps.
template <int count, class Number>
TACTUS_INLINE void overlapScaled(const Pack<count>& left, const Pack<count>& right, const Overlap<Number>& overlap,
                                 Pack<count>& area, Pack<count>& moment) noexcept {
  const Pack<count> fall = left * overlap.inverse_fall;
  const Pack<count> rise = right * overlap.inverse_rise;
  const Pack<count> share = fall / positiveOrOne(fall + rise);  // way from the start of the overlap to its peak
  const Number& width = overlap.shape.width;
  area = (rise * share) * (width * width) * 0.5;
  moment = area * ((share + 1) * (width * (1.0 / 3)) + overlap.start);
}

/// Subtracts from the sums the overlaps of the output term `lane`, of strength s, with earlier terms.
/// `strengths`: strengths of the earlier lanes. `live`: one bit per lane, set if its strength can be above 0.
template <int count>
TACTUS_INLINE void takeOverlaps(const ClosedForm& form, bool clips, std::size_t lane, const Pack<count>& s,
                                const Pack<count>* strengths, std::uint64_t live, Pack<count>& area,
                                Pack<count>& moment) noexcept {
  const ClosedForm::Pair* const end = form.pairs.data() + form.first_pair[lane + 1];
  for (const ClosedForm::Pair* pair = form.pairs.data() + form.first_pair[lane]; pair != end; ++pair) {
    if ((live >> pair->left & 1U) == 0) continue;
    Pack<count> shared_area, shared_moment;
    if (!clips) {
      overlapScaled(strengths[pair->left], s, pair->overlap, shared_area, shared_moment);
    } else {
      const Pack<count> t = smaller(smaller(strengths[pair->left], s), spread<count>(pair->overlap.peak));
      clip(t, pair->overlap.shape, shared_area, shared_moment);
      if (pair->left + 1U != lane) {
        // Below the strength of the strongest term between, terms between cover the whole overlap.
        Pack<count> between = spread<count>(0);
        for (std::size_t k = pair->left + 1U; k < lane; ++k) {
          if ((live >> k & 1U) != 0) between = larger(strengths[k], between);
        }
        Pack<count> hidden_area, hidden_moment;
        clip(smaller(t, between), pair->overlap.shape, hidden_area, hidden_moment);
        area = area + hidden_area;
        moment = moment + hidden_moment;
      }
    }
    area = area - shared_area;
    moment = moment - shared_moment;
  }
}

/// Adds the output term `lane` of strength s to the sums, minus its overlaps with earlier terms.
template <int count>
TACTUS_INLINE void addLane(const ClosedForm& form, bool clips, std::size_t lane, const Pack<count>& s,
                           const Pack<count>* strengths, std::uint64_t live, Pack<count>& area,
                           Pack<count>& moment) noexcept {
  const Polynomial<double>& term = form.terms[lane];
  if (clips) {
    Pack<count> own_area, own_moment;
    clip(s, term, own_area, own_moment);
    area = area + own_area;
    moment = moment + own_moment;
  } else {
    area = area + s * term.width;
    moment = moment + s * term.middle;
  }
  takeOverlaps(form, clips, lane, s, strengths, live, area, moment);
}
