#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Write the table of options in docs/command-line.md from the program's own list: /usr/bin/python3 docs/make_option_table.py"""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "python"))
PAGE = HERE / "command-line.md"
BETWEEN = re.compile(r"(<!-- options -->\n).*?(<!-- end of options -->)", re.DOTALL)


def table():
    """The table as Markdown."""
    import hexfeature

    lines = ["| option | default | meaning |", "|---|---|---|"]
    for o in hexfeature.options():
        flag = "--" + o.name.replace("_", "-")
        if o.type == "bool":
            flag, default = f"{flag}, --no-{flag[2:]}", "yes" if o.default else "no"
        else:
            default = "chosen" if o.name == "size" else "" if o.default == "" else f"{o.default:g}" if o.type == "float" else str(o.default)
        choices = ": " + ", ".join(c for c in o.choices if c) if o.choices else ""
        lines.append(f"| `{flag}` | {default} | {o.help}{choices} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(BETWEEN.sub(lambda m: m[1] + table() + m[2], PAGE.read_text(encoding="utf-8")), encoding="utf-8")
