"""Handles in Python: what is copied, closed and used afterwards never ends the interpreter.

owned.py FOLDER_OF_TACTUS_PY MODEL
"""
import copy
import gc
import pickle
import sys

sys.path.insert(0, sys.argv[1])
import tactus  # noqa: E402

POINT = [1.0, 45.0, 30.0, 30.0]


def refused(call, kind=tactus.Error):
    try:
        call()
    except kind as error:
        return error
    raise SystemExit(f"not refused: {call}")


def copies():
    model = tactus.Model.open(sys.argv[2])
    force = model.force(POINT)
    scene = model.scene(lubrication=1.0)
    scene_force = scene.force(POINT[1:])
    for copied in (copy.copy, copy.deepcopy):
        other, other_scene = copied(model), copied(scene)
        model.close()
        scene.close()
        gc.collect()
        assert other.force(POINT) == force and other_scene.force(POINT[1:]) == scene_force
        assert other.name == model.name and not other.closed
        model, scene = other, other_scene
    assert copy.deepcopy([model, model])[1].force(POINT) == force


def closing():
    with tactus.Model.open(sys.argv[2]) as model:
        scene = model.scene(lubrication=1.0, neck_flexion=45.0)
        tube = tactus.Tube(scene)
        assert model.name in repr(model) and "closed" not in repr(model)
    model.close()
    assert model.closed and "closed" in repr(model)
    for call in (lambda: model.force(POINT), lambda: model.batch([POINT]), lambda: model.scene(lubrication=1.0),
                 lambda: model.clamped(POINT), lambda: model.expert_force(0, POINT), model.__enter__):
        assert "closed" in str(refused(call)) and refused(call).status == 1
    scene.close()
    refused(lambda: tactus.Tube(scene))
    refused(lambda: scene.force(POINT[2:]))
    assert tube.step(1.0, True, 0.001).phase is not None  # has what it needs
    refused(lambda: copy.copy(tube))
    refused(lambda: copy.deepcopy(tube))
    tube.close()
    refused(lambda: tube.step(1.0, True, 0.001))
    refused(lambda: tube.place(1.0))


def miscounts():
    model = tactus.Model.open(sys.argv[2])
    for wrong in ([], POINT[:3], POINT + [1.0]):
        refused(lambda: model.force(wrong))
        refused(lambda: model.batch([wrong]))
        refused(lambda: model.expert_force(0, wrong))
    for expert in (-1, len(model.expert_ids), 10**30, "nobody"):
        refused(lambda: model.expert_force(expert, POINT))
    refused(lambda: model.expert_force(0.5, POINT), TypeError)
    refused(lambda: pickle.dumps(model), TypeError)
    refused(lambda: tactus.Model.open("no such file"))


copies()
closing()
miscounts()
gc.collect()
print("all of it")
