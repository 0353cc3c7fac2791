"""The two tables of table.c by tactus.py: table.py FOLDER_OF_TACTUS_PY MODEL POINTS.csv OUT.csv ALL."""
import array
import csv
import sys

sys.path.insert(0, sys.argv[1])
sys.dont_write_bytecode = True
import tactus

GROUP = 1000  # points of one scene
FIXED = 2  # inputs that it fixes


def number(value):
    """The shortest digits in the form of std::to_chars, which has no '.0' and two digits of an exponent."""
    text = repr(value)
    return text[:-2] if text.endswith(".0") else text


model = tactus.Model.open(sys.argv[2])
with open(sys.argv[3], newline="") as file:
    header, *rows = list(csv.reader(file))
points = [[float(cell) for cell in row] for row in rows]
found = [model.force_and_fired(point) for point in points]
with open(sys.argv[4], "w") as out:
    print(",".join(header + ["force", "fired"]), file=out)
    for row, (force_n, fired) in zip(rows, found):
        print(",".join(row + [number(force_n), "1" if fired else "0"]), file=out)

batch, batch_fired = model.batch_and_fired(points)
assert list(batch_fired) == [fired for _, fired in found]
last = len(model.expert_ids) - 1
everything = array.array("d")
for first in range(0, len(points), GROUP):
    group = points[first:first + GROUP]
    scene = model.scene(dict(zip(model.input_ids[:FIXED], group[0])))
    free = [point[FIXED:] for point in group]
    scene_batch = scene.batch(free)
    for i, point in enumerate(group):
        force_n, fired = found[first + i]
        everything.extend(point)
        everything.extend([force_n, fired, model.expert_force(last, point), batch[first + i], scene.force(free[i]), scene_batch[i]])
with open(sys.argv[5], "wb") as out:
    everything.tofile(out)
