# HexFeatureWB - LGPL-2.1-or-later
"""Run the batch inside freecadcmd, which takes no arguments for a script and hides its exit code:
arguments come as a JSON list in HEXFEATURE_BATCH_ARGUMENTS, and the process ends here with the batch's own code."""
import json
import os
import sys
import traceback

code = 3
try:
    from HexFeatureWB import batch

    code = batch.main(json.loads(os.environ["HEXFEATURE_BATCH_ARGUMENTS"]))
except SystemExit as stop:  # argparse: usage
    code = stop.code if isinstance(stop.code, int) else 2
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
sys.stderr.flush()
os._exit(code)
