"""Follows the live link of Tactus with the standard library alone: models, states, and forces at points.

  python3 live_link.py --port P --token-file FILE                      prints a line for each model
  python3 live_link.py --port P --token-file FILE --states 50          and 50 states a second while the model is felt
  python3 live_link.py --port P --token-file FILE --ask 1,45,130,50    the force at a point, then the end

The server is `tactus serve MODEL`, or the workbench: Feel, "Serve to a simulator". The protocol: docs/live-link.md.
"""
import argparse
import hashlib
import json
import socket
import sys


class LinkError(Exception):
    """What the server says before it ends the connection."""


class LiveLink:
    """A connection. Iterate over it for the messages of the server: one dictionary with one key each."""

    def __init__(self, token, port=None, socket_path=None, want=("model",), state_hz=100, name="live_link.py"):
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
            raise LinkError("found another program there, wanted a Tactus that serves")
        self.program = hello["program"]

    def close(self):
        self._lines.close()
        self._socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *unused):
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
                raise LinkError("the connection has ended")
            if "answer" in message and message["answer"]["id"] == self._asked:
                return message["answer"]["force_n"], message["answer"]["fired"]
            self._waiting.append(message)

    def _send(self, message):
        self._socket.sendall(json.dumps(message).encode() + b"\n")

    def _next(self):
        try:
            line = self._lines.readline()
            message = json.loads(line) if line else None
        except ValueError:
            message = ()
        if message is None:
            return None
        if not isinstance(message, dict):
            raise LinkError("found a line that is no JSON object, wanted a Tactus that serves")
        if "error" in message:
            raise LinkError(message["error"])
        if "model" in message:
            # `file` is the last member: what was sent is what arrived.
            sent = line[line.index('"file":') + 7:].rstrip("\n")[:-2]
            if hashlib.sha256(sent.encode()).hexdigest() != message["model"]["sent_sha256"]:
                raise LinkError("a model arrived altered")
        return message


def _point(text):
    try:
        return [float(value) for value in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"found '{text}', wanted numbers with decimal points, and commas between them") from None


def main():
    parser = argparse.ArgumentParser(description="Follows the live link of Tactus.")
    parser.add_argument("--port", type=int)
    parser.add_argument("--socket")
    parser.add_argument("--token-file", required=True)
    parser.add_argument("--states", type=float, help="states a second")
    parser.add_argument("--ask", type=_point, help="values of the inputs, with commas")
    options = parser.parse_args()
    with open(options.token_file, encoding="ascii") as file:
        token = file.readline().strip()
    want = [] if options.ask else ["model", "state"] if options.states else ["model"]
    with LiveLink(token, options.port, options.socket, want, options.states or 100) as link:
        if options.ask:
            force_n, fired = link.force(options.ask)
            print(f"{force_n!r} N" + ("" if fired else " (no rule fires: the model's default)"))
            return
        for message in link:
            if "model" in message:
                model = message["model"]
                print(f"model {model['serial']}: {model['file']['name']}, sha256 {model['sha256']}", flush=True)
            elif "state" in message:
                state = message["state"]
                print(f"{state['time_s']:.3f} s, {state['depth_mm']:.2f} mm, {state['force_n']:.3f} N"
                      + (" (simulated)" if state["simulated"] else ""), flush=True)


if __name__ == "__main__":
    try:
        main()
    except (LinkError, OSError) as error:
        sys.exit(str(error))
    except KeyboardInterrupt:
        pass
