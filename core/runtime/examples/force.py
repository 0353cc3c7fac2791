"""The averaged force of a model at one point: python3 force.py MODEL VALUE..., one value for each input."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "languages"))
import tactus

if len(sys.argv) < 2:
    sys.exit("usage: force.py MODEL VALUE...")
try:
    inputs = [float(value) for value in sys.argv[2:]]
except ValueError:
    sys.exit(f"found {' '.join(sys.argv[2:])}, wanted numbers with a decimal point")
try:
    model = tactus.Model.open(sys.argv[1])
    force_n, fired = model.force_and_fired(inputs)
except tactus.Error as error:
    sys.exit(str(error))
print(f"{force_n!r} N" + ("" if fired else " (no rule fires: the model's default)"))
