# The force of a model of Tactus, in GDScript alone: nothing to compile, nothing beside the model file. What is computed:
# docs/semantics.md. Terms of the force are trapezoids or triangles here; `trouble` says so where one is a Gaussian.
#
#   var model = preload("tactus_force.gd").new(the parsed JSON of *.tactus.json)
#   var force_n = model.force([0.8, 30.0, 120.0, 80.0])   # in the order of model.inputs; model.fired: a rule fires

const SCALE = 1.3407807929942597e154  # 2^512: memberships are multiplied by it, so that the smallest keep their digits
const LEAST = 1e-300                  # of a strength that fires

var trouble = ""   # why there are no forces
var fired = false  # whether a rule fired at the last point
var inputs = []    # as in the file: id, unit, min, max, terms, role
var document = {}  # the whole file

var _output = {}
var _experts = []  # weight, inputs (the terms of each), output (the terms), rules ([then, weight, input, term, ...])
var _scales = false


func _init(parsed):
	if typeof(parsed) != TYPE_DICTIONARY or parsed.get("format", "") != "tactus-force-model" or int(parsed.get("version", 0)) != 1:
		trouble = "this is no model file of version 1"
		return
	document = parsed
	inputs = parsed["inputs"]
	_output = parsed["output"]
	_scales = parsed["inference"]["implication"] == "scale"
	for expert in parsed["experts"]:
		if float(expert["weight"]) > 0.0:
			_experts.append(_prepared(expert))


# Godot 3 has min, max and clamp, but rounds their numbers to 32 bits.
static func least(a, b):
	return b if b < a else a


static func most(a, b):
	return b if a < b else a


static func within(x, lo, hi):
	return lo if x < lo else (hi if hi < x else x)


# The averaged force in N; NAN where a value is not finite. Values beyond an input's ends are taken at its end.
func force(values):
	fired = false
	if trouble != "":
		return NAN
	var at = []
	for i in range(inputs.size()):
		var value = float(values[i])
		if is_nan(value) or is_inf(value):
			return NAN
		at.append(within(value, float(inputs[i]["min"]), float(inputs[i]["max"])))
	var mean = 0.0
	var weights = 0.0
	for expert in _experts:
		var strengths = _strengths(expert, at)
		var largest = strengths.max()
		if largest == 0.0:
			continue
		weights += expert["weight"]
		mean += (_centroid(expert["output"], strengths, largest) - mean) * (expert["weight"] / weights)
	fired = weights > 0.0
	return float(_output["min"]) + mean if fired else float(document.get("default_force_n", 0.0))


func _prepared(expert):
	var own = expert.get("terms", {})
	var terms = []
	var places = {}
	for i in range(inputs.size()):
		terms.append(shapes(own.get(inputs[i]["id"], inputs[i]["terms"])))
		places[inputs[i]["id"]] = i
	var output = shapes(own.get(_output["id"], _output["terms"]))
	for term in output:
		if term["points"].size() == 2:
			trouble = "the term %s of the force is a Gaussian, which tactus_force.gd does not know" % term["id"]
	var rules = []
	for rule in expert["rules"]:
		if not rule.get("enabled", true) or float(rule.get("weight", 1.0)) == 0.0:
			continue
		var one = [_place(output, rule["then"]), float(rule.get("weight", 1.0))]
		for id in rule["if"]:
			one.append(places[id])
			one.append(_place(terms[places[id]], rule["if"][id]))
		rules.append(one)
	return {"weight": float(expert["weight"]), "inputs": terms, "output": output, "rules": rules}


func _place(terms, id):
	for t in range(terms.size()):
		if terms[t]["id"] == id:
			return t
	return -1


# Terms as {id, points}: four corners of a trapezoid, or mean and sigma.
func shapes(terms):
	var out = []
	for term in terms:
		var points = []
		for point in term["points"]:
			points.append(float(point))
		if term["shape"] == "triangle":
			points.insert(1, points[1])
		out.append({"id": term["id"], "points": points})
	return out


# Of x in a term, times SCALE.
func membership(points, x):
	if points.size() == 2:
		var u = (x - points[0]) / points[1]
		return SCALE * exp(-0.5 * u * u)
	if x < points[1]:
		return most(SCALE * (x - points[0]) / (points[1] - points[0]), LEAST) if x > points[0] else 0.0
	if x <= points[2]:
		return SCALE
	return most(SCALE * (points[3] - x) / (points[3] - points[2]), LEAST) if x < points[3] else 0.0


# The strength of each term of the force, times SCALE.
func _strengths(expert, at):
	var memberships = []
	for i in range(at.size()):
		var row = []
		for term in expert["inputs"][i]:
			row.append(membership(term["points"], at[i]))
		memberships.append(row)
	var strengths = []
	for _term in expert["output"]:
		strengths.append(0.0)
	for rule in expert["rules"]:
		var fits = SCALE
		for k in range(2, rule.size(), 2):
			fits = least(fits, memberships[rule[k]][rule[k + 1]])
			if fits == 0.0:
				break
		if fits > 0.0:
			strengths[rule[0]] = most(strengths[rule[0]], most(rule[1] * fits, LEAST))
	return strengths


# A trapezoid under its rule's strength, [left, left of the top, right of the top, right, height]; heights are relative to
# the largest.
func _under(points, strength, largest):
	var top = 1.0 if _scales else most(strength / SCALE, LEAST)
	var left = points[0] + top * (points[1] - points[0])
	var right = points[3] - top * (points[3] - points[2])
	if left > right:
		left = (left + right) / 2.0
		right = left
	return [points[0], left, right, points[3], strength / largest]


func _height(one, x):
	if x < one[1]:
		return one[4] * ((x - one[0]) / (one[1] - one[0]))
	if x > one[2]:
		return one[4] * ((one[3] - x) / (one[3] - one[2]))
	return one[4]


# The centroid under the largest of the sets, from the lower end of the force. That largest is made of straight lines; the
# area under each is taken exactly.
func _centroid(terms, strengths, largest):
	var lo = float(_output["min"])
	var hi = float(_output["max"])
	var sets = []
	var edges = []
	for t in range(terms.size()):
		if strengths[t] > 0.0:
			var under = _under(terms[t]["points"], strengths[t], largest)
			sets.append(under)
			for k in range(4):
				edges.append(within(under[k], lo, hi))
	edges.sort()
	var sum = [0.0, 0.0]  # area, moment
	for i in range(1, edges.size()):
		var width = edges[i] - edges[i - 1]
		if width > 0.0:
			_add(sets, edges[i - 1], edges[i], edges[i - 1] - edges[0], sum)
	return edges[0] - lo + (sum[1] / sum[0] if sum[0] > 0.0 else 0.0)


# Adds what lies between two neighboring corners. start: `from`, counted from the first corner.
func _add(sets, from, to, start, sum):
	var width = to - from
	var lines = []  # [height at from, height at to]
	for one in sets:
		if one[0] <= from and to <= one[3]:
			lines.append([_height(one, from), _height(one, to)])
	if lines.size() == 0:
		return
	var top = lines[0]
	for line in lines:
		if line[0] > top[0] or (line[0] == top[0] and line[1] > top[1]):
			top = line
	var t = 0.0
	while t < 1.0:
		# The next line that rises above the one on top.
		var next = 1.0
		var follower = null
		for line in lines:
			if line[1] > top[1]:
				var below = top[0] - line[0]
				var crossing = most(t, below / (below + (line[1] - top[1])))
				if crossing < next or (follower != null and crossing == next and line[1] > follower[1]):
					next = crossing
					follower = line
		var slope = top[1] - top[0]
		var y0 = top[0] + t * slope
		var y1 = top[0] + next * slope
		var part = (next - t) * width
		var piece = part * (y0 + y1) / 2.0
		sum[0] += piece
		sum[1] += piece * (start + t * width) + part * part * (y0 + 2.0 * y1) / 6.0
		if follower == null:
			break
		t = next
		top = follower
