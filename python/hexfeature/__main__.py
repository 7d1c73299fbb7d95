# HexFeatureWB - LGPL-2.1-or-later
"""`python -m hexfeature` is the command line."""
import sys


def run():
    """The console script. Ctrl-C is answered even while the modules are being loaded."""
    try:
        from hexfeature.cli import main

        return main(guarded=True)
    except KeyboardInterrupt:
        sys.stderr.write("hexfeature: cancelled\n")
        return 130
    except ImportError as error:
        sys.stderr.write(f"hexfeature: the program is not complete: {error}\n  hint: run 'make build', or install the package again\n")
        return 4


if __name__ == "__main__":
    sys.exit(run())
