"""The scripted insertions of a bundle, and what every host of this folder proves with them.

    python3 traces.py BUNDLE            through tactus.py alone, without an engine
"""
import csv
import sys

import tactus

FADE_S = 0.05  # of a change of conditions in checks_tube.csv


def traces(bundle):
    """Yields (name, rows); a row is a dict with position_mm, held, dt_s, conditions (a list) and force_n, depth_mm."""
    with open(f"{bundle}/checks_tube.csv", newline="") as file:
        reader = csv.reader(file)
        head = next(reader)
        first, last = 5, head.index("force_n")
        name, rows = None, []
        for cells in reader:
            if name is not None and cells[0] != name:
                yield name, rows
                rows = []
            name = cells[0]
            rows.append({
                "position_mm": float(cells[2]), "held": cells[3] == "1", "dt_s": float(cells[4]),
                "conditions": [float(cell) for cell in cells[first:last]],
                "force_n": float(cells[last]), "depth_mm": float(cells[last + 1]),
            })
        yield name, rows


def prove(bundle, put=lambda position_mm: position_mm):
    """The largest error in newtons over all traces. `put` moves the tip of an engine and gives its position back, mm."""
    model = tactus.Model.open(f"{bundle}/model.tactus.json")
    ids = [name for name in model.input_ids if name not in ("depth", "speed")]
    worst, steps = 0.0, 0
    for _, rows in traces(bundle):
        tube, before = None, None
        for row in rows:
            if row["conditions"] != before:
                scene = model.scene(dict(zip(ids, row["conditions"])))
                if tube is None:
                    tube = tactus.Tube(scene)
                else:
                    tube.scene(scene, FADE_S)
                before = row["conditions"]
            # As the rows are written: to a tenth of a micrometre.
            feel = tube.step(round(put(row["position_mm"]), 4), row["held"], row["dt_s"])
            error = abs(feel.force_n - row["force_n"])
            worst = error if not error <= worst else worst  # NaN counts
            steps += 1
    print(f"{steps} steps of checks_tube.csv: at most {worst} N off")
    return worst


if __name__ == "__main__":
    sys.exit(0 if prove(sys.argv[1]) <= 1e-12 else 1)
