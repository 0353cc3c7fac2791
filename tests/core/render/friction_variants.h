// Friction models that the renderer was chosen over, for the comparison in friction_comparison_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/render/low_pass.h"

namespace tactus::render {

inline constexpr double kVariantStiffness = 0.25;  ///< N/mm
inline constexpr double kVariantBreakaway = 0.15;

/// F_d of the comparison: .35 N and .0015 N per mm/s.
inline double variantForce(double speed_mm_s) { return 0.35 + 0.0015 * std::abs(speed_mm_s); }

/// What the variants share: a velocity, filtered where `filter_hz` > 0.
class Variant {
 public:
  explicit Variant(double filter_hz) : filter_hz_(filter_hz) {}
  int transitions() const { return transitions_; }
  double depthMm() const { return depth_mm_; }

 protected:
  double move(double position_mm, double dt_s) {
    moved_mm_ = position_mm - position_mm_;
    position_mm_ = position_mm;
    const double raw = moved_mm_ / dt_s;
    filter_ = filter_hz_ > 0 ? filtered(filter_, raw, filter_hz_, dt_s) : LowPass{raw, raw};
    return filter_.value;
  }

  double position_mm_ = 0, moved_mm_ = 0, depth_mm_ = 0;
  int transitions_ = 0;

 private:
  double filter_hz_;
  LowPass filter_;
};

/// F = F_d sign(v): no static friction at all.
class Coulomb : public Variant {
 public:
  using Variant::Variant;
  double tick(double position_mm, double dt_s) {
    const double v = move(position_mm, dt_s);
    const int sign = v > 0 ? 1 : v < 0 ? -1 : 0;
    transitions_ += sign != sign_ ? 1 : 0;
    sign_ = sign;
    depth_mm_ = position_mm_;
    return sign * variantForce(v);
  }

 private:
  int sign_ = 0;
};

/// Karnopp 1985: stuck exactly while slower than 2 mm/s, on a spring from where the tube stopped; F_d sign(v)
/// otherwise.
class Karnopp : public Variant {
 public:
  using Variant::Variant;
  double tick(double position_mm, double dt_s) {
    const double v = move(position_mm, dt_s);
    const bool stuck = std::abs(v) < 2;
    if (stuck != stuck_) {
      ++transitions_;
      anchor_mm_ = position_mm_;
    }
    stuck_ = stuck;
    if (!stuck) return std::copysign(variantForce(v), v);
    const double most_n = (1 + kVariantBreakaway) * variantForce(0);
    return std::clamp(kVariantStiffness * (position_mm_ - anchor_mm_), -most_n, most_n);
  }

 private:
  double anchor_mm_ = 0;
  bool stuck_ = true;
};

/// The paper's two phases taken literally: F = k X + `damping` V from X = 0 at each stop, then F_d. The printed sign
/// of Eq. 3 is a negative `damping_n_s_mm`.
class Restart : public Variant {
 public:
  Restart(double filter_hz, double damping_n_s_mm) : Variant(filter_hz), damping_n_s_mm_(damping_n_s_mm) {}
  double tick(double position_mm, double dt_s) {
    const double v = move(position_mm, dt_s);
    if (stuck_) {
      const double static_n = kVariantStiffness * (position_mm_ - anchor_mm_) + damping_n_s_mm_ * v;
      if (std::abs(static_n) <= (1 + kVariantBreakaway) * variantForce(0)) return static_n;
      change(false);
      direction_ = std::copysign(1.0, static_n);
    } else if (std::abs(v) < 2) {
      change(true);
      return 0;
    }
    depth_mm_ += moved_mm_;
    if (std::abs(v) >= 2) direction_ = std::copysign(1.0, v);
    return direction_ * variantForce(v);
  }

 private:
  void change(bool stuck) {
    stuck_ = stuck;
    anchor_mm_ = position_mm_;
    ++transitions_;
  }
  double damping_n_s_mm_, anchor_mm_ = 0, direction_ = 1;
  bool stuck_ = true;
};

/// Dahl 1968: dz = dx (1 - k z / F_d sign dx). No break-away, and it drifts under small oscillation.
class Dahl : public Variant {
 public:
  using Variant::Variant;
  double tick(double position_mm, double dt_s) {
    const double v = move(position_mm, dt_s);
    const double share = kVariantStiffness * stretch_mm_ / variantForce(v);
    const double stretched_mm = moved_mm_ * (1 - share * (moved_mm_ > 0 ? 1 : -1));
    stretch_mm_ += stretched_mm;
    depth_mm_ += moved_mm_ - stretched_mm;
    return kVariantStiffness * stretch_mm_;
  }

 private:
  double stretch_mm_ = 0;
};

}  // namespace tactus::render
