"""What tactus.py offers beside forces, on the model of S4: uses.py FOLDER_OF_TACTUS_PY MODEL BUNDLE."""
import hashlib
import sys

sys.path.insert(0, sys.argv[1])
sys.dont_write_bytecode = True
import tactus

model = tactus.Model.open(sys.argv[2])
scene = model.scene({"lubrication": 1.0}, neck_flexion=45)
assert scene.force([30.0, 30.0]) == model.force([1, 45, 30, 30])
assert model.clamped([2, 45, 30, -1]) and not model.clamped([1, 45, 30, 30])
assert model.clamped_inputs([2, 45, 30, -1]) == ["lubrication", "speed"]
assert model.sha256 == hashlib.sha256(open(sys.argv[2], "rb").read()).hexdigest()
assert model.input_labels[0] == "Tube lubrication" and model.term_ids[0] == ["poor", "medium", "well"]
# The trapezoid of `poor` falls from 0.2 to 0.4.
assert abs(model.membership("S4", "lubrication", "poor", 0.25) - 0.75) < 1e-15 and model.membership(0, 0, 2, 0.25) == 0
assert 0 < model.renderer.stiffness_n_mm <= 10, model.renderer
assert model.expert_force("S4", [1, 45, 30, 30]) == model.force([1, 45, 30, 30])
tube = tactus.Tube(scene)
tube.place(10)
feel = [tube.step(0.05 * i, True, 0.001) for i in range(400)][-1]
assert feel.phase == 2 and feel.force_n > 0 and feel.stroke == 1, feel
assert model.term_ids[2][feel.region] == "nasal_cavity" and feel.limited == 0, feel
tube.limits(stiffness_max_n_mm=0.1)
assert tube.step(20, True, 0.001).limited == 1
tube.scene(model.scene(lubrication=0.3, neck_flexion=80))
assert tactus.verify(sys.argv[3]) == 0
for wrong in (lambda: tactus.verify("/no/bundle"), lambda: model.force([1, 2]), lambda: model.scene(swallow=1), lambda: tactus.Model.read("{}"),
              lambda: tactus.Tube(model.scene(lubrication=1))):
    try:
        wrong()
    except tactus.Error as error:
        assert str(error)
    else:
        raise AssertionError("no error")
print("with numpy" if tactus.numpy else "SKIPPED: numpy is not here, so tactus.py is tested with lists only")
