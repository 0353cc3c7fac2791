# Proves the tube in Godot 3: a node is put where each row of BUNDLE/checks_tube.csv says, and the force there must be the
# row's. Then two strokes of a free hand. Ends with 1 where a force is not within 1e-12 N.
#   godot3-server --path . -s prove.gd BUNDLE
# In Godot 4 a file is opened by FileAccess.open(path, FileAccess.READ), its JSON read by JSON.parse_string(text), a number by
# text.to_float(), a node is Node3D.new(), the time is Time.get_ticks_usec(); tactus_force.gd and tactus_tube.gd are meant
# to stay as they are.
extends SceneTree

const Force = preload("tactus_force.gd")
const Tube = preload("tactus_tube.gd")
const MM = 1000.0  # Godot works in m, the tube in mm


func _init():
	var arguments = OS.get_cmdline_args()
	quit(0 if prove(arguments[arguments.size() - 1]) else 1)


func text_of(path):
	var file = File.new()
	if file.open(path, File.READ) != OK:
		print("%s cannot be read" % path)
		return ""
	return file.get_as_text()


# float(text) has 32 bits only.
func number(text):
	return float(str2var(text))


func prove(bundle):
	var file = text_of(bundle + "/model.tactus.json")
	var checks = text_of(bundle + "/checks_tube.csv")
	if file == "" or checks == "":
		return false
	var model = Force.new(JSON.parse(file).result)
	if model.trouble != "":
		print(model.trouble)
		return false
	var rows = checks.strip_edges().split("\n")
	var head = rows[0].split(",")
	var last = Array(head).find("force_n")
	var tip = Spatial.new()
	root.add_child(tip)

	var tube = null
	var trace = ""
	var before = []
	var first = []
	var worst = 0.0
	var begun = OS.get_ticks_usec()
	for r in range(1, rows.size()):
		var cells = rows[r].split(",")
		var conditions = []
		for c in range(5, last):
			conditions.append(number(cells[c]))
		if cells[0] != trace:
			tube = Tube.new(model, conditions)
			trace = cells[0]
		elif conditions != before:
			tube.change(conditions, 0.05)
		if first.size() == 0:
			first = conditions
		before = conditions
		# A place in the engine is a float of 32 bits: within a metre it still tells a tenth of a micrometre, which is how the
		# rows are written. What is further away goes by.
		var position_mm = number(cells[2])
		if abs(position_mm) < MM:
			tip.translation.x = position_mm / MM
			position_mm = round(tip.global_transform.origin.x * MM * 1e4) / 1e4
		var error = abs(tube.step(position_mm, cells[3] == "1", number(cells[4])) - number(cells[last]))
		if not error <= worst:
			worst = error
	var spent_us = (OS.get_ticks_usec() - begun) / float(rows.size() - 1)
	print("%d steps of checks_tube.csv in Godot %s: at most %.2fe-15 N off, %d us each" % [
		rows.size() - 1, Engine.get_version_info()["string"], worst * 1e15, spent_us])

	# A free hand: strokes of 60 mm in 0.8 s, held for 0.9 s of 1.2 s.
	tube = Tube.new(model, first)
	var largest = 0.0
	for tick in range(2400):
		var along = min((tick % 1200) / 800.0, 1.0)
		tip.translation.x = 0.06 * (floor(tick / 1200.0) + along * along * (3.0 - 2.0 * along))
		largest = max(largest, abs(tube.step(tip.global_transform.origin.x * MM, tick % 1200 < 900, 0.001)))
	print("free hand: %d strokes, depth %.1f mm, largest force %.2f N" % [tube.stroke, tube.depth_mm, largest])
	return worst <= 1e-12 and tube.stroke == 2 and tube.depth_mm > 20.0
