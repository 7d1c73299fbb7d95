# HexFeatureWB - LGPL-2.1-or-later
"""The arguments of the verification's scripts."""
import argparse


def parse(description, names=None):
    """OUT_DIR, and the `names` of what is done, where a script asks for them."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", metavar="OUT_DIR", nargs="?", default="out/verification")
    if names:
        parser.add_argument("names", metavar=names, nargs="*")
    return parser.parse_args()
