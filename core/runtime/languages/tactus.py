"""libtactus for Python: the force of a Tactus model. One file, only ctypes; numpy is used where it is there.

    import tactus
    model = tactus.Model.open("model.tactus.json")
    model.force([1.0, 45.0, 30.0, 30.0])                 # the averaged force, N
    model.batch([[1.0, 45.0, 30.0, 30.0], ...])          # a list, or an array where numpy is there
    scene = model.scene(lubrication=1.0, neck_flexion=45.0)
    tube = tactus.Tube(scene)
    tube.limits(stiffness_max_n_mm=0.2, force_cap_n=1.5) # what loop and device can take
    feel = tube.step(position_mm=12.0, held=True, dt_s=0.001)

    with tactus.Link(token, port) as link:               # of `tactus serve`, or of the workbench
        link.felt(0.001, feel.depth_mm, feel.speed_mm_s, feel.force_n)
        for message in link: ...                         # models that are edited there

What each call does, and which threads may call it: tactus/tactus.h. The library is looked for under TACTUS_LIBRARY, then
in the folder tactus.libs beside this file (a wheel has it there), then where the system looks, then in the prefix that this
file is installed in.
"""
import ctypes
import glob
import hashlib
import json
import operator
import os
import socket

try:
    import numpy
except ImportError:
    numpy = None

INTERFACE = 2
_MESSAGE_BYTES = 1024
_double_p = ctypes.POINTER(ctypes.c_double)


class Error(RuntimeError):
    """One sentence: what, where, what was found, what was wanted."""

    def __init__(self, status, sentence):
        super().__init__(sentence)
        self.status = status


class _Feel(ctypes.Structure):
    _fields_ = [("size", ctypes.c_size_t), ("force_n", ctypes.c_double), ("depth_mm", ctypes.c_double),
                ("speed_mm_s", ctypes.c_double), ("slip_speed_mm_s", ctypes.c_double),
                ("stretch_mm", ctypes.c_double), ("model_force_n", ctypes.c_double), ("phase", ctypes.c_int),
                ("held_last", ctypes.c_int), ("stroke", ctypes.c_uint), ("limited", ctypes.c_int),
                ("region", ctypes.c_int)]


class _Renderer(ctypes.Structure):
    _fields_ = [("size", ctypes.c_size_t)] + [(name, ctypes.c_double) for name in (
        "stiffness_n_mm", "damping_n_s_mm", "breakaway_ratio", "restick_mm", "withdrawal_ratio", "relaxation_s",
        "ageing_s", "stick_speed_mm_s", "stick_time_s", "velocity_filter_hz", "slew_n_s", "depth_offset_mm")]


class _Limits(ctypes.Structure):
    _fields_ = [("size", ctypes.c_size_t), ("stiffness_max_n_mm", ctypes.c_double), ("force_cap_n", ctypes.c_double)]


def _sized(structure):
    return structure(size=ctypes.sizeof(structure))


class _Members:
    """The members of a struct of the library, but its size."""

    __slots__ = ()

    def __init__(self, raw):
        for name in self.__slots__:
            setattr(self, name, getattr(raw, name))

    def __repr__(self):
        members = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.__slots__)
        return f"{type(self).__name__}({members})"


class Feel(_Members):
    """What the hand feels after one step; the names and units of tactus_feel."""

    __slots__ = [name for name, _ in _Feel._fields_ if name != "size"]


class Renderer(_Members):
    """The parameters of the tube; the names and units of tactus_renderer."""

    __slots__ = [name for name, _ in _Renderer._fields_ if name != "size"]


def _places():
    named = os.environ.get("TACTUS_LIBRARY")
    if named:
        return [named]
    folder = os.path.dirname(os.path.abspath(__file__))
    own = os.path.join(folder, "tactus.libs", "tactus.dll" if os.name == "nt" else "libtactus.so.1")
    if os.path.exists(own):
        return [own]
    prefix = os.path.normpath(os.path.join(folder, "..", "..", ".."))
    if os.name == "nt":
        return ["tactus.dll", os.path.join(prefix, "bin", "tactus.dll")]
    below = [("lib*", "libtactus.so.1"), ("lib", "*", "libtactus.so.1")]
    return ["libtactus.so.1"] + [found for names in below for found in sorted(glob.glob(os.path.join(prefix, *names)))]


def _load():
    reasons = []
    for name in _places():
        try:
            return ctypes.CDLL(name)
        except OSError as error:
            reasons.append(str(error))
    raise ImportError("libtactus: " + "; ".join(reasons) + "; set TACTUS_LIBRARY to its path")


def _declare(library):
    handle, size, double, text = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double, ctypes.c_char_p
    handle_p, int_p = ctypes.POINTER(handle), ctypes.POINTER(ctypes.c_int)
    message = [text, size]
    functions = {
        "tactus_version": (text, []),
        "tactus_model_open": (ctypes.c_int, [text, handle_p] + message),
        "tactus_model_read": (ctypes.c_int, [text, size, handle_p] + message),
        "tactus_model_free": (None, [handle]),
        "tactus_model_name": (text, [handle]),
        "tactus_model_inputs": (size, [handle]),
        "tactus_model_input_id": (text, [handle, size]),
        "tactus_model_sha256": (text, [handle]),
        "tactus_model_input_label": (text, [handle, size]),
        "tactus_model_input_unit": (text, [handle, size]),
        "tactus_model_input_role": (text, [handle, size]),
        "tactus_model_input_terms": (size, [handle, size]),
        "tactus_model_term_id": (text, [handle, size, size]),
        "tactus_model_term_label": (text, [handle, size, size]),
        "tactus_model_membership": (double, [handle, size, size, size, double]),
        "tactus_model_renderer": (None, [handle, ctypes.POINTER(_Renderer)]),
        "tactus_model_input_min": (double, [handle, size]),
        "tactus_model_input_max": (double, [handle, size]),
        "tactus_model_output_min": (double, [handle]),
        "tactus_model_output_max": (double, [handle]),
        "tactus_model_experts": (size, [handle]),
        "tactus_model_expert_id": (text, [handle, size]),
        "tactus_model_expert_label": (text, [handle, size]),
        "tactus_model_expert_weight": (double, [handle, size]),
        "tactus_force": (double, [handle, _double_p, int_p]),
        "tactus_expert_force": (double, [handle, size, _double_p, int_p]),
        "tactus_force_batch": (None, [handle, _double_p, size, _double_p, ctypes.c_void_p]),
        "tactus_clamped": (ctypes.c_int, [handle, _double_p]),
        "tactus_clamped_inputs": (ctypes.c_uint, [handle, _double_p]),
        "tactus_scene_make": (ctypes.c_int, [handle, ctypes.POINTER(size), _double_p, size, handle_p] + message),
        "tactus_scene_free": (None, [handle]),
        "tactus_scene_inputs": (size, [handle]),
        "tactus_scene_force": (double, [handle, _double_p, int_p]),
        "tactus_scene_force_batch": (None, [handle, _double_p, size, _double_p, ctypes.c_void_p]),
        "tactus_tube_make": (ctypes.c_int, [handle, handle_p] + message),
        "tactus_tube_free": (None, [handle]),
        "tactus_tube_place": (None, [handle, double]),
        "tactus_tube_scene": (None, [handle, handle, double]),
        "tactus_tube_limits": (ctypes.c_int, [handle, ctypes.POINTER(_Limits)]),
        "tactus_tube_copy": (ctypes.c_int, [handle, handle_p]),
        "tactus_tube_save": (size, [handle, ctypes.c_void_p, size]),
        "tactus_tube_load": (ctypes.c_int, [handle, ctypes.c_char_p, size]),
        "tactus_verify": (ctypes.c_int, [text, _double_p] + message),
        "tactus_tube_step": (ctypes.c_int, [handle, double, ctypes.c_int, double, ctypes.POINTER(_Feel)]),
    }
    # First, because an older library lacks the others.
    if library.tactus_interface() < INTERFACE:
        raise ImportError(f"libtactus: found interface {library.tactus_interface()} in {library._name}, "
                          f"wanted {INTERFACE} or later: this tactus.py is newer than the library")
    for name, (result, arguments) in functions.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


_lib = _declare(_load())


def version():
    return _lib.tactus_version().decode()


def verify(bundle_folder):
    """Reads a bundle again; the largest error of the forces that it could evaluate, N. An Error where it is not as promised."""
    error_n, message = ctypes.c_double(), ctypes.create_string_buffer(_MESSAGE_BYTES)
    status = _lib.tactus_verify(os.fsencode(bundle_folder), ctypes.byref(error_n), message, _MESSAGE_BYTES)
    if status != 0:
        raise Error(status, message.value.decode("utf-8", "replace"))
    return error_n.value


def _made(call, *arguments):
    """Runs a call that makes a handle; returns the handle and the warning."""
    handle, message = ctypes.c_void_p(), ctypes.create_string_buffer(_MESSAGE_BYTES)
    status = call(*arguments, ctypes.byref(handle), message, _MESSAGE_BYTES)
    sentence = message.value.decode("utf-8", "replace")
    if status != 0:
        raise Error(status, sentence)
    return handle, sentence


def _point(inputs, count):
    values = [float(value) for value in inputs]
    if len(values) != count:
        raise Error(1, f"inputs: found {len(values)} values, wanted {count}")
    return (ctypes.c_double * count)(*values)


def _index(what, found, ids):
    """The place of an id, or of an index, in `ids`."""
    if isinstance(found, str):
        if found not in ids:
            raise Error(1, f"{what}: found '{found}', wanted one of {', '.join(ids)}")
        return ids.index(found)
    index = operator.index(found)
    if not 0 <= index < len(ids):
        raise Error(1, f"{what}: found {index}, wanted 0 to {len(ids) - 1}")
    return index


def _points(points, count):
    """The points as one block of doubles, their number, and what keeps the block alive."""
    if numpy is not None:
        block = numpy.ascontiguousarray(points, dtype=numpy.float64)
        if block.ndim != 2 or block.shape[1] != count:
            raise Error(1, f"points: found an array of shape {block.shape}, wanted (points, {count})")
        return block.ctypes.data_as(_double_p), block.shape[0], block
    rows = [_point(row, count) for row in points]
    block = (ctypes.c_double * (count * len(rows)))(*[value for row in rows for value in row])
    return block, len(rows), block


class _Owner:
    """Frees a handle once nobody has it any more."""

    def __init__(self, handle, free):
        self.handle, self._free = handle, free

    def __del__(self):
        if self.handle and _lib is not None:
            self._free(self.handle)
            self.handle = None


class _Owned:
    """What has a handle of the library: closed by hand, by `with`, or when nobody has it any more."""

    _owner = None

    @property
    def _handle(self):
        if self._owner is None:
            name = type(self).__name__.lower()
            raise Error(1, f"{name}: found one that is closed, wanted one that is open")
        return self._owner.handle

    @property
    def closed(self):
        return self._owner is None

    def close(self):
        """Every later call is an Error. Copies stay open; closing twice does nothing."""
        self._owner = None

    def __enter__(self):
        self._handle
        return self

    def __exit__(self, *_):
        self.close()

    def __reduce_ex__(self, _protocol):
        raise TypeError(f"a {type(self).__name__} of tactus cannot be pickled: open the model file there")


class _Evaluator(_Owned):
    """What models and scenes share. Neither ever changes, so a copy has the same handle."""

    def __copy__(self):
        copied = object.__new__(type(self))
        copied.__dict__.update(self.__dict__)
        return copied

    def __deepcopy__(self, _known):
        return self.__copy__()

    def force(self, inputs):
        """The force at one point, N."""
        return self.force_and_fired(inputs)[0]

    def force_and_fired(self, inputs):
        fired = ctypes.c_int()
        force_n = type(self)._force(self._handle, _point(inputs, self.inputs), ctypes.byref(fired))
        return force_n, fired.value != 0

    def batch(self, points):
        """The forces at many points, N: an array where numpy is there, else a list."""
        return self.batch_and_fired(points)[0]

    def batch_and_fired(self, points):
        block, count, _alive = _points(points, self.inputs)
        force_n, fired = (ctypes.c_double * count)(), (ctypes.c_ubyte * count)()
        type(self)._batch(self._handle, block, count, force_n, fired)
        if numpy is not None:
            return numpy.array(force_n, dtype=numpy.float64), numpy.array(fired, dtype=bool)
        return list(force_n), [one != 0 for one in fired]


class Scene(_Evaluator):
    """A model with some inputs fixed; made by Model.scene."""

    _free, _force, _batch = _lib.tactus_scene_free, _lib.tactus_scene_force, _lib.tactus_scene_force_batch

    def __init__(self, handle, warning):
        self._owner, self.warning = _Owner(handle, self._free), warning
        self.inputs = _lib.tactus_scene_inputs(handle)

    def __repr__(self):
        return f"<tactus.Scene: {self.inputs} inputs{', closed' if self.closed else ''}>"


class Model(_Evaluator):
    """A model file in memory."""

    _free, _force, _batch = _lib.tactus_model_free, _lib.tactus_force, _lib.tactus_force_batch

    def __init__(self, handle, warning):
        self._owner, self.warning = _Owner(handle, self._free), warning
        self.name = _lib.tactus_model_name(handle).decode()
        self.sha256 = _lib.tactus_model_sha256(handle).decode()
        self.inputs = _lib.tactus_model_inputs(handle)
        every = range(self.inputs)
        self.input_ids = [_lib.tactus_model_input_id(handle, i).decode() for i in every]
        self.input_labels = [_lib.tactus_model_input_label(handle, i).decode() for i in every]
        self.input_units = [_lib.tactus_model_input_unit(handle, i).decode() for i in every]
        self.input_roles = [_lib.tactus_model_input_role(handle, i).decode() for i in every]
        self.input_ranges = [(_lib.tactus_model_input_min(handle, i), _lib.tactus_model_input_max(handle, i))
                             for i in every]
        terms = [range(_lib.tactus_model_input_terms(handle, i)) for i in every]
        self.term_ids = [[_lib.tactus_model_term_id(handle, i, t).decode() for t in terms[i]] for i in every]
        self.term_labels = [[_lib.tactus_model_term_label(handle, i, t).decode() for t in terms[i]] for i in every]
        self.output_range = (_lib.tactus_model_output_min(handle), _lib.tactus_model_output_max(handle))
        experts = range(_lib.tactus_model_experts(handle))
        self.expert_ids = [_lib.tactus_model_expert_id(handle, i).decode() for i in experts]
        self.expert_labels = [_lib.tactus_model_expert_label(handle, i).decode() for i in experts]
        self.expert_weights = [_lib.tactus_model_expert_weight(handle, i) for i in experts]

    def __repr__(self):
        return f"<tactus.Model {self.name!r}: {', '.join(self.input_ids)}{', closed' if self.closed else ''}>"

    @classmethod
    def open(cls, path):
        return cls(*_made(_lib.tactus_model_open, os.fsencode(path)))

    @classmethod
    def read(cls, text):
        data = text.encode() if isinstance(text, str) else bytes(text)
        return cls(*_made(_lib.tactus_model_read, data, len(data)))

    def expert_force(self, expert, inputs):
        """The force of one expert, by id or by index."""
        index = _index("expert", expert, self.expert_ids)
        return _lib.tactus_expert_force(self._handle, index, _point(inputs, self.inputs), None)

    def membership(self, expert, input, term, x):
        """The membership, 0 to 1, of the value x in a term of an input, as the expert's rules take it; ids or indices."""
        index = _index("input", input, self.input_ids)
        words = (_index("expert", expert, self.expert_ids), index, _index("term", term, self.term_ids[index]))
        return _lib.tactus_model_membership(self._handle, *words, x)

    @property
    def renderer(self):
        """The parameters of the tube."""
        raw = _sized(_Renderer)
        _lib.tactus_model_renderer(self._handle, ctypes.byref(raw))
        return Renderer(raw)

    def clamped(self, inputs):
        """Whether an input is outside its universe."""
        return _lib.tactus_clamped(self._handle, _point(inputs, self.inputs)) != 0

    def clamped_inputs(self, inputs):
        """The ids of the inputs that are."""
        bits = _lib.tactus_clamped_inputs(self._handle, _point(inputs, self.inputs))
        return [name for i, name in enumerate(self.input_ids) if bits >> i & 1]

    def scene(self, fixed=None, **more):
        """The model with some inputs fixed: scene({"lubrication": 1.0}) or scene(lubrication=1.0)."""
        values = {**(fixed or {}), **more}
        for name in values:
            if name not in self.input_ids:
                raise Error(1, f"scene: found the input '{name}', wanted one of {', '.join(self.input_ids)}")
        indices = (ctypes.c_size_t * len(values))(*[self.input_ids.index(name) for name in values])
        numbers = (ctypes.c_double * len(values))(*values.values())
        return Scene(*_made(_lib.tactus_scene_make, self._handle, indices, numbers, len(values)))


class Tube(_Owned):
    """One insertion: position in, force out. It has a state; a copy goes its own way from there."""

    def __init__(self, scene):
        self._take(_made(_lib.tactus_tube_make, scene._handle)[0])

    def _take(self, handle):
        self._owner = _Owner(handle, _lib.tactus_tube_free)
        self._raw = _sized(_Feel)
        self.status = 0

    def __copy__(self):
        handle, copied = ctypes.c_void_p(), object.__new__(type(self))
        status = _lib.tactus_tube_copy(self._handle, ctypes.byref(handle))
        if status != 0:
            raise Error(status, "copy: found too little memory for another tube")
        copied._take(handle)
        return copied

    def __deepcopy__(self, _known):
        return self.__copy__()

    def __repr__(self):
        return f"<tactus.Tube{': closed' if self.closed else ''}>"

    def place(self, depth_mm):
        """A new placement at this depth, or at the end of the model's."""
        _lib.tactus_tube_place(self._handle, depth_mm)

    def scene(self, scene, fade_s=0.05):
        """Feels another scene, without a kick."""
        _lib.tactus_tube_scene(self._handle, scene._handle, fade_s)

    def limits(self, stiffness_max_n_mm=0.0, force_cap_n=0.0):
        """The largest stiffness and force to render; 0: none but the model's stiffness and the usual cap of 2 N."""
        limits = _sized(_Limits)
        limits.stiffness_max_n_mm, limits.force_cap_n = stiffness_max_n_mm, force_cap_n
        status = _lib.tactus_tube_limits(self._handle, ctypes.byref(limits))
        if status != 0:
            raise Error(status, f"limits: found {stiffness_max_n_mm} N/mm and {force_cap_n} N, wanted finite numbers from 0 on")

    def step(self, position_mm, held, dt_s):
        """One step; a position or a time out of range lets the tube go (phase 0), and `status` of the tube is then not 0."""
        self.status = _lib.tactus_tube_step(self._handle, position_mm, 1 if held else 0, dt_s, ctypes.byref(self._raw))
        return Feel(self._raw)

    def save(self):
        """The state as bytes, for `load`."""
        size = _lib.tactus_tube_save(self._handle, None, 0)
        room = ctypes.create_string_buffer(size)
        _lib.tactus_tube_save(self._handle, room, size)
        return room.raw

    def load(self, state):
        """Takes the state of a tube of the same model and the same fixed inputs: its next steps, bit by bit."""
        state = bytes(state)
        status = _lib.tactus_tube_load(self._handle, state, len(state))
        if status != 0:
            raise Error(status, "load: found bytes of another scene, model or version, or altered ones, wanted those of a save")


class Link:
    """A connection to the live link. Iterate over it for the messages of the server: one dictionary with one key each.

    The token is the first line of the token file that the server names. One thread at a time. An Error where the server
    refuses a line, or is no Tactus; an OSError where there is no connection.
    """

    def __init__(self, token, port=None, socket_path=None, want=("model",), state_hz=100, name="tactus.py"):
        if socket_path:
            self._socket = socket.socket(socket.AF_UNIX)
            self._socket.connect(socket_path)
        else:
            self._socket = socket.create_connection(("127.0.0.1", port))
        self._lines = self._socket.makefile("r", encoding="utf-8", newline="\n")
        self._asked = 0
        self._waiting = []
        self._send({"hello": "tactus-link", "version": 1, "token": token, "name": name, "want": list(want),
                    "state_hz": state_hz})
        hello = self._next()
        if hello is None or hello.get("hello") != "tactus-link":
            raise Error(1, "found another program there, wanted a Tactus that serves")
        self.program = hello["program"]

    def close(self):
        self._lines.close()
        self._socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __iter__(self):
        return self

    def __next__(self):
        message = self._waiting.pop(0) if self._waiting else self._next()
        if message is None:
            raise StopIteration
        return message

    def force(self, inputs):
        """The force in N at a point, and whether a rule fires. Other messages that come meanwhile are kept."""
        self._asked += 1
        self._send({"ask": {"id": self._asked, "inputs": [float(value) for value in inputs]}})
        while True:
            message = self._next()
            if message is None:
                raise Error(1, "the connection has ended")
            if "answer" in message and message["answer"]["id"] == self._asked:
                return message["answer"]["force_n"], message["answer"]["fired"]
            self._waiting.append(message)

    def felt(self, time_s, depth_mm, speed_mm_s, force_n, conditions=None):
        """Says where this simulator is: depth as the model counts it; conditions by id, as far as they are known."""
        self._send({"felt": {"time_s": float(time_s), "depth_mm": float(depth_mm), "speed_mm_s": float(speed_mm_s),
                             "force_n": float(force_n),
                             "conditions": {name: float(value) for name, value in (conditions or {}).items()}}})

    def _send(self, message):
        try:
            text = json.dumps(message, allow_nan=False)
        except ValueError:
            raise Error(1, "found a number that is not finite, wanted finite ones") from None
        self._socket.sendall(text.encode() + b"\n")

    def _next(self):
        try:
            line = self._lines.readline()
            message = json.loads(line) if line else None
        except ValueError:
            message = ()
        if message is None:
            return None
        if not isinstance(message, dict):
            raise Error(1, "found a line that is no JSON object, wanted a Tactus that serves")
        if "error" in message:
            raise Error(1, message["error"])
        if "model" in message:
            # `file` is the last member: what was sent is what arrived.
            sent = line[line.index('"file":') + 7:].rstrip("\n")[:-2]
            if hashlib.sha256(sent.encode()).hexdigest() != message["model"]["sent_sha256"]:
                raise Error(1, "a model arrived altered")
        return message
