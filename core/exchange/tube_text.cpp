// The texts of the tube in C and JavaScript (tube_source.cpp puts the model's numbers to them).
#include "core/exchange/c_parts.h"

namespace tactus::exchange {

const std::string_view kTubeHeader = R"(#ifndef TUBE_H
#define TUBE_H

#ifdef __cplusplus
extern "C" {
#endif

/* How many conditions there are. */
#define TUBE_CONDITIONS @CONDITIONS@

/* Plain data: copy it to keep it, and copy it back to feel again from there. */
typedef struct tube_state {
  /* What is felt, after each step. */
  double force_n;         /* resistance on the hand, > 0 pushes it out */
  double depth_mm;        /* of the tube: the sum of all slip */
  double speed_mm_s;      /* of the hand, filtered, inwards positive */
  double slip_speed_mm_s; /* of the tube, filtered */
  double stretch_mm;      /* by how much the hand leads the tube */
  double model_force_n;   /* the model's force in effect; 0 while released */
  int phase;              /* 0 released, 1 stuck, 2 sliding */
  int held_last;          /* 1: no rule fires, the last force is held */
  unsigned stroke;        /* from 1; 0: no stroke yet */
  int fault;              /* 0 none; 1 position, 2 force, 3 time out of range: let go until held is 0 */

  /* How it goes on. */
  double conditions[TUBE_CONDITIONS > 0 ? TUBE_CONDITIONS : 1];
  int motion, has_position, any_fired, held, asked_once;
  double position_mm, clip_n, stiction, slow_s, damping_share, speed_first, slip_first, fading_n, fading_rate_n_s;
  double dynamic_n, model_n, asked_depth_mm, asked_speed_mm_s;
  unsigned changes, asked_changes;
  int another_scene, unasked, untaken, answer_fired;
  double fade_s, fade_left_s, difference_n, answer_n, answer_depth_mm, answer_speed_mm_s;
@EVENTS@  double deepest_mm; /* of the tip in the stroke */
@EVENTS@  int events_done;
} tube_state;

/* A tube at depth 0, out of the hand. conditions: TUBE_CONDITIONS values in the order above; may be null where that
 * is 0. They are copied. */
void tube_start(tube_state *tube, const double *conditions);

/* A new placement at depth_mm; strokes count from 1 again. A force that is still there fades within 30 ms. Nothing
 * happens if depth_mm is not finite or beyond 1e6. */
void tube_place(tube_state *tube, double depth_mm);

/* Other conditions from the next step on, without a kick: the difference fades within fade_s (0 to 60 s; 0.05 is
 * usual, and NaN stands for it). */
void tube_change(tube_state *tube, const double *conditions, double fade_s);

/* One step. position_mm: of the hand along the axis, inwards positive, from anywhere. held: whether the hand holds the
 * tube. dt_s: since the last step, 1e-6 to 1 s. Returns force_n. A position that is not finite or beyond 1e6 mm, or a
 * time out of range, lets the tube go until a step with held 0. */
double tube_step(tube_state *tube, double position_mm, int held, double dt_s);

#ifdef __cplusplus
}
#endif

#endif
)";

/// What stands before the recurrences in C.
const std::string_view kTubeStartInC = R"(
enum { RELEASED, STUCK, SLIDING_IN, SLIDING_OUT };
enum { NO_FAULT, POSITION, FORCE, TIME };

/* By its bits, because compilers may be told that all numbers are finite. */
static int is_finite(double x) {
  union {
    double value;
    unsigned long long bits;
  } both;
  both.value = x;
  return (both.bits & 0x7ff0000000000000ULL) != 0x7ff0000000000000ULL;
}

static void copy_conditions(tube_state *t, const double *conditions) {
  int i;
  for (i = 0; i < TUBE_CONDITIONS; ++i) t->conditions[i] = conditions[i];
}

void tube_start(tube_state *t, const double *conditions) {
  static const tube_state kAtRest;
  *t = kAtRest;
  copy_conditions(t, conditions);
  t->another_scene = 1;
}

static void ask_model(tube_state *t, double depth_mm, double speed_mm_s) {
  double inputs[FORCE_MODEL_INPUTS];
@INPUTS@
  t->answer_n = force_model(inputs, &t->answer_fired);
}
)";

/// And in JavaScript.
const std::string_view kTubeStartInJs = R"(
const RELEASED = 0, STUCK = 1, SLIDING_IN = 2, SLIDING_OUT = 3;
const NO_FAULT = 0, POSITION = 1, FORCE = 2, TIME = 3;
const is_finite = Number.isFinite;
@BELL@const exp = Math.exp;

function copy_conditions(t, conditions) {
  t.conditions = Array.from({ length: TUBE_CONDITIONS }, (_, i) => conditions[i]);
}

/* A tube at depth 0, out of the hand. conditions: an array in the order above. Plain data: a copy of the object keeps
 * the tube, and is felt again from there. */
function tubeStart(conditions) {
  const t = {
    /* What is felt, after each step. */
    force_n: 0, depth_mm: 0, speed_mm_s: 0, slip_speed_mm_s: 0, stretch_mm: 0, model_force_n: 0,
    phase: 0, held_last: 0, stroke: 0, fault: 0,
    /* How it goes on. */
    motion: 0, has_position: 0, any_fired: 0, held: 0, asked_once: 0, position_mm: 0, clip_n: 0, stiction: 0,
    slow_s: 0, damping_share: 0, speed_first: 0, slip_first: 0, fading_n: 0, fading_rate_n_s: 0, dynamic_n: 0,
    model_n: 0, asked_depth_mm: 0, asked_speed_mm_s: 0, changes: 0, asked_changes: 0, another_scene: 1, unasked: 0,
    untaken: 0, answer_fired: 0, fade_s: 0, fade_left_s: 0, difference_n: 0, answer_n: 0, answer_depth_mm: 0,
    answer_speed_mm_s: 0
@EVENTS@    , deepest_mm: 0, events_done: 0
  };
  copy_conditions(t, conditions);
  return t;
}

function ask_model(t, depth_mm, speed_mm_s) {
  const inputs = [];
@INPUTS@
  const answer = forceModel(inputs);
  t.answer_n = answer.force;
  t.answer_fired = answer.fired ? 1 : 0;
}
)";

/// A line that begins with `@EVENTS@` is for models with events, one with `@TRAPEZOID@` or `@BELL@` for models in which
/// such a term has an event; here and in the texts above. The recurrences, in the part of C that is JavaScript but for
/// its declarations (`inJavaScript`). So they are written once, and the order of the operations is the same in both.
const std::string_view kTubeBody = R"(
/* Exactly so, also where a number is none. */
static double least(double a, double b) { return b < a ? b : a; }
static double most(double a, double b) { return a < b ? b : a; }
static double within(double x, double lo, double hi) { return x < lo ? lo : hi < x ? hi : x; }
static double size_of(double x) { return x < 0.0 ? -x : x; }
static int is_usable(double position_mm) { return is_finite(position_mm) && size_of(position_mm) <= FARTHEST_MM; }
static double without_dust(double x) { return size_of(x) < SMALLEST ? 0.0 : x; }

/* (1) What is left of a difference. */
static double decay(double elapsed_s, double constant_s) {
  const double x = elapsed_s / constant_s;
  return 1.0 / (1.0 + x * (1.0 + x * (0.5 + x / 6.0)));
}

/* (2) One of two equal low-passes. */
static double filtered(double before, double sample, double dt_s) {
  return without_dust(sample + (before - sample) * decay(dt_s, FILTER_S));
}

/* (3) Other conditions: what they change fades. */
static void fade_scene(tube_state *t, double dt_s) {
  double after_s, share;
  if (t->fade_left_s <= 0.0 || !(dt_s >= SHORTEST_S)) return;
  after_s = t->fade_left_s - dt_s;
  share = after_s > 1e-9 ? after_s / t->fade_left_s : 0.0;
  if (t->difference_n != 0.0) ++t->changes;
  t->difference_n *= share;
  t->fade_left_s = share > 0.0 ? after_s : 0.0;
}

static void take_scene(tube_state *t) {
  if (t->another_scene) {
    t->another_scene = 0;
    t->unasked = 1;
    ++t->changes;
    t->untaken = 1;
    t->fade_left_s = most(t->fade_left_s, t->fade_s);
  }
  if (t->motion != RELEASED) return;
  t->difference_n = 0.0;
  t->fade_left_s = 0.0;
  t->untaken = 0;
}

@EVENTS@/* (15) Events: each whose place the tip has reached in this stroke takes a share of the model's force. */
@TRAPEZOID@static double trapezoid(double x, double a, double b, double c, double d) {
@TRAPEZOID@  if (x < b) return x > a ? (x - a) / (b - a) : 0.0;
@TRAPEZOID@  if (x <= c) return 1.0;
@TRAPEZOID@  return x < d ? (d - x) / (d - c) : 0.0;
@TRAPEZOID@}
@TRAPEZOID@
@BELL@static double bell(double x, double mean, double sigma) {
@BELL@  const double u = (x - mean) / sigma;
@BELL@  return exp(-0.5 * u * u);
@BELL@}
@BELL@
@EVENTS@static double left_by_events(const tube_state *t, double way_mm) {
@EVENTS@  const double x = within(way_mm, WAY_MIN_MM, WAY_MAX_MM);
@EVENTS@  double left = 1.0;
@EVENTS@@SHARES@
@EVENTS@  return left;
@EVENTS@}
@EVENTS@
@EVENTS@static void take_events(tube_state *t) {
@EVENTS@  int done = 0;
@EVENTS@  t->deepest_mm = t->motion == RELEASED ? t->depth_mm : most(t->deepest_mm, t->depth_mm);
@EVENTS@@COUNTS@
@EVENTS@  if (done == t->events_done) return;
@EVENTS@  t->events_done = done;
@EVENTS@  t->unasked = 1;
@EVENTS@  ++t->changes;
@EVENTS@}
@EVENTS@
/* (4) Whether and where the model is asked. */
static int engages(const tube_state *t, double position_mm, int held) {
  return held && t->fault == NO_FAULT && is_usable(position_mm) &&
         (t->motion != RELEASED || size_of(t->speed_mm_s) < ENGAGE_MM_S);
}

static int is_asked(const tube_state *t, double depth_mm, double speed_mm_s) {
  return !(t->asked_once && t->asked_depth_mm == depth_mm && t->asked_speed_mm_s == speed_mm_s &&
           t->asked_changes == t->changes);
}

/* (5) The model's force, with what is left of the conditions before. */
static double answer(tube_state *t, double depth_mm, double speed_mm_s) {
  const double before_n = t->answer_n;
  const int before_fired = t->answer_fired;
  if (t->unasked || t->answer_depth_mm != depth_mm || t->answer_speed_mm_s != speed_mm_s) {
    ask_model(t, depth_mm, speed_mm_s);
@EVENTS@    t->answer_n *= left_by_events(t, depth_mm);
    t->answer_depth_mm = depth_mm;
    t->answer_speed_mm_s = speed_mm_s;
    t->unasked = 0;
  }
  if (t->untaken && (t->answer_fired || !t->any_fired)) {
    const double in_use_n = before_fired ? most(0.0, before_n + t->difference_n) : t->model_n;
    t->untaken = 0;
    t->fade_left_s = most(t->fade_left_s, t->fade_s);
    t->difference_n = t->fade_left_s > 0.0 ? in_use_n - t->answer_n : 0.0;
  }
  return t->answer_n + t->difference_n;
}

/* (6) The friction in one direction, with a share of the break-away surplus. */
static double limit(const tube_state *t, int direction, double share) {
  const double ratio = direction == SLIDING_OUT ? RHO : 1.0;
  return least(CAP_N, (1.0 + share * TAU) * ratio * t->dynamic_n);
}
static double sign_of(int direction) { return direction == SLIDING_OUT ? -1.0 : 1.0; }
static double spring(int direction, double stretch_mm) { return sign_of(direction) * K * stretch_mm; }
static int is_blocked(const tube_state *t, int direction) {
  return direction == SLIDING_IN ? t->depth_mm >= DEEPEST_MM : t->depth_mm <= 0.0;
}
static int is_sliding(const tube_state *t) { return t->motion == SLIDING_IN || t->motion == SLIDING_OUT; }

static void stick(tube_state *t) {
  t->motion = STUCK;
  t->stiction = 0.0;
  t->slow_s = 0.0;
}

/* (7) At an end the tube gives way without a depth. */
static void hold_back(tube_state *t, int direction, double before_n, double dt_s) {
  const int out = direction == SLIDING_OUT;
  const double rest_n = out ? 0.0 : limit(t, direction, t->stiction);
  const double surplus_n = most(0.0, before_n - rest_n);
  const double most_n = rest_n + surplus_n * decay(dt_s, out ? TUBE_OUT_S : RELAXATION_S);
  if (spring(direction, t->stretch_mm) > most_n) t->stretch_mm = sign_of(direction) * most_n / K;
}

/* (8) From stuck to sliding. */
static void break_away(tube_state *t, double stretch_before_mm, double dt_s) {
  int direction;
  for (direction = SLIDING_IN; direction <= SLIDING_OUT; ++direction) {
    const double before_n = least(CAP_N, spring(direction, stretch_before_mm));
    double most_n;
    if (is_blocked(t, direction)) {
      hold_back(t, direction, before_n, dt_s);
      continue;
    }
    most_n = limit(t, direction, t->stiction);
    if (!(spring(direction, t->stretch_mm) > most_n)) continue;
    t->motion = direction;
    t->slow_s = 0.0;
    t->clip_n = most(most_n, before_n);
    return;
  }
}

/* (9) Sliding: what is cut off the spring is depth. */
static void slip(tube_state *t) {
  const int direction = t->motion;
  const int back = direction == SLIDING_IN ? SLIDING_OUT : SLIDING_IN;
  const double pull_n = spring(direction, t->stretch_mm);
  double back_n;
  if (pull_n > t->clip_n) {
    const double clipped_mm = sign_of(direction) * t->clip_n / K;
    const double depth_mm = t->depth_mm + (t->stretch_mm - clipped_mm);
    t->stretch_mm = clipped_mm;
    t->depth_mm = direction == SLIDING_IN ? least(depth_mm, most(t->depth_mm, DEEPEST_MM))
                                          : most(depth_mm, least(t->depth_mm, 0.0));
    if (is_blocked(t, direction)) stick(t);
    return;
  }
  back_n = is_blocked(t, back) ? 0.0 : limit(t, back, 0.0);
  if (pull_n < most(t->clip_n - K * RESTICK_MM, -back_n)) stick(t);
}

/* (10) */
static void stick_when_slow(tube_state *t, double dt_s) {
  const int slow = size_of(t->slip_speed_mm_s) < STICK_SPEED_MM_S;
  t->slow_s = slow ? t->slow_s + dt_s : 0.0;
  if (slow && t->slow_s >= STICK_TIME_S) stick(t);
}

/* (11) The friction moves by what the hand has moved. */
static void rub(tube_state *t, double moved_mm, double dt_s) {
  const double stretch_before_mm = t->stretch_mm;
  double share;
  t->stretch_mm += moved_mm;
  if (t->motion == STUCK) {
    t->stiction = 1.0 - (1.0 - t->stiction) * decay(dt_s, AGEING_S);
    break_away(t, stretch_before_mm, dt_s);
  }
  if (is_sliding(t)) {
    const double target_n = limit(t, t->motion, 0.0);
    t->clip_n = target_n + (t->clip_n - target_n) * decay(dt_s, RELAXATION_S);
    slip(t);
    if (t->motion == STUCK) break_away(t, stretch_before_mm, dt_s);
    if (is_sliding(t)) slip(t);
    if (is_sliding(t)) stick_when_slow(t, dt_s);
  }
  share = t->motion == STUCK ? 1.0 : 0.0;
  t->damping_share =
      share + (t->damping_share - share) * decay(dt_s, t->motion == STUCK ? DAMPING_IN_S : DAMPING_OUT_S);
  if (size_of(t->stretch_mm) < SMALLEST) t->stretch_mm = 0.0;
  if (t->damping_share < SMALLEST) t->damping_share = 0.0;
}

/* (12) */
static void let_go(tube_state *t) {
  if (t->motion != RELEASED) {
    t->fading_n = t->force_n;
    t->fading_rate_n_s = size_of(t->force_n) / RELEASE_S;
  }
  t->motion = RELEASED;
  t->stretch_mm = 0.0;
  t->clip_n = 0.0;
  t->slow_s = 0.0;
  t->damping_share = 0.0;
}

/* (13) A stroke begins at force 0. */
static void engage(tube_state *t) {
  t->motion = STUCK;
  t->stretch_mm = 0.0;
  t->stiction = 1.0;
  t->dynamic_n = t->model_n;
  ++t->stroke;
}

static void tell(tube_state *t) {
  t->phase = t->motion > SLIDING_IN ? SLIDING_IN : t->motion;
  t->model_force_n = t->motion != RELEASED ? t->dynamic_n : 0.0;
  t->held_last = t->motion != RELEASED && t->held ? 1 : 0;
}

void tube_place(tube_state *t, double depth_mm) {
  if (!is_usable(depth_mm)) return;
  t->fading_rate_n_s = most(size_of(t->force_n) / RELEASE_S, t->fading_n != 0.0 ? t->fading_rate_n_s : 0.0);
  t->fading_n = t->force_n;
  t->motion = RELEASED;
  t->depth_mm = depth_mm;
  t->stretch_mm = 0.0;
  t->clip_n = 0.0;
  t->stiction = 0.0;
  t->slow_s = 0.0;
  t->damping_share = 0.0;
  t->slip_first = 0.0;
  t->slip_speed_mm_s = 0.0;
  t->dynamic_n = 0.0;
  t->model_n = 0.0;
  t->any_fired = 0;
  t->held = 0;
  t->asked_once = 0;
  t->stroke = 0;
  tell(t);
}

void tube_change(tube_state *t, const double *conditions, double fade_s) {
  copy_conditions(t, conditions);
  t->fade_s = fade_s != fade_s ? 0.05 : within(fade_s, 0.0, 60.0);
  t->another_scene = 1;
}

double tube_step(tube_state *t, double position_mm, int held, double dt_s) {
  const int on_time = is_finite(dt_s) && dt_s >= SHORTEST_S && dt_s <= LONGEST_S;
  double depth_mm, speed_mm_s, depth_before_mm, force_n = 0.0, moved_mm = 0.0, step_n;
  int engaged, asked;

  /* (14) In this order. */
  fade_scene(t, dt_s);
  take_scene(t);
@EVENTS@  take_events(t);
  engaged = engages(t, position_mm, held);
  depth_mm = t->depth_mm + OFFSET_MM;
  speed_mm_s = t->motion == SLIDING_IN ? most(0.0, t->slip_speed_mm_s) : 0.0;
  asked = engaged && is_asked(t, depth_mm, speed_mm_s);
  if (asked) force_n = answer(t, depth_mm, speed_mm_s);

  if (!on_time) {
    t->fault = TIME;
  } else if (!is_usable(position_mm)) {
    t->fault = POSITION;
  } else if (!held) {
    t->fault = NO_FAULT;
  } else if (t->fault == NO_FAULT && asked && !is_finite(force_n)) {
    t->fault = FORCE;
  }
  if (t->fault == TIME) {
    let_go(t);
    t->force_n = t->fading_n = 0.0;
    t->has_position = 0;
    t->speed_mm_s = t->speed_first = t->slip_speed_mm_s = t->slip_first = 0.0;
    tell(t);
    return t->force_n;
  }

  if (!is_usable(position_mm)) {
    t->has_position = 0;
    t->speed_mm_s = t->speed_first = 0.0;
  } else {
    moved_mm = t->has_position ? position_mm - t->position_mm : 0.0;
    t->has_position = 1;
    t->position_mm = position_mm;
    t->speed_first = filtered(t->speed_first, moved_mm / dt_s, dt_s);
    t->speed_mm_s = filtered(t->speed_mm_s, t->speed_first, dt_s);
  }
  if (asked && t->fault == NO_FAULT) {
    t->asked_once = 1;
    t->asked_depth_mm = depth_mm;
    t->asked_speed_mm_s = speed_mm_s;
    t->asked_changes = t->changes;
    t->held = !t->answer_fired;
    if (t->answer_fired || !t->any_fired) t->model_n = most(0.0, force_n);
    t->any_fired = t->any_fired || t->answer_fired;
  }
  depth_before_mm = t->depth_mm;
  if (t->fault != NO_FAULT || !engaged) {
    let_go(t);
  } else if (t->motion == RELEASED) {
    engage(t);
  } else {
    step_n = SLEW_N_S * dt_s;
    t->dynamic_n += within(t->model_n - t->dynamic_n, -step_n, step_n);
    rub(t, moved_mm, dt_s);
  }
  t->slip_first = filtered(t->slip_first, (t->depth_mm - depth_before_mm) / dt_s, dt_s);
  t->slip_speed_mm_s = filtered(t->slip_speed_mm_s, t->slip_first, dt_s);

  step_n = t->fading_rate_n_s * dt_s;
  t->fading_n = size_of(t->fading_n) > step_n ? t->fading_n - (t->fading_n < 0.0 ? -step_n : step_n) : 0.0;
  {
    const double most_n = DAMPING_SHARE * t->dynamic_n;
    const double damping_n = t->damping_share * MU * t->speed_mm_s;
    t->force_n =
        within(K * t->stretch_mm + within(damping_n, -most_n, most_n) + t->fading_n, -CAP_N, CAP_N);
  }
  tell(t);
  return t->force_n;
}
)";

}  // namespace tactus::exchange
