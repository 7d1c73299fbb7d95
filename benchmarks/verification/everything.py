#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""All of the verification, two programs at a time: benchmarks/verification/everything.py OUT_DIR

freecad_examples.py, freecad_loads.py and run.py; then their tables and plots go into docs/verification.md. Exit code 1 when one of
them says that a figure is not met.
"""
import os
import subprocess
import sys
import threading
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE)]

import arguments  # noqa: E402
import page  # noqa: E402

SCRIPTS = ("freecad_examples.py", "freecad_loads.py", "run.py")  #: the longest first


def main(out):
    started, codes, waiting = time.monotonic(), {}, list(SCRIPTS)

    def lane():
        while waiting:
            script = waiting.pop(0)
            with open(os.path.join(out, script.replace(".py", ".log")), "w") as log:
                codes[script] = subprocess.run(["/usr/bin/python3", str(HERE / script), out], stdout=log, stderr=subprocess.STDOUT,
                                               env=dict(os.environ, OMP_NUM_THREADS="1")).returncode
            print("%-24s %s after %.0f s; %s" % (script, "figures not met" if codes[script] else "all figures met",
                                                 time.monotonic() - started, log.name), flush=True)

    os.makedirs(out, exist_ok=True)
    lanes = [threading.Thread(target=lane) for _ in range(2)]
    for thread in lanes:
        thread.start()
    for thread in lanes:
        thread.join()
    page.write(out)
    used = os.times()
    print("%.0f s, processor time %.0f s" % (time.monotonic() - started, used.children_user + used.children_system))
    return int(len(codes) < len(SCRIPTS) or any(codes.values()))  # a lane that raised leaves no code


if __name__ == "__main__":
    sys.exit(main(arguments.parse(__doc__).out))
