"""The table that `tactus eval` writes, by tactus.py: table.py FOLDER_OF_TACTUS_PY MODEL POINTS.csv OUT.csv BUNDLE."""
import csv
import sys

sys.path.insert(0, sys.argv[1])
sys.dont_write_bytecode = True
import tactus


def number(value):
    """The shortest digits in the form of std::to_chars, which has no '.0' and two digits of an exponent."""
    text = repr(value)
    return text[:-2] if text.endswith(".0") else text


model = tactus.Model.open(sys.argv[2])
with open(sys.argv[3], newline="") as file:
    header, *rows = list(csv.reader(file))
points = [[float(cell) for cell in row] for row in rows]
with open(sys.argv[4], "w") as out:
    print(",".join(header + ["force", "fired"]), file=out)
    for row, point in zip(rows, points):
        force_n, fired = model.force_and_fired(point)
        print(",".join(row + [number(force_n), "1" if fired else "0"]), file=out)

# A batch agrees to 4 ulp; lists and, where it is there, numpy.
forces = model.batch(points)
assert len(forces) == len(points)
for point, force_n in zip(points, forces):
    assert abs(model.force(point) - force_n) <= 4 * 2.0**-52 * max(1.0, abs(force_n)), point
scene = model.scene({"lubrication": 1.0}, neck_flexion=45)
assert scene.force([30.0, 30.0]) == model.force([1, 45, 30, 30])
assert model.clamped([2, 45, 30, -1]) == ["lubrication", "speed"]
assert model.expert_force("S4", [1, 45, 30, 30]) == model.force([1, 45, 30, 30])
tube = tactus.Tube(scene)
tube.place(10)
feel = [tube.step(0.05 * i, True, 0.001) for i in range(400)][-1]
assert feel.phase == 2 and feel.force_n > 0 and feel.stroke == 1, feel
tube.scene(model.scene(lubrication=0.3, neck_flexion=80))
assert tactus.verify(sys.argv[5]) == 0
for wrong in (lambda: tactus.verify("/no/bundle"), lambda: model.force([1, 2]), lambda: model.scene(swallow=1), lambda: tactus.Model.read("{}"),
              lambda: tactus.Tube(model.scene(lubrication=1))):
    try:
        wrong()
    except tactus.Error as error:
        assert str(error)
    else:
        raise AssertionError("no error")
print("with numpy" if tactus.numpy else "SKIPPED: numpy is not here, so tactus.py is tested with lists only")
