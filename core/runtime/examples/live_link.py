"""Follows the live link of Tactus with tactus.Link: models, states, and forces at points.

  python3 live_link.py --port P --token-file FILE                      prints a line for each model
  python3 live_link.py --port P --token-file FILE --states 50          and 50 states a second while the model is felt
  python3 live_link.py --port P --token-file FILE --others             and where other simulators are
  python3 live_link.py --port P --token-file FILE --ask 1,45,130,50    the force at a point, then the end
  python3 live_link.py --port P --token-file FILE --push MODEL         a tube that is pushed 300 mm tells where it is

The server is `tactus serve MODEL`, or the workbench: Feel, "Serve to a simulator". The protocol: docs/live-link.md.
"""
import argparse
import os
import sys
import time

try:
    import tactus
except ImportError:
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "languages"))
    import tactus


def _point(text):
    try:
        return [float(value) for value in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"found '{text}', wanted numbers with decimal points, and commas between them") from None


def push(link, path):
    """A hand of 60 mm/s for five seconds; every 10 ms the link is told where the tube is."""
    model = tactus.Model.open(path)
    conditions = {name: (low + high) / 2 for name, (low, high) in zip(model.input_ids, model.input_ranges)
                  if name not in ("depth", "speed")}
    tube = tactus.Tube(model.scene(conditions))
    offset_mm = model.renderer.depth_offset_mm
    for tick in range(5000):
        feel = tube.step(0.06 * tick, True, 0.001)
        if tick % 10 == 9:
            link.felt(0.001 * tick, feel.depth_mm + offset_mm, feel.speed_mm_s, feel.force_n, conditions)
            time.sleep(0.01)
    print(f"{feel.force_n:.3f} N at {feel.depth_mm + offset_mm:.1f} mm")


def main():
    parser = argparse.ArgumentParser(description="Follows the live link of Tactus.")
    parser.add_argument("--port", type=int)
    parser.add_argument("--socket")
    parser.add_argument("--token-file", required=True)
    parser.add_argument("--states", type=float, help="states a second")
    parser.add_argument("--others", action="store_true", help="where other simulators are")
    parser.add_argument("--ask", type=_point, help="values of the inputs, with commas")
    parser.add_argument("--push", metavar="MODEL", help="a model file, whose tube is pushed")
    options = parser.parse_args()
    with open(options.token_file, encoding="ascii") as file:
        token = file.readline().strip()
    want = [] if options.ask or options.push else ["model"]
    want += ["state"] if options.states else []
    want += ["felt"] if options.others else []
    with tactus.Link(token, options.port, options.socket, want, options.states or 100, "live_link.py") as link:
        if options.ask:
            force_n, fired = link.force(options.ask)
            print(f"{force_n!r} N" + ("" if fired else " (no rule fires: the model's default)"))
            return
        if options.push:
            return push(link, options.push)
        for message in link:
            if "model" in message:
                model = message["model"]
                print(f"model {model['serial']}: {model['file']['name']}, sha256 {model['sha256']}", flush=True)
            elif "state" in message:
                state = message["state"]
                print(f"{state['time_s']:.3f} s, {state['depth_mm']:.2f} mm, {state['force_n']:.3f} N"
                      + (" (simulated)" if state["simulated"] else ""), flush=True)
            elif "felt" in message:
                felt = message["felt"]
                print(f"{felt['name']}: {felt['depth_mm']:.2f} mm, {felt['force_n']:.3f} N", flush=True)


if __name__ == "__main__":
    try:
        main()
    except (tactus.Error, OSError) as error:
        sys.exit(str(error))
    except KeyboardInterrupt:
        pass
