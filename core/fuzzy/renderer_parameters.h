// Parameters of the insertion renderer, stored in a model. Their meaning: core/render.
#pragma once

namespace tactus::fuzzy {

/// Defaults and ranges are choices of this project, not measurements. The paper names k, mu and tau (Eq. 3) but gives
/// no numbers. The defaults keep the pre-slip travel at 1 to 4 mm and a 1 kHz loop stable on a Geomagic Touch.
struct RendererParameters {
  int version = 1;
  double stiffness_n_mm = 0.25;    ///< k, (0, 10]: a larger value feels crisper and becomes unstable sooner
  double damping_n_s_mm = 0.0005;  ///< mu, [0, 0.004]: a larger value feels more viscous while stuck
  double breakaway_ratio = 0.15;  ///< tau, [0, 1]: excess of static over dynamic friction, relative to dynamic friction
  double restick_mm = 0.12;       ///< [0, 10]: backward travel after which a sliding tube sticks again
  double withdrawal_ratio = 0.6;  ///< [0, 10]: friction on withdrawal relative to insertion
  double relaxation_s = 0.01;     ///< (0, 10]: time in which static friction falls to dynamic friction
  double ageing_s = 0.1;          ///< (0, 100]: time in which a resting tube regains static friction
  double stick_speed_mm_s = 2;    ///< [0, 1000]: a tube slower than this for stick_time_s is stuck
  double stick_time_s = 0.05;     ///< [0, 10]
  double velocity_filter_hz = 25;  ///< (0, 500]: corner of the velocity filter
  double slew_n_s = 50;            ///< (0, 1e6]: largest rate of change of the model's force
  double depth_offset_mm = 0;      ///< [-1000, 1000]: depth of the model where the renderer's depth is 0

  bool operator==(const RendererParameters&) const = default;
};

/// One row per parameter: its key in the model file, its member, and its range.
struct RendererField {
  const char* key;
  double RendererParameters::*member;
  double min;
  double max;
  bool min_excluded;  ///< the parameter must be greater than `min`
};

inline constexpr RendererField kRendererFields[] = {
    {"stiffness_n_mm", &RendererParameters::stiffness_n_mm, 0, 10, true},
    {"damping_n_s_mm", &RendererParameters::damping_n_s_mm, 0, 0.004, false},
    {"breakaway_ratio", &RendererParameters::breakaway_ratio, 0, 1, false},
    {"restick_mm", &RendererParameters::restick_mm, 0, 10, false},
    {"withdrawal_ratio", &RendererParameters::withdrawal_ratio, 0, 10, false},
    {"relaxation_s", &RendererParameters::relaxation_s, 0, 10, true},
    {"ageing_s", &RendererParameters::ageing_s, 0, 100, true},
    {"stick_speed_mm_s", &RendererParameters::stick_speed_mm_s, 0, 1000, false},
    {"stick_time_s", &RendererParameters::stick_time_s, 0, 10, false},
    {"velocity_filter_hz", &RendererParameters::velocity_filter_hz, 0, 500, true},
    {"slew_n_s", &RendererParameters::slew_n_s, 0, 1e6, true},
    {"depth_offset_mm", &RendererParameters::depth_offset_mm, -1000, 1000, false},
};

}  // namespace tactus::fuzzy
