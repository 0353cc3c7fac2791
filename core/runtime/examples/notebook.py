"""A first look at a model in Python, cell by cell (Jupyter, Spyder and VS Code know the lines `# %%`): notebook.py MODEL."""
# %% Load a model
import sys

import tactus

model = tactus.Model.open(sys.argv[1])
print(model.name, "by", ", ".join(model.expert_ids))
for name, unit, (low, high) in zip(model.input_ids, model.input_units, model.input_ranges):
    print(f"  {name}: {low:g} to {high:g} {unit}")

# %% The force at one point: the middle of each input
middle = {name: (low + high) / 2 for name, (low, high) in zip(model.input_ids, model.input_ranges)}
force_n, fired = model.force_and_fired(middle.values())
print(f"in the middle: {force_n:.4f} N" + ("" if fired else " (no rule fires)"))

# %% A curve along the depth: many points in one call
depths_mm = range(0, int(model.input_ranges[model.input_ids.index("depth")][1]) + 1, 25)
points = [[depth_mm if name == "depth" else middle[name] for name in model.input_ids] for depth_mm in depths_mm]
for depth_mm, force_n in zip(depths_mm, model.batch(points)):
    print(f"{depth_mm:5d} mm {force_n:7.4f} N " + "#" * round(60 * force_n / model.output_range[1]))

# %% A scene fixes what does not change; a tube is felt: position in, force out
scene = model.scene({name: value for name, value in middle.items() if name not in ("depth", "speed")})
tube = tactus.Tube(scene)
for tick in range(1001):
    feel = tube.step(position_mm=0.06 * tick, held=True, dt_s=0.001)  # 60 mm in a second
    if tick % 200 == 0:
        print(f"{tick:5d} ms {feel.depth_mm:7.3f} mm {feel.force_n:7.4f} N")
