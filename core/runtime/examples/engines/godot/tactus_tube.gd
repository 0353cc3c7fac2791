# The tube of Tactus in GDScript: what a hand feels that pushes it in, stroke by stroke. Written from docs/renderer.md, whose
# numbers stand in parentheses. Lengths are mm, times s, forces N.
#
#   var tube = preload("tactus_tube.gd").new(model, [lubrication, neck_flexion])   # model: of tactus_force.gd
#   var force_n = tube.step(position_mm, held, delta)                              # each tick; > 0 pushes the hand out

const Force = preload("tactus_force.gd")

enum { RELEASED, STUCK, SLIDING_IN, SLIDING_OUT }
enum { NO_FAULT, POSITION, FORCE, TIME }

const CAP_N = 2.0
const DUST = 1e-12

# What is felt, after each step.
var force_n = 0.0
var depth_mm = 0.0
var phase = RELEASED
var fault = NO_FAULT  # other than NO_FAULT: the tube is let go until a step without a hand
var stroke = 0

var _model
var _depth = -1  # the places of these inputs in the model, and of the others
var _speed = -1
var _others = []
var _k = 0.25
var _mu = 0.0005
var _tau = 0.15
var _rho = 0.6
var _restick_mm = 0.12
var _relaxation_s = 0.01
var _ageing_s = 0.1
var _stick_speed_mm_s = 2.0
var _stick_time_s = 0.05
var _filter_s = 0.0
var _slew_n_s = 50.0
var _offset_mm = 0.0
var _end_mm = 0.0
var _events = []  # [place, share, corners]

var _conditions = []
var _position_mm = null
var _stretch_mm = 0.0  # z
var _clip_n = 0.0
var _stiction = 0.0  # s
var _slow_s = 0.0
var _damping = 0.0  # g
var _speed_first = 0.0
var _speed_mm_s = 0.0
var _slip_first = 0.0
var _slip_mm_s = 0.0
var _fading_n = 0.0
var _fading_n_s = 0.0
var _dynamic_n = 0.0  # F_d
var _model_n = 0.0
var _any_fired = false
var _asked = null  # [depth, speed, changes] of the last question
var _new_scene = true
var _unasked = false
var _untaken = false
var _answer_n = 0.0
var _answer_fired = false
var _answer_at = [0.0, 0.0]
var _difference_n = 0.0
var _fade_left_s = 0.0
var _fade_s = 0.0
var _changes = 0
var _deepest_mm = 0.0
var _events_done = 0


# conditions: the values of the inputs but depth and speed, in the model's order.
func _init(model, conditions):
	_model = model
	_conditions = conditions.duplicate()
	for i in range(model.inputs.size()):
		var role = model.inputs[i].get("role", {"depth": "way", "speed": "rate"}.get(model.inputs[i]["id"], ""))
		if role == "way":
			_depth = i
		elif role == "rate":
			_speed = i
		else:
			_others.append(i)
	var numbers = model.document.get("renderer", {})
	_k = float(numbers.get("stiffness_n_mm", _k))
	_mu = float(numbers.get("damping_n_s_mm", _mu))
	_tau = float(numbers.get("breakaway_ratio", _tau))
	_rho = float(numbers.get("withdrawal_ratio", _rho))
	_restick_mm = float(numbers.get("restick_mm", _restick_mm))
	_relaxation_s = float(numbers.get("relaxation_s", _relaxation_s))
	_ageing_s = float(numbers.get("ageing_s", _ageing_s))
	_stick_speed_mm_s = float(numbers.get("stick_speed_mm_s", _stick_speed_mm_s))
	_stick_time_s = float(numbers.get("stick_time_s", _stick_time_s))
	_filter_s = 1.0 / (2.0 * PI * float(numbers.get("velocity_filter_hz", 25.0)))
	_slew_n_s = float(numbers.get("slew_n_s", _slew_n_s))
	_offset_mm = float(numbers.get("depth_offset_mm", _offset_mm))
	var way = model.inputs[_depth]
	_end_mm = float(way["max"]) - _offset_mm
	for event in model.document.get("events", []):
		for term in model.shapes(way["terms"]):
			if term["id"] == event["term"]:
				var core_end = term["points"][0] if term["points"].size() == 2 else term["points"][2]
				var place_mm = Force.within(core_end, float(way["min"]), float(way["max"])) - _offset_mm
				_events.append([place_mm, float(event["share"]), term["points"]])


# Other conditions from the next step on; the difference in force fades.
func change(conditions, fade_s):
	_conditions = conditions.duplicate()
	_fade_s = 0.05 if is_nan(fade_s) else Force.within(fade_s, 0.0, 60.0)
	_new_scene = true


# One tick; returns force_n. held: whether the hand holds the tube. dt_s: since the last step, 1e-6 to 1.
func step(position_mm, held, dt_s):
	_fade_scene(dt_s)
	_take_scene()
	_take_events()
	var engaged = held and fault == NO_FAULT and _usable(position_mm) and (phase != RELEASED or abs(_speed_mm_s) < 300.0)
	var at = [depth_mm + _offset_mm, Force.most(0.0, _slip_mm_s) if phase == SLIDING_IN else 0.0]
	var question = at + [_changes]
	var asked = engaged and question != _asked
	var wanted_n = _answer(at) if asked else 0.0

	if not (dt_s >= 1e-6 and dt_s <= 1.0):
		fault = TIME
	elif not _usable(position_mm):
		fault = POSITION
	elif not held:
		fault = NO_FAULT
	elif fault == NO_FAULT and asked and (is_nan(wanted_n) or is_inf(wanted_n)):
		fault = FORCE
	if fault == TIME:
		_let_go()
		force_n = 0.0
		_fading_n = 0.0
		_position_mm = null
		_speed_first = 0.0
		_speed_mm_s = 0.0
		_slip_first = 0.0
		_slip_mm_s = 0.0
		return force_n

	var moved_mm = 0.0
	if _usable(position_mm):
		if _position_mm != null:
			moved_mm = position_mm - _position_mm
		_position_mm = position_mm
		_speed_first = _filtered(_speed_first, moved_mm / dt_s, dt_s)
		_speed_mm_s = _filtered(_speed_mm_s, _speed_first, dt_s)
	else:
		_position_mm = null
		_speed_first = 0.0
		_speed_mm_s = 0.0
	if asked and fault == NO_FAULT:
		_asked = question
		if _answer_fired or not _any_fired:
			_model_n = Force.most(0.0, wanted_n)
		_any_fired = _any_fired or _answer_fired
	var depth_before_mm = depth_mm
	if fault != NO_FAULT or not engaged:
		_let_go()
	elif phase == RELEASED:  # (13) a stroke begins at force 0
		phase = STUCK
		_stretch_mm = 0.0
		_stiction = 1.0
		_dynamic_n = _model_n
		stroke += 1
	else:
		_dynamic_n += Force.within(_model_n - _dynamic_n, -_slew_n_s * dt_s, _slew_n_s * dt_s)
		_rub(moved_mm, dt_s)
	_slip_first = _filtered(_slip_first, (depth_mm - depth_before_mm) / dt_s, dt_s)
	_slip_mm_s = _filtered(_slip_mm_s, _slip_first, dt_s)

	var faded_n = _fading_n_s * dt_s
	_fading_n = _fading_n - (-faded_n if _fading_n < 0.0 else faded_n) if abs(_fading_n) > faded_n else 0.0
	var most_n = 0.2 * _dynamic_n
	var damping_n = Force.within(_damping * _mu * _speed_mm_s, -most_n, most_n)
	force_n = Force.within(_k * _stretch_mm + damping_n + _fading_n, -CAP_N, CAP_N)
	return force_n


func _usable(position_mm):
	return not is_nan(position_mm) and abs(position_mm) <= 1e6


# (1) What is left of a difference.
func _decay(elapsed_s, constant_s):
	var x = elapsed_s / constant_s
	return 1.0 / (1.0 + x * (1.0 + x * (0.5 + x / 6.0)))


# (2) One of two equal low-passes.
func _filtered(before, sample, dt_s):
	var value = sample + (before - sample) * _decay(dt_s, _filter_s)
	return 0.0 if abs(value) < DUST else value


# (3) Other conditions: what they change fades.
func _fade_scene(dt_s):
	if _fade_left_s <= 0.0 or not dt_s >= 1e-6:
		return
	var after_s = _fade_left_s - dt_s
	var share = after_s / _fade_left_s if after_s > 1e-9 else 0.0
	if _difference_n != 0.0:
		_changes += 1
	_difference_n *= share
	_fade_left_s = after_s if share > 0.0 else 0.0


func _take_scene():
	if _new_scene:
		_new_scene = false
		_unasked = true
		_changes += 1
		_untaken = true
		_fade_left_s = Force.most(_fade_left_s, _fade_s)
	if phase == RELEASED:
		_difference_n = 0.0
		_fade_left_s = 0.0
		_untaken = false


# (15) Events: each whose place the tip has reached in this stroke takes a share of the model's force.
func _take_events():
	_deepest_mm = depth_mm if phase == RELEASED else Force.most(_deepest_mm, depth_mm)
	var done = 0
	for event in _events:
		if event[0] <= _deepest_mm:
			done += 1
	if done != _events_done:
		_events_done = done
		_unasked = true
		_changes += 1


# (5) The model's force, with what is left of the conditions before. at: depth and speed.
func _answer(at):
	var before_n = _answer_n
	var before_fired = _answer_fired
	if _unasked or at != _answer_at:
		var values = []
		for _input in _model.inputs:
			values.append(0.0)
		for i in range(_others.size()):
			values[_others[i]] = _conditions[i]
		values[_depth] = at[0]
		if _speed >= 0:
			values[_speed] = at[1]
		_answer_n = _model.force(values)
		_answer_fired = _model.fired
		var way = _model.inputs[_depth]
		var left = 1.0
		for event in _events:
			if event[0] <= _deepest_mm:
				var within_mm = Force.within(at[0], float(way["min"]), float(way["max"]))
				left *= 1.0 - event[1] * (_model.membership(event[2], within_mm) / _model.SCALE)
		_answer_n *= left
		_answer_at = at
		_unasked = false
	if _untaken and (_answer_fired or not _any_fired):
		var in_use_n = Force.most(0.0, before_n + _difference_n) if before_fired else _model_n
		_untaken = false
		_fade_left_s = Force.most(_fade_left_s, _fade_s)
		_difference_n = in_use_n - _answer_n if _fade_left_s > 0.0 else 0.0
	return _answer_n + _difference_n


# (6) The friction in one direction, with a share of the surplus at break-away.
func _limit(direction, share):
	var ratio = _rho if direction == SLIDING_OUT else 1.0
	return Force.least(CAP_N, (1.0 + share * _tau) * ratio * _dynamic_n)


func _sign(direction):
	return -1.0 if direction == SLIDING_OUT else 1.0


func _spring(direction, stretch_mm):
	return _sign(direction) * _k * stretch_mm


func _blocked(direction):
	return depth_mm >= _end_mm if direction == SLIDING_IN else depth_mm <= 0.0


func _sliding():
	return phase == SLIDING_IN or phase == SLIDING_OUT


func _stick():
	phase = STUCK
	_stiction = 0.0
	_slow_s = 0.0


# (7) At an end the tube gives way without a depth.
func _hold(direction, before_n, dt_s):
	var out = direction == SLIDING_OUT
	var rest_n = 0.0 if out else _limit(direction, _stiction)
	var most_n = rest_n + Force.most(0.0, before_n - rest_n) * _decay(dt_s, 0.01 if out else _relaxation_s)
	if _spring(direction, _stretch_mm) > most_n:
		_stretch_mm = _sign(direction) * most_n / _k


# (8) From stuck to sliding.
func _break_away(stretch_before_mm, dt_s):
	for direction in [SLIDING_IN, SLIDING_OUT]:
		var before_n = Force.least(CAP_N, _spring(direction, stretch_before_mm))
		if _blocked(direction):
			_hold(direction, before_n, dt_s)
			continue
		var most_n = _limit(direction, _stiction)
		if _spring(direction, _stretch_mm) > most_n:
			phase = direction
			_slow_s = 0.0
			_clip_n = Force.most(most_n, before_n)
			return


# (9) Sliding: what is cut off the spring is depth.
func _slip():
	var direction = phase
	var pull_n = _spring(direction, _stretch_mm)
	if pull_n > _clip_n:
		var clipped_mm = _sign(direction) * _clip_n / _k
		var to_mm = depth_mm + (_stretch_mm - clipped_mm)
		_stretch_mm = clipped_mm
		if direction == SLIDING_IN:
			depth_mm = Force.least(to_mm, Force.most(depth_mm, _end_mm))
		else:
			depth_mm = Force.most(to_mm, Force.least(depth_mm, 0.0))
		if _blocked(direction):
			_stick()
		return
	var back = SLIDING_OUT if direction == SLIDING_IN else SLIDING_IN
	var back_n = 0.0 if _blocked(back) else _limit(back, 0.0)
	if pull_n < Force.most(_clip_n - _k * _restick_mm, -back_n):
		_stick()


# (10)
func _stick_when_slow(dt_s):
	var slow = abs(_slip_mm_s) < _stick_speed_mm_s
	_slow_s = _slow_s + dt_s if slow else 0.0
	if slow and _slow_s >= _stick_time_s:
		_stick()


# (11) The friction moves by what the hand has moved.
func _rub(moved_mm, dt_s):
	var before_mm = _stretch_mm
	_stretch_mm += moved_mm
	if phase == STUCK:
		_stiction = 1.0 - (1.0 - _stiction) * _decay(dt_s, _ageing_s)
		_break_away(before_mm, dt_s)
	if _sliding():
		var target_n = _limit(phase, 0.0)
		_clip_n = target_n + (_clip_n - target_n) * _decay(dt_s, _relaxation_s)
		_slip()
		if phase == STUCK:
			_break_away(before_mm, dt_s)
		if _sliding():
			_slip()
		if _sliding():
			_stick_when_slow(dt_s)
	var share = 1.0 if phase == STUCK else 0.0
	_damping = share + (_damping - share) * _decay(dt_s, 0.02 if phase == STUCK else 0.01)
	if abs(_stretch_mm) < DUST:
		_stretch_mm = 0.0
	if _damping < DUST:
		_damping = 0.0


# (12)
func _let_go():
	if phase != RELEASED:
		_fading_n = force_n
		_fading_n_s = abs(force_n) / 0.03
	phase = RELEASED
	_stretch_mm = 0.0
	_clip_n = 0.0
	_slow_s = 0.0
	_damping = 0.0
