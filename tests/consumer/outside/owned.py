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
    for copied in (copy.copy, copy.deepcopy):
        other = copied(tube)
        assert other.step(2.0, True, 0.001).force_n == copy.copy(tube).step(2.0, True, 0.001).force_n
        other.close()
        assert tube.step(1.0, True, 0.001).force_n == tube.step(1.0, True, 0.001).force_n
    tube.close()
    refused(lambda: copy.copy(tube))
    refused(tube.save)
    refused(lambda: tube.step(1.0, True, 0.001))
    refused(lambda: tube.place(1.0))


def states():
    model = tactus.Model.open(sys.argv[2])
    tube = tactus.Tube(model.scene(lubrication=1.0, neck_flexion=45.0))
    for i in range(300):
        tube.step(0.05 * i, True, 0.001)
    state = tube.save()
    wanted = [tube.step(15 + 0.05 * i, True, 0.001).force_n for i in range(300)]
    later = tactus.Tube(tactus.Model.open(sys.argv[2]).scene(lubrication=1.0, neck_flexion=45.0))
    later.load(state)
    assert [later.step(15 + 0.05 * i, True, 0.001).force_n for i in range(300)] == wanted
    other = tactus.Tube(model.scene(lubrication=0.5, neck_flexion=45.0))
    for wrong in (b"", state[:-1], state + b"x", b"x" * len(state)):
        refused(lambda: later.load(wrong))
    refused(lambda: other.load(state))
    for wrong in (-1.0, float("nan"), float("inf")):
        refused(lambda: tube.limits(wrong))
        refused(lambda: tube.limits(0, wrong))
    tube.step(0, True, 5.0)
    assert tube.status == 1


def an_older_library():
    """It lacks functions of this module: a sentence, no AttributeError."""
    class Older:
        _name = "libtactus.so.1"

        @staticmethod
        def tactus_interface():
            return 1

    assert "found interface 1" in str(refused(lambda: tactus._declare(Older()), ImportError))


def miscounts():
    model = tactus.Model.open(sys.argv[2])
    for wrong in ([], POINT[:3], POINT + [1.0]):
        refused(lambda: model.force(wrong))
        refused(lambda: model.batch([wrong]))
        refused(lambda: model.expert_force(0, wrong))
    for expert in (-1, len(model.expert_ids), 10**30, "nobody"):
        refused(lambda: model.expert_force(expert, POINT))
        refused(lambda: model.membership(expert, 0, 0, 1.0))
    for which in ((0, 9, 0), (0, "swallow", 0), (0, "depth", "mouth"), (0, 2, -1)):
        refused(lambda: model.membership(*which, 1.0))
    refused(lambda: model.expert_force(0.5, POINT), TypeError)
    refused(lambda: pickle.dumps(model), TypeError)
    refused(lambda: tactus.Model.open("no such file"))


copies()
closing()
states()
an_older_library()
miscounts()
gc.collect()
print("all of it")
