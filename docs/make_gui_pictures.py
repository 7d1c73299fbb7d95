#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""The user documentation's pictures of the window: make gui-pictures, which runs the window's tests and then this script.

    /usr/bin/python3 docs/make_gui_pictures.py FOLDER    FOLDER/NAME.png -> docs/pictures/gui-NAME.png, smaller and with 256 colours
"""
import sys
from pathlib import Path

from PIL import Image

PICTURES = Path(__file__).resolve().parent / "pictures"
USED = ("panel-preview", "panel-running", "panel-meshed", "panel-failed", "quality", "quality-cut", "quality-worst", "models", "batch",
        "preferences", "needs-refresh", "panel-german")
WIDTH = 1000


def main(folder):
    for name in USED:
        picture = Image.open(Path(folder) / (name + ".png")).convert("RGB")
        if picture.width > WIDTH:
            picture = picture.resize((WIDTH, round(picture.height * WIDTH / picture.width)), Image.LANCZOS)
        picture.quantize(256, dither=Image.NONE).save(PICTURES / ("gui-%s.png" % name), optimize=True)


if __name__ == "__main__":
    main(sys.argv[1])
