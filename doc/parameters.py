#!/usr/bin/python3
"""Write doc/parameters.md from what the program prints of its parameters.

Call:   doc/parameters.py PROGRAM [FILE]
A test compares the page with the program's.
"""

import glob
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
HEAD = """# Every parameter

Made from the program by `doc/parameters.py`. A parameter file has sections and entries,
`subsection Geometry`, `set Lengths = 4, 3, 1`, `end`; on the command line the same is
`--set 'Geometry/Lengths=4, 3, 1'`. An empty default means that there is none: what decides
the problem has to be written. The last column names a shipped file that uses the entry.

"""


def entries(text):
    """Section, entry, default and description, in order."""
    sections, words, is_outside = [], [], False
    for line in text.splitlines()[2:]:
        is_outside = is_outside or line == "# Of several bodies each has a section:"
        line = (line.removeprefix("# ") if is_outside else line).strip()
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):])
        elif line == "end":
            sections.pop()
        elif line.startswith("#"):
            words.append(line[1:].strip())
        elif line.startswith("set "):
            name, _, default = line[len("set "):].partition("=")
            yield "/".join(sections), name.strip(), default.strip(), " ".join(words)
        if not line.startswith("#"):
            words = []


def examples():
    """The shipped file that is first to use each entry, the shortest names first."""
    found = {}
    for name in sorted(glob.glob(os.path.join(ROOT, "parameters", "**", "*.prm"),
                                 recursive=True), key=lambda path: (len(path), path)):
        section = ""
        with open(name, encoding="utf-8") as file:
            for line in map(str.strip, file):
                if line.startswith("subsection "):
                    section = re.sub("^Body .*", "Body NAME", line[len("subsection "):])
                entry = re.match(r"set ([^=]+?)\s*=", line)
                if entry:
                    found.setdefault((section, entry[1]), os.path.relpath(
                        name, os.path.join(ROOT, "parameters")))
    return found


def page(program):
    """The text of the page."""
    printed = subprocess.run([program, "--print-parameters"], capture_output=True,
                             text=True, check=True).stdout
    text, last, used = HEAD, None, examples()
    for section, name, default, words in entries(printed):
        if section != last:
            text += f"## {section}\n\n| entry | default | what it is | used in |\n|---|---|---|---|\n"
            last = section
        example = used.get((section, name), "")
        text += (f"| {name} | {f'`{default}`' if default else ''} | "
                 f"{words.replace('|', '&#124;')} | {example} |\n")
    return re.sub(r"\n## ", "\n\n## ", text)


if __name__ == "__main__":
    target = sys.argv[2] if len(sys.argv) > 2 else os.path.join(ROOT, "doc", "parameters.md")
    made = page(sys.argv[1])
    if "\n## " not in made:
        sys.exit(f"{sys.argv[1]} prints no parameters")
    with open(target, "w", encoding="utf-8") as output:
        output.write(made)
